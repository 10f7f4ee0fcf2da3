#include "tramline/io/plan/exact_path.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/plan/path_text.h"

namespace tramline::io {
namespace {

constexpr const char *kPlain = "metres", *kGeodetic = "tmerc", *kWithin = "within";

/// Words parted by one space.
std::vector<std::string> words_of(const std::string& text) {
  std::vector<std::string> out(1);
  for (const char c : text)
    if (c == ' ')
      out.emplace_back();
    else
      out.back() += c;
  return out;
}

std::optional<double> number_of(const std::string& word) {
  double value = 0;
  const char* const last = word.data() + word.size();
  const auto [end, error] = std::from_chars(word.data(), last, value);
  if (error != std::errc{} || end != last || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// What stands before the colon; without a path yet.
std::optional<ExactPath> head_of(const std::string& text) {
  std::vector<std::string> words = words_of(text);
  ExactPath out;
  if (words.front() == kGeodetic && words.size() == 5) {
    const std::optional<double> lon = number_of(words[1]), lat = number_of(words[2]);
    if (!lon || !lat || std::abs(*lon) > 180 || std::abs(*lat) > 90) return std::nullopt;
    out.frame.geodetic = true;
    out.frame.origin_lon_deg = *lon;
    out.frame.origin_lat_deg = *lat;
    words.erase(words.begin() + 1, words.begin() + 3);
  } else if (words.front() != kPlain) {
    return std::nullopt;
  }
  if (words.size() != 3 || words[1] != kWithin) return std::nullopt;
  const std::optional<double> within_m = number_of(words[2]);
  if (!within_m || *within_m < 0) return std::nullopt;
  out.within_m = *within_m;
  return out;
}

}  // namespace

std::string exact_path_text(const LocalFrame& frame, double within_m, const std::string& path_text) {
  const std::string plane =
      frame.geodetic ? fmt::format("{} {} {}", kGeodetic, frame.origin_lon_deg, frame.origin_lat_deg)
                     : kPlain;
  return fmt::format("{} {} {}: {}", plane, kWithin, within_m, path_text);
}

std::optional<ExactPath> exact_path_from_text(const std::string& text) {
  const std::size_t colon = text.find(": ");
  if (colon == std::string::npos) return std::nullopt;
  std::optional<ExactPath> out = head_of(text.substr(0, colon));
  if (!out) return std::nullopt;
  try {
    out->path = path_from_text(text.substr(colon + 2), {}, kExactPath);
  } catch (const Error&) {
    return std::nullopt;
  }
  return out;
}

}  // namespace tramline::io
