#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "tramline/check/bands.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

/// All that was laid along one line: pieces, and what was too short to be one.
class LineMeetings {
 public:
  LineMeetings(const Case& c, std::size_t line, Violations& out) : c_(c), line_(line), out_(out) {}

  void add(const OnLine& part) { laid_.push_back(part); }

  void check() {
    if (laid_.empty()) return;
    std::sort(laid_.begin(), laid_.end(),
              [](const OnLine& a, const OnLine& b) { return a.from_m < b.from_m; });
    double done_m = laid_.front().to_m;
    for (const OnLine& part : laid_) {
      if (part.from_m > done_m) check_gap({line_, done_m, part.from_m});
      done_m = std::max(done_m, part.to_m);
    }
    const double round_m = laid_.front().from_m + c_.lines.length_m(line_);
    if (c_.lines.closed(line_) && round_m > done_m) check_gap({line_, done_m, round_m});
  }

 private:
  void check_gap(const OnLine& gap) {
    const Path path = shortened(c_.lines.path_of(gap), kLengthTolerance_m);
    const double width_m = c_.plan.machine.width_m - 2 * kLengthTolerance_m;
    if (path.empty() || width_m <= 0) return;
    const Region core = bands_along(path, width_m);
    const double blocked_m2 = common_m2(core, c_.blocking);
    if (blocked_m2 + common_m2(core, c_.given_up) <= kTouch_m2) return;
    std::vector<const Encounter*> there;
    for (const Encounter& encounter : c_.plan.encounters)
      if (encounter.track == c_.lines.track(line_) && holds(c_.lines, gap, encounter.at))
        there.push_back(&encounter);
    const Point at = place_on(path, 0.5 * length(path));
    const std::string name = fmt::format("track {}", c_.lines.track(line_) + 1);
    if (there.empty()) {
      out_.push_back(
          {"encounters", name + " is cut by an obstacle or land given up, and no encounter is there", at, 1});
      return;
    }
    if (blocked_m2 > kTouch_m2) check_names(core, there, name, at);
  }

  void check_names(const Region& core, const std::vector<const Encounter*>& there, const std::string& name,
                   Point at) {
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || passes_round(c_.plan, k) > 0) continue;
      const BoxedRegion one{{&obstacles[k].shape, c_.obstacle_boxes[k]}};
      if (common_m2(core, one) <= kTouch_m2 || names(there, static_cast<int>(k))) continue;
      out_.push_back({"encounters",
                      fmt::format("{} is cut by obstacle {}, which no encounter there names", name, k + 1),
                      at, static_cast<double>(k + 1)});
    }
  }

  static double common_m2(const Region& core, const BoxedRegion& land) {
    double sum = 0;
    for (const Polygon& part : core)
      for (const Boxed& polygon : land)
        if (intersects(bounds(part), polygon.box)) sum += area(intersection({part}, {*polygon.shape}));
    return sum;
  }

  const Case& c_;
  std::size_t line_;
  Violations& out_;
  std::vector<OnLine> laid_;
};

}  // namespace

void check_curved_meetings(const Case& c, Violations& out) {
  std::vector<LineMeetings> meetings;
  for (std::size_t i = 0; i < c.lines.size(); ++i) meetings.emplace_back(c, i, out);
  for (const TrackPiece& piece : c.plan.pieces) {
    if (piece.curve.empty()) continue;
    const auto part =
        c.lines.between(piece.track, piece.start, direction_at_start(piece.curve.front()), piece.end);
    if (part) meetings[part->line].add(*part);
  }
  for (const DroppedPiece& dropped : c.plan.dropped)
    for (std::size_t i = 0; i < c.lines.size(); ++i) {
      const auto from = c.lines.place_on(i, dropped.start);
      if (!from) continue;
      const auto to = c.lines.place_on(i, dropped.end);
      if (to) meetings[i].add({i, std::min(*from, *to), std::max(*from, *to)});
    }
  for (LineMeetings& line : meetings) line.check();
}

}  // namespace tramline::check
