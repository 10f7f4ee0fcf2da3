#include "tramline/io/log/width_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <string_view>
#include <vector>

namespace tramline::io {
namespace {

struct LengthUnit {
  std::string_view name;
  double metres;
};
constexpr std::array kLengthUnits = {LengthUnit{"metres", 1}, LengthUnit{"feet", 0.3048},
                                     LengthUnit{"inches", 0.0254}, LengthUnit{"centimetres", 0.01},
                                     LengthUnit{"millimetres", 0.001}};
constexpr double kFits = 0.05;
constexpr double kShortest_m = 0.5, kLongest_m = 30;
constexpr std::size_t kFewestSteps = 20;

/// Good to half a percent, which is all that is needed here.
double metres_between(const WorkLog& log, Point a, Point b) {
  if (log.positions == Positions::kLocal) return distance(a, b);
  constexpr double kDegree_m = 6371008.8 * std::numbers::pi / 180;
  const double across = std::cos(a.y * std::numbers::pi / 180) * std::remainder(b.x - a.x, 360.0);
  return kDegree_m * std::hypot(across, b.y - a.y);
}

double distance_of(std::span<const RecordedDistance> distances, std::size_t record) {
  const auto at = std::lower_bound(distances.begin(), distances.end(), record,
                                   [](const RecordedDistance& a, std::size_t b) { return a.record < b; });
  return at != distances.end() && at->record == record ? at->distance : 0;
}

std::optional<LengthUnit> unit_of(const WorkLog& log, std::span<const RecordedDistance> distances) {
  std::map<int, Point> last;
  std::vector<double> metres_each;
  for (const Fix& fix : log.fixes) {
    const auto [at, is_first] = last.try_emplace(fix.unit, fix.position);
    const double way = metres_between(log, at->second, fix.position);
    at->second = fix.position;
    const double recorded = distance_of(distances, fix.record);
    if (!is_first && way > kShortest_m && way < kLongest_m && recorded > 0)
      metres_each.push_back(way / recorded);
  }
  if (metres_each.size() < kFewestSteps) return std::nullopt;
  const auto middle = metres_each.begin() + std::ssize(metres_each) / 2;
  std::nth_element(metres_each.begin(), middle, metres_each.end());
  for (const LengthUnit& unit : kLengthUnits)
    if (std::abs(*middle / unit.metres - 1) < kFits) return unit;
  return std::nullopt;
}

}  // namespace

double settle_width_unit(WorkLog& log, std::span<const RecordedDistance> distances) {
  assert(std::is_sorted(
      distances.begin(), distances.end(),
      [](const RecordedDistance& a, const RecordedDistance& b) { return a.record < b.record; }));
  const auto unit = unit_of(log, distances);
  if (!unit) {
    log.notes.emplace_back(
        "the widths have no unit and are taken as metres; --columns width_ft=NAME would say feet");
    return 1;
  }
  for (Boom& boom : log.booms)
    for (Section& section : boom) section = {section.left_m * unit->metres, section.right_m * unit->metres};
  log.notes.push_back(
      fmt::format("the widths have no unit and are taken as {0}, because the distances beside them are {0} "
                  "by the positions",
                  unit->name));
  return unit->metres;
}

}  // namespace tramline::io
