#include "tramline/turns/turn_table.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>

#include "tramline/turns/manoeuvres/manoeuvre_choice.h"
#include "tramline/turns/manoeuvres/reach.h"
#include "tramline/turns/outline/outline.h"
#include "tramline/turns/outline/run_in.h"
#include "tramline/turns/outline/swept_reach.h"
#include "tramline/turns/tolerances.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

constexpr int kNeighbours = 8;
constexpr Point kFirstEnd{0, 0};

Heading heading_out() { return Heading::from_to({0, 0}, {0, 1}); }
Heading heading_back() { return Heading::from_to({0, 1}, {0, 0}); }

/// Along the border to the right, and square to it away from the tracks.
Point border_unit(Angle border) { return {std::sin(border.radians()), std::cos(border.radians())}; }
Point outward(Angle border) { return left_of(border_unit(border)); }

std::vector<double> spacings_of(const Machine& machine, const TurnTableSettings& settings) {
  if (!settings.spacings_m.empty()) return settings.spacings_m;
  std::vector<double> out;
  for (int k = 1; k <= kNeighbours; ++k) out.push_back(k * machine.width_m);
  return out;
}

TurnRow row_of(const Machine& machine, const Outline& outline, Angle border, Manoeuvre manoeuvre) {
  TurnRow out;
  out.manoeuvre = std::move(manoeuvre);
  const SteeredPath& path = out.manoeuvre.path;
  const Point unit = outward(border);
  const double before_m = dot(turn_begins(machine).at - kFirstEnd, unit);
  out.axle_depth_m = before_m + reach(path, unit);
  if (!path.empty()) {
    out.depth_m = std::max(0.0, swept_reach_m(path, outline, kFirstEnd, unit));
    if (outline.tows()) out.run_in_m = run_in_m(path, outline, kTowedInLine_m);
  }
  if (!path.empty()) {
    const double ends_m = dot(end_of(path.back()).at - path.front().start.at, unit);
    out.back_m = reach(path, Point{-unit.x, -unit.y}) - std::max(0.0, -ends_m);
  }
  out.length_m = length(path);
  out.time_s = seconds(out.manoeuvre, machine);
  out.passes = passes_for(out.depth_m, machine.width_m);
  out.gear_changes = gear_changes(path);
  return out;
}

bool stays_off_tracks(const TurnRow& row) { return row.back_m <= kStaysOffTracks_m; }

template <class Amount>
std::size_t least_of(const std::vector<TurnRow>& rows, Amount&& amount) {
  assert(!rows.empty());
  std::size_t best = 0;
  for (std::size_t i = 1; i < rows.size(); ++i) {
    const bool off = stays_off_tracks(rows[i]), best_off = stays_off_tracks(rows[best]);
    if (off != best_off ? off : amount(rows[i]) < amount(rows[best]) - kSameDepth) best = i;
  }
  return best;
}

}  // namespace

Pose turn_begins(const Machine& machine) {
  return pose_after_work(kFirstEnd, heading_out(), machine.turning);
}

Pose turn_ends(const Machine& machine, double spacing_m, Angle border) {
  const Point along = border_unit(border);
  assert(along.x > 0);
  return pose_before_work({spacing_m, spacing_m * along.y / along.x}, heading_back(), machine.turning);
}

int passes_for(double depth_m, double width_m) {
  assert(width_m > 0);
  return std::max(0, static_cast<int>(std::ceil(depth_m / width_m - kSameDepth)));
}

std::vector<TurnRow> turn_table(const Machine& machine, const TurnTableSettings& settings) {
  assert(machine.radius_m > 0 && machine.width_m > 0);
  const Outline outline = outline_of(machine);
  std::vector<TurnRow> out;
  for (const double spacing_m : spacings_of(machine, settings)) {
    assert(spacing_m > 0);
    const Pose begins = turn_begins(machine), ends = turn_ends(machine, spacing_m, settings.border);
    for (Manoeuvre& manoeuvre : manoeuvres_between(begins, ends, machine)) {
      out.push_back(row_of(machine, outline, settings.border, std::move(manoeuvre)));
      out.back().spacing_m = spacing_m;
    }
  }
  return out;
}

std::vector<TurnRow> rows_of(const std::vector<TurnRow>& rows, double spacing_m) {
  std::vector<TurnRow> out;
  for (const TurnRow& row : rows)
    if (row.spacing_m == spacing_m) out.push_back(row);
  return out;
}

std::size_t quickest(const std::vector<TurnRow>& rows) {
  return least_of(rows, [](const TurnRow& row) { return row.time_s; });
}

std::size_t shallowest(const std::vector<TurnRow>& rows) {
  return least_of(rows, [](const TurnRow& row) { return row.depth_m; });
}

std::vector<TurnRow> quickest_of_each(const std::vector<TurnRow>& rows) {
  std::vector<TurnRow> out;
  for (const TurnRow& row : rows) {
    if (!out.empty() && out.back().spacing_m == row.spacing_m) continue;
    const std::vector<TurnRow> alike = rows_of(rows, row.spacing_m);
    out.push_back(alike[quickest(alike)]);
  }
  return out;
}

}  // namespace tramline
