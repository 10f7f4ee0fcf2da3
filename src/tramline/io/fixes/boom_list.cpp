#include "tramline/io/fixes/boom_list.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numeric>

namespace tramline::io {

int BoomList::number_of(const Boom& boom) {
  std::vector<double> key;
  key.reserve(2 * boom.size());
  for (const Section& section : boom) key.insert(key.end(), {section.left_m, section.right_m});
  const auto [at, is_new] = numbers_.try_emplace(std::move(key), static_cast<int>(booms_.size()));
  if (is_new) booms_.push_back(boom);
  return at->second;
}

Boom side_by_side(std::span<const double> widths_m) {
  assert(std::all_of(widths_m.begin(), widths_m.end(), [](double w) { return std::isfinite(w) && w >= 0; }));
  double left = 0.5 * std::accumulate(widths_m.begin(), widths_m.end(), 0.0);
  Boom out;
  for (const double width : widths_m) {
    out.push_back({left, left - width});
    left -= width;
  }
  return out;
}

Boom one_section(double width_m) {
  if (!(width_m > 0)) return {};
  return {{0.5 * width_m, -0.5 * width_m}};
}

std::string note_on_wide(std::span<const Boom> booms) {
  constexpr double kWide_m = 60;
  double widest_m = 0;
  for (const Boom& boom : booms)
    if (!boom.empty()) widest_m = std::max(widest_m, boom.front().left_m - boom.back().right_m);
  if (widest_m <= kWide_m) return {};
  return fmt::format("a boom is {:.1f} m wide; make sure that the widths are those of the sections",
                     widest_m);
}

}  // namespace tramline::io
