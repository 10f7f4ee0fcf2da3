#include "tramline/io/log/section_text.h"

#include <array>
#include <charconv>
#include <cstdint>

#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

constexpr std::size_t kCondensedSections = 16;

std::optional<std::uint32_t> bits_in(std::string_view text) {
  bool hexadecimal = text.find_first_of("abcdefABCDEF") != std::string_view::npos;
  if (text.starts_with("0x") || text.starts_with("0X")) {
    text.remove_prefix(2);
    hexadecimal = true;
  }
  // Some write the number as the signed value it is in the log.
  if (text.starts_with('-')) {
    std::int32_t value = 0;
    const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
    return static_cast<std::uint32_t>(value);
  }
  std::uint32_t value = 0;
  const auto [stop, error] =
      std::from_chars(text.data(), text.data() + text.size(), value, hexadecimal ? 16 : 10);
  if (text.empty() || error != std::errc() || stop != text.data() + text.size()) return std::nullopt;
  return value;
}

}  // namespace

std::optional<SectionText> section_signs(std::string_view text, SectionOrder order) {
  text = trimmed(text);
  if (text.empty() || text.size() > kMostSections) return std::nullopt;
  SectionText out;
  out.count = text.size();
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char sign = text[order == SectionOrder::kFromRight ? text.size() - 1 - i : i];
    if (sign == '0' || sign == '1') {
      out.known = true;
      out.states[i] = sign == '1';
    } else if (sign != '-' && sign != '?' && sign != ' ') {
      return std::nullopt;
    }
  }
  return out;
}

std::optional<SectionText> condensed_sections(std::string_view text) {
  text = trimmed(text);
  std::array<unsigned, kCondensedSections> values{};
  if (text.size() == kCondensedSections && text.find_first_not_of("0123") == std::string_view::npos) {
    for (std::size_t i = 0; i < kCondensedSections; ++i) values[i] = static_cast<unsigned>(text[i] - '0');
  } else {
    const auto bits = bits_in(text);
    if (!bits) return std::nullopt;
    for (std::size_t i = 0; i < kCondensedSections; ++i) values[i] = *bits >> (2 * i) & 3U;
  }
  SectionText out;
  out.known = true;
  std::size_t installed = 0;
  for (std::size_t i = 0; i < kCondensedSections; ++i) {
    out.states[i] = values[i] == 1;
    if (values[i] != 3) installed = i + 1;
  }
  if (installed < kCondensedSections) out.count = installed;
  return out;
}

}  // namespace tramline::io
