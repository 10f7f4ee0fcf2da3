#include "tramline/io/plan/turn_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

std::vector<std::string_view> parted(std::string_view text, std::string_view by) {
  std::vector<std::string_view> out;
  while (true) {
    const std::size_t end = text.find(by);
    out.push_back(text.substr(0, end));
    if (end == std::string_view::npos) return out;
    text.remove_prefix(end + by.size());
  }
}

/// Longer stretches, and those that turn farther, 16 times round, are damage: nobody drives them, and to draw
/// one or to follow it could take all memory there is.
constexpr double kLongestStretch_m = 1e5, kFarthestTurn_rad = 100;

bool drivable(double length_m, double curvature_at_start, double curvature_at_end) {
  const double sharpest = std::max(std::abs(curvature_at_start), std::abs(curvature_at_end));
  return length_m >= 0 && length_m <= kLongestStretch_m && sharpest * length_m <= kFarthestTurn_rad;
}

SteeredStretch stretch_from(std::string_view text, Point offset, const std::string& place) {
  const std::vector<std::string_view> words = parted(text, " ");
  const auto other_form = [&] {
    return bad_input(fmt::format("{} is not a list of stretches at '{}'; write the plan again", place, text));
  };
  constexpr std::size_t kNumbers = 6;
  if (words.size() != kNumbers + 1) throw other_form();
  double n[kNumbers];
  for (std::size_t i = 0; i < kNumbers; ++i) {
    const auto [end, error] = std::from_chars(words[i].data(), words[i].data() + words[i].size(), n[i]);
    if (error != std::errc{} || end != words[i].data() + words[i].size() || !std::isfinite(n[i]))
      throw other_form();
  }
  const bool reverse = words.back() == name(Gear::kReverse);
  if (!reverse && words.back() != name(Gear::kForward)) throw other_form();
  if (!drivable(n[3], n[4], n[5]))
    throw bad_input(
        fmt::format("{} has a stretch of less than 0 m, of more than {:g} m or of more than {:g} rad, '{}'; "
                    "write the plan again",
                    place, kLongestStretch_m, kFarthestTurn_rad, text));
  return {{Point{n[0], n[1]} - offset, Heading::clockwise_from_north(Angle::radians(n[2]))},
          n[3],
          n[4],
          n[5],
          reverse ? Gear::kReverse : Gear::kForward};
}

}  // namespace

std::string steered_text(const SteeredPath& path, Point offset) {
  std::string out;
  for (const SteeredStretch& stretch : path)
    fmt::format_to(std::back_inserter(out), "{}{} {} {} {} {} {} {}", out.empty() ? "" : "; ",
                   plain_zero(stretch.start.at.x + offset.x), plain_zero(stretch.start.at.y + offset.y),
                   plain_zero(stretch.start.heading.angle().radians()), plain_zero(stretch.length_m),
                   plain_zero(stretch.curvature_at_start), plain_zero(stretch.curvature_at_end),
                   name(stretch.gear));
  return out;
}

SteeredPath steered_from_text(const std::string& text, Point offset, const std::string& place) {
  SteeredPath out;
  if (text.empty()) return out;
  for (const std::string_view part : parted(text, "; ")) out.push_back(stretch_from(part, offset, place));
  return out;
}

}  // namespace tramline::io
