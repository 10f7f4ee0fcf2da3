#include "tramline/planner/search/any_plan_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/strip/strip_fold.h"
#include "tramline/planner/prove/detour_groups.h"

namespace tramline {
namespace {

/// Cells of the ground, at most about so many.
constexpr double kMostCells = 2000;
/// Directions: as many as it takes for a strip in between to stray by so much of its width …
constexpr double kStray_share = 0.3;
/// … but neither fewer nor more than so many.
constexpr int kFewestDirections = 48, kMostDirections = 240;
/// Offsets of the wide strips in one direction, which overlap each other.
constexpr int kOverlaps = 4;

/// A stretch of a wide strip in which one piece may lie, and the land, in metres of full swath, that a piece
/// there works at most.
struct Run {
  double from = 0, to = 0;
  double length_m = 0;
};

/// The runs of all wide strips of one direction. The coordinates across count from the pivot.
class WideStrips {
 public:
  WideStrips(const Detouring& terms, const std::vector<DetourGroup>& groups, Point pivot, double radius_m)
      : terms_(terms), width_m_(terms.width_m), groups_(groups), pivot_(pivot), radius_m_(radius_m) {}

  /// Within half_angle of the angle.
  void lay(const Region& ground, double angle, double half_angle) {
    frame_ = TrackFrame(Direction::clockwise_from_north(Angle::radians(angle)));
    // A strip turned about the pivot strays by no more, across as well as along.
    stray_m_ = radius_m_ * (std::sin(half_angle) + half_angle * half_angle);
    wide_m_ = (width_m_ + 2 * stray_m_) * kOverlaps / (kOverlaps - 1);
    step_m_ = wide_m_ / kOverlaps;
    slant_m_ = wide_m_ * std::tan(half_angle) + kNoPiece_m;
    row_m_ = width_m_ / std::cos(half_angle);
    const Region turned = frame_.to_track(ground);
    centre_ = frame_.to_track(pivot_);
    const Point centre = centre_;
    std::vector<GroupZone> zones;
    for (const DetourGroup& group : groups_) {
      Box box;
      for (const Point corner : group.corners) box.extend(frame_.to_track(corner));
      zones.push_back(detour_zone(group, box, terms_, stray_m_));
    }
    reach_for_others(zones);
    turned_groups_.clear();
    for (const GroupZone& zone : zones) turned_groups_.push_back({zone});
    const Box reach = bounds(turned);
    first_ = static_cast<int>(std::floor((reach.min_x - centre.x - width_m_ - stray_m_) / step_m_)) - 1;
    const int last = static_cast<int>(std::ceil((reach.max_x - centre.x + stray_m_) / step_m_)) + 1;
    runs_.assign(static_cast<std::size_t>(last - first_) + 1, {});
    thread_local StripFold fold;
    for (int offset = 0; offset < kOverlaps; ++offset) {
      // Wide strip k of this offset holds all swaths whose left line lies in step kOverlaps·k + offset.
      const StripGrid grid{frame_, centre.x + offset * step_m_ - stray_m_, wide_m_};
      const StripRange range = strips_over(grid, reach, 0);
      if (range.size() == 0) continue;
      fold.fold(std::span<const Polygon>(turned), grid, range,
                StripMask(static_cast<std::size_t>(range.size()), true));
      for (int k = range.first; k <= range.last; ++k) {
        const int step = kOverlaps * k + offset - first_;
        if (step < 0 || step >= static_cast<int>(runs_.size())) continue;
        add_runs(fold.profile(static_cast<std::size_t>(k - range.first)), grid.line(k),
                 runs_[static_cast<std::size_t>(step)]);
      }
    }
    for (TurnedGroup& group : turned_groups_) {
      Box meeting = group.zone.land;
      meeting.min_x = group.zone.box.min_x;
      meeting.max_x = group.zone.box.max_x;
      group.longest_m = longest(meeting);
    }
  }

  /// The longest run that a swath through any of the land within `half_m` of the point may lie in.
  double longest_through(Point at, double half_m) const {
    const Point turned = frame_.to_track(at);
    const Box cell = Box{turned.x, turned.y, turned.x, turned.y}.grown(half_m);
    double out = longest(cell);
    // Those that work it with a detour lie elsewhere.
    for (const TurnedGroup& group : turned_groups_)
      if (intersects(cell, group.zone.land)) out = std::max(out, group.longest_m);
    return out;
  }

 private:
  struct TurnedGroup {
    GroupZone zone;
    double longest_m = 0;  ///< run of a piece that may have a detour round them
  };

  /// The longest run of swaths that may meet the box.
  double longest(const Box& box) const {
    const auto step_of = [&](double x) {
      return static_cast<int>(std::floor((x - centre_.x) / step_m_)) - first_;
    };
    const int low = std::max(0, step_of(box.min_x - width_m_ - stray_m_));
    const int high = std::min(static_cast<int>(runs_.size()) - 1, step_of(box.max_x + stray_m_));
    double out = 0;
    for (int i = low; i <= high; ++i)
      for (const Run& run : runs_[static_cast<std::size_t>(i)])
        if (run.from <= box.max_y + stray_m_ && run.to >= box.min_y - stray_m_)
          out = std::max(out, run.length_m);
    return out;
  }

  bool bridged(Interval gap, double left) const {
    const Box rows{left, gap.from, left + wide_m_, gap.to};
    return std::any_of(turned_groups_.begin(), turned_groups_.end(),
                       [&](const TurnedGroup& group) { return intersects(group.zone.box, rows); });
  }

  void add_runs(const StripProfile& profile, double left, std::vector<Run>& out) const {
    const std::vector<Slab>& slabs = profile.slabs;
    for (std::size_t i = 0; i < slabs.size();) {
      Run run{slabs[i].from, slabs[i].to, worked_m(slabs[i])};
      for (++i; i < slabs.size(); ++i) {
        const double gap_m = slabs[i].from - run.to;
        if (gap_m > slant_m_ && !bridged({run.to, slabs[i].from}, left)) break;
        run.length_m += worked_m(slabs[i]);
        run.to = slabs[i].to;
      }
      add_detours(left, run);
      out.push_back(run);
    }
  }

  /// A row of the strip lies in a swath by the width at most.
  double worked_m(const Slab& slab) const {
    const double length = slab.to - slab.from, a = slab.width_from, b = slab.width_to;
    const double low = std::min(a, b), high = std::max(a, b);
    if (high <= row_m_) return length * 0.5 * (a + b) / width_m_;
    if (low >= row_m_) return length * row_m_ / width_m_;
    const double share = (row_m_ - low) / (high - low);  // of the rows narrower than a swath
    return length * (share * 0.5 * (low + row_m_) + (1 - share) * row_m_) / width_m_;
  }

  /// With detours every row of the run may be worked in full, and more by what they are longer.
  void add_detours(double left, Run& run) const {
    bool any = false;
    double longer_m = 0;
    for (const auto& [group, longest] : turned_groups_) {
      if (group.box.min_x > left + wide_m_ || group.box.max_x < left) continue;
      if (group.land.min_y > run.to || group.land.max_y < run.from) continue;
      any = true;
      longer_m += group.longer_m;
    }
    if (any) run.length_m = (run.to - run.from) * row_m_ / width_m_ + longer_m;
  }

  Detouring terms_;
  double width_m_;
  const std::vector<DetourGroup>& groups_;
  Point pivot_;
  double radius_m_;
  TrackFrame frame_;
  Point centre_;
  double stray_m_ = 0, wide_m_ = 1, step_m_ = 1, slant_m_ = 0, row_m_ = 1;
  int first_ = 0;
  std::vector<std::vector<Run>> runs_;  ///< by step of the swath's left line
  std::vector<TurnedGroup> turned_groups_;
};

/// A square of the ground.
struct Cell {
  Point centre;
  double inside_m2 = 0;
  double longest_m = 0;  ///< run of a piece that works any of it
};

std::vector<Cell> cells_of(const Region& body, double side_m) {
  std::vector<Cell> out;
  const Box box = bounds(body);
  const StripGrid grid{TrackFrame(), box.min_x, side_m};
  const StripRange range = strips_over(grid, box, 0);
  const std::vector<StripProfile> columns = cross_sections(body, grid, range);
  const int rows = static_cast<int>(std::ceil(box.height() / side_m));
  for (int k = range.first; k <= range.last; ++k)
    for (int row = 0; row < rows; ++row) {
      const double low = box.min_y + row * side_m;
      const double inside_m2 =
          area_between(columns[static_cast<std::size_t>(k - range.first)], low, low + side_m);
      if (inside_m2 > 0) out.push_back({{grid.centre(k), low + 0.5 * side_m}, inside_m2, 0});
    }
  return out;
}

}  // namespace

double least_cost_of_any_plan(const SearchTask& task) {
  const Objective& price = task.objective;
  const double width_m = task.machine.width_m;
  const Region& ground = task.ground.plannable;
  const double given_up = price.uncovered * std::max(0.0, task.body_m2 - area(ground));
  if (ground.empty() || price.turn <= 0) return given_up;
  const Box box = bounds(ground);
  const double radius_m = 0.5 * std::hypot(box.width(), box.height());
  const Detouring terms{width_m, std::max(task.machine.radius_m, 0.5 * width_m),
                        task.settings.avoid != Avoidance::kPaper};
  const std::vector<DetourGroup> groups = detour_groups(task.ground.hazards, task.ground.plannable, terms);

  const double side_m = std::max(0.5 * width_m, std::sqrt(box.width() * box.height() / kMostCells));
  std::vector<Cell> cells =
      cells_of(task.ground.passable.empty() ? ground : difference(ground, task.ground.passable), side_m);
  const int directions = static_cast<int>(
      std::clamp(std::ceil(std::numbers::pi * radius_m / (2 * kStray_share * width_m)),
                 static_cast<double>(kFewestDirections), static_cast<double>(kMostDirections)));
  const double half_angle = std::numbers::pi / (2 * directions);
  WideStrips strips(terms, groups, box.centre(), radius_m);
  for (int i = 0; i < directions; ++i) {
    strips.lay(ground, (2 * i + 1) * half_angle, half_angle);
    for (Cell& cell : cells)
      cell.longest_m =
          std::max(cell.longest_m, strips.longest_through(cell.centre, side_m * std::numbers::sqrt2 / 2));
  }

  // The first piece costs no turn. With a lower price than a turn's less has to be subtracted for it, and
  // what the other pieces cost beyond that price is left out: the best of some such prices counts.
  constexpr int kPrices = 24;
  double most = 0;
  for (int i = 0; i < kPrices; ++i) {
    const double by_piece = std::ldexp(price.turn, -i);
    double sum = 0;
    for (const Cell& cell : cells)
      sum += cell.inside_m2 * std::min(price.uncovered, by_piece / (width_m * (cell.longest_m + kNoPiece_m)));
    most = std::max(most, sum * (1 - kRounding_share) - by_piece);
  }
  return given_up + most;
}

}  // namespace tramline
