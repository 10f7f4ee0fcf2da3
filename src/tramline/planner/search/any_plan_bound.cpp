#include "tramline/planner/search/any_plan_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/strip/strip_fold.h"

namespace tramline {
namespace {

/// Cells of the ground, at most about so many.
constexpr double kMostCells = 2000;
/// Directions: as many as it takes for a strip in between to stray by so much of its width …
constexpr double kStray_share = 0.4;
/// … but neither fewer nor more than so many.
constexpr int kFewestDirections = 48, kMostDirections = 180;
/// Offsets of the wide strips in one direction, which overlap each other.
constexpr int kOverlaps = 4;

/// Corners of a ring where it turns to the outside. A strip meets a polygon in at most one part more.
int reflex_corners(const Ring& ring) {
  int sum = 0;
  const std::size_t n = ring.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = ring[(i + n - 1) % n], b = ring[i], c = ring[(i + 1) % n];
    sum += cross(b - a, c - b) < 0 ? 1 : 0;
  }
  return signed_area(ring) < 0 ? static_cast<int>(n) - sum : sum;
}

/// Obstacles of which one detour may go round several.
struct DetourGroup {
  Box box;
  int most_detours = 0;  ///< of one piece
  double reach_m = 0;    ///< no detour begins farther from the box along its track

  double diameter_m() const { return std::hypot(box.width(), box.height()); }
  Point centre() const { return box.centre(); }
  /// By how much the detours of one piece can be longer than the rows they take: each by twice its distance
  /// from the track, away and back; and as none is steeper than 75 degrees, by four times those rows.
  double longer_m(double width_m) const {
    constexpr double kSteepest = 4;  // more than the tangent of 75 degrees
    return std::min(2 * most_detours * rise_m(width_m), kSteepest * (diameter_m() + 2 * reach_m));
  }
  /// The largest distance of a detour from its track. What passes as a circle reaches 1 % beyond its corners.
  double rise_m(double width_m) const { return 1.02 * diameter_m() + width_m; }
};

/// A detour leaves its track along an arc, or along a line that is inclined by 75 degrees between two arcs.
double along_reach_m(const DetourGroup& group, double arc_m, double width_m) {
  constexpr double kFoot = 0.27;  // more than the cotangent of 75 degrees
  return width_m + 2 * arc_m + kFoot * group.rise_m(width_m);
}

double distance_of(const Box& a, const Box& b) {
  return std::hypot(std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x}),
                    std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y}));
}

/// A detour that would run into a further obstacle goes round that one too, and two that would meet are one:
/// obstacles nearer to one another than detours reach are one group.
std::vector<DetourGroup> detour_groups(const std::vector<Hazard>& hazards, double arc_m, double width_m) {
  std::vector<DetourGroup> out;
  for (const Hazard& hazard : hazards) {
    DetourGroup one{bounds(hazard.shape), 1 + reflex_corners(hazard.shape.outer), 0};
    for (bool grown = true; grown;) {
      grown = false;
      one.reach_m = along_reach_m(one, arc_m, width_m);
      for (std::size_t i = 0; i < out.size(); ++i) {
        if (distance_of(one.box, out[i].box) > one.reach_m + out[i].reach_m + 2 * width_m) continue;
        one.box.extend(out[i].box);
        one.most_detours += out[i].most_detours;
        out.erase(out.begin() + static_cast<std::ptrdiff_t>(i));
        grown = true;
        break;
      }
    }
    out.push_back(one);
  }
  return out;
}

/// A stretch of a wide strip in which one piece may lie, and the land, in metres of full swath, that a piece
/// there works at most.
struct Run {
  double from = 0, to = 0;
  double length_m = 0;
};

/// The runs of all wide strips of one direction. The coordinates across count from the pivot.
class WideStrips {
 public:
  WideStrips(const SearchTask& task, const std::vector<DetourGroup>& groups, Point pivot, double radius_m)
      : width_m_(task.machine.width_m), groups_(groups), pivot_(pivot), radius_m_(radius_m) {}

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
    const Point centre = frame_.to_track(pivot_);
    turned_groups_.clear();
    for (const DetourGroup& group : groups_) {
      const Point at = frame_.to_track(group.centre());
      const double half = 0.5 * group.diameter_m();
      turned_groups_.push_back({at.x - half, at.x + half, at.y - half, at.y + half, &group});
    }
    const Box reach = bounds(turned);
    first_ = static_cast<int>(std::floor((reach.min_x - centre.x - width_m_ - stray_m_) / step_m_)) - 1;
    const int last = static_cast<int>(std::ceil((reach.max_x - centre.x + stray_m_) / step_m_)) + 1;
    runs_.assign(static_cast<std::size_t>(last - first_ + 1), {});
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
    centre_ = centre;
  }

  /// The longest run that a swath through any of the land within `half_m` of the point may lie in.
  double longest_through(Point at, double half_m) const {
    const Point turned = frame_.to_track(at) - centre_;
    return longest({turned.x - half_m, turned.x + half_m}, {turned.y + centre_.y - half_m,
                                                            turned.y + centre_.y + half_m});
  }

  /// The longest run of all pieces that may have a detour round the group.
  double longest_round(std::size_t group) const {
    const TurnedGroup& turned = turned_groups_[group];
    const double along = turned.group->reach_m + stray_m_;
    return longest({turned.min_x - centre_.x, turned.max_x - centre_.x},
                   {turned.min_y - along, turned.max_y + along});
  }

 private:
  struct TurnedGroup {
    double min_x, max_x, min_y, max_y;
    const DetourGroup* group;
  };

  double longest(Interval across, Interval along) const {
    const auto step_of = [&](double x) { return static_cast<int>(std::floor(x / step_m_)) - first_; };
    const int low = std::max(0, step_of(across.from - width_m_ - stray_m_));
    const int high = std::min(static_cast<int>(runs_.size()) - 1, step_of(across.to + stray_m_));
    double out = 0;
    for (int i = low; i <= high; ++i)
      for (const Run& run : runs_[static_cast<std::size_t>(i)])
        if (run.from <= along.to + stray_m_ && run.to >= along.from - stray_m_)
          out = std::max(out, run.length_m);
    return out;
  }

  bool bridged(Interval gap, double left) const {
    return std::any_of(turned_groups_.begin(), turned_groups_.end(), [&](const TurnedGroup& group) {
      return group.min_x <= left + wide_m_ + stray_m_ && group.max_x >= left - stray_m_ &&
             group.min_y - stray_m_ <= gap.to && group.max_y + stray_m_ >= gap.from;
    });
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
    for (const TurnedGroup& turned : turned_groups_) {
      if (turned.min_x > left + wide_m_ + stray_m_ || turned.max_x < left - stray_m_) continue;
      const double along = turned.group->reach_m + stray_m_;
      if (std::max(run.from, turned.min_y - along) > std::min(run.to, turned.max_y + along)) continue;
      any = true;
      longer_m += turned.group->longer_m(width_m_);
    }
    if (any) run.length_m = (run.to - run.from) * row_m_ / width_m_ + longer_m;
  }

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
  const double width_m = task.machine.width_m, arc_m = std::max(task.machine.radius_m, 0.5 * width_m);
  const Region& ground = task.ground.plannable;
  const double given_up = price.uncovered * std::max(0.0, task.body_m2 - area(ground));
  if (ground.empty() || price.turn <= 0) return given_up;
  const Box box = bounds(ground);
  const double radius_m = 0.5 * std::hypot(box.width(), box.height());
  const std::vector<DetourGroup> groups = detour_groups(task.ground.hazards, arc_m, width_m);

  const double side_m = std::max(0.5 * width_m, std::sqrt(box.width() * box.height() / kMostCells));
  std::vector<Cell> cells = cells_of(
      task.ground.passable.empty() ? ground : difference(ground, task.ground.passable), side_m);
  std::vector<double> longest_round(groups.size(), 0);
  const int directions = static_cast<int>(
      std::clamp(std::ceil(std::numbers::pi * radius_m / (2 * kStray_share * width_m)),
                 static_cast<double>(kFewestDirections), static_cast<double>(kMostDirections)));
  const double half_angle = std::numbers::pi / (2 * directions);
  WideStrips strips(task, groups, box.centre(), radius_m);
  for (int i = 0; i < directions; ++i) {
    strips.lay(ground, (2 * i + 1) * half_angle, half_angle);
    for (Cell& cell : cells)
      cell.longest_m =
          std::max(cell.longest_m, strips.longest_through(cell.centre, side_m * std::numbers::sqrt2 / 2));
    for (std::size_t g = 0; g < groups.size(); ++g)
      longest_round[g] = std::max(longest_round[g], strips.longest_round(g));
  }

  double sum = 0;
  for (const Cell& cell : cells) {
    double longest_m = cell.longest_m;
    for (std::size_t g = 0; g < groups.size(); ++g) {
      const Box at{cell.centre.x, cell.centre.y, cell.centre.x, cell.centre.y};
      if (distance_of(at, groups[g].box) <= side_m + groups[g].reach_m + groups[g].rise_m(width_m) + width_m)
        longest_m = std::max(longest_m, longest_round[g]);
    }
    const double by_turn =
        longest_m > 0 ? price.turn / (width_m * (longest_m + kNoPiece_m)) : price.uncovered;
    sum += cell.inside_m2 * std::min(price.uncovered, by_turn);
  }
  return given_up + std::max(0.0, sum * (1 - kRounding_share) - price.turn);
}

}  // namespace tramline
