#pragma once

#include <cstddef>
#include <string_view>

namespace tramline::io {

/// The longest prefix of at most `bytes` bytes that does not split a character.
constexpr std::string_view utf8_prefix(std::string_view text, std::size_t bytes) {
  if (text.size() <= bytes) return text;
  while (bytes > 0 && (static_cast<unsigned char>(text[bytes]) & 0xC0) == 0x80) --bytes;
  return text.substr(0, bytes);
}

}  // namespace tramline::io
