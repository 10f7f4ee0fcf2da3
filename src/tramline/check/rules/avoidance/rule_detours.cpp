#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/detour_course.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

bool includes(const std::vector<std::size_t>& all, std::size_t index) {
  return std::find(all.begin(), all.end(), index) != all.end();
}

/// Obstacles that may be entered do not block a track.
bool stands_in_ways(const Obstacle& obstacle) { return obstacle.kind == ObstacleKind::kObstacle; }

/// Checks one detour against the obstacles and the encounters.
class DetourCheck {
 public:
  DetourCheck(const Case& c, const Detour& detour, std::string name, const Path& replaced_line,
              std::vector<const Encounter*> encounters)
      : c_(c),
        detour_(detour),
        name_(std::move(name)),
        encounters_(std::move(encounters)),
        course_(replaced_line, detour.path),
        reach_m_(0.5 * c.plan.machine.width_m + c.plan.settings.clearance_m) {}

  void run(Violations& out) {
    const Point at = detour_.path.front().from;
    if (encounters_.empty())
      out.push_back({Rule::kEncounters, name_ + " is where the plan has no encounter", at, 1});
    const Box near = course_.line_box(reach_m_);
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      const bool named = includes(detour_.obstacles, k);
      if (!named && !(stands_in_ways(obstacles[k]) && intersects(c_.obstacle_boxes[k], near))) continue;
      const std::string fault = fault_about(k, named);
      if (fault.empty()) continue;
      out.push_back({Rule::kEncounters, fmt::format("{}: obstacle {} {}", name_, k + 1, fault),
                     obstacles[k].shape.outer.front(), static_cast<double>(k + 1)});
    }
    if (!wrong_side_told_ && course_.goes_left() != goes_left())
      out.push_back(
          {Rule::kEncounters, fmt::format("{} does not pass {}", name_, name(detour_.side)), at, 1});
  }

 private:
  bool goes_left() const { return detour_.side == Passing::kLeft; }
  double in_the_way_m() const { return reach_m_ - kLengthTolerance_m; }
  bool is_in_the_way(const Sides& sides) const { return sides.nearest_m() < in_the_way_m(); }

  /// The fault of a detour with respect to an obstacle, or "". An obstacle may be named that does not block
  /// the line: land given up may join it to one that does, or the detour would otherwise have hit it.
  std::string fault_about(std::size_t obstacle, bool named) {
    const Polygon& shape = c_.plan.field.obstacles[obstacle].shape;
    const Sides sides = course_.sides_of(shape);
    if (!named) return is_in_the_way(sides) ? "is in its way and not named" : "";
    if (is_passed_on_wrong_side(sides)) {
      wrong_side_told_ = true;
      return fmt::format("is not passed {}", name(detour_.side));
    }
    if (std::isinf(sides.nearest_m()) && course_.distance_to_line(shape) > reach_m_ + kLengthTolerance_m)
      return "is named, and does not lie beside it";
    // One missing encounter is reported once.
    if (is_in_the_way(sides) && !encounters_.empty() && !names(encounters_, obstacle))
      return "is in its way, and no encounter there names it";
    return "";
  }

  /// An obstacle with a bay may lie on both sides of a detour within the bay: the part that blocks the line
  /// counts.
  bool is_passed_on_wrong_side(const Sides& sides) const {
    const double passed_m = goes_left() ? sides.right_m : sides.left_m;
    const double other_m = goes_left() ? sides.left_m : sides.right_m;
    if (std::isinf(sides.nearest_m())) return false;
    return std::isinf(passed_m) || other_m < in_the_way_m();
  }

  const Case& c_;
  const Detour& detour_;
  std::string name_;
  std::vector<const Encounter*> encounters_;
  DetourCourse course_;
  double reach_m_;
  bool wrong_side_told_ = false;
};

}  // namespace

std::optional<Path> replaced_line(const Case& c, const TrackPiece& piece, const Detour& detour) {
  const std::optional<TrackLine> line = c.lines.along(piece);
  if (!line) return std::nullopt;
  const PathSegment& first = detour.path.front();
  return line->between(first.from, direction_at_start(first), detour.path.back().to);
}

void check_detours(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    for (std::size_t k = 0; k < piece.detours.size(); ++k) {
      const Detour& detour = piece.detours[k];
      if (const std::optional<Path> line = replaced_line(c, piece, detour))
        DetourCheck(c, detour, detour_name(i, k), *line, encounters_at(c, piece, detour)).run(out);
      else
        out.push_back({Rule::kEncounters,
                       detour_name(i, k) + " does not lead from the line of its track back to it",
                       detour.path.front().from, 1});
    }
  }
}

}  // namespace tramline::check
