#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/sound_path.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// What was laid along a line of a subfield: a piece, or what was too short to be one. In the frame of the
/// subfield's direction.
struct Laid {
  double across_m = 0;
  double from_m = 0;
  double to_m = 0;
  std::optional<std::size_t> piece;
};

/// Between two things laid along one line.
struct Gap {
  const Laid& before;
  const Laid& behind;
};

Laid laid(const PieceFrame& frame, Point start, Point end, std::optional<std::size_t> piece) {
  const Point a = frame.to_local(start), b = frame.to_local(end);
  return {0.5 * (a.x + b.x), std::min(a.y, b.y), std::max(a.y, b.y), piece};
}

/// All that was laid in a subfield, line by line. By their places: what the tracks are called is not asked.
std::vector<Laid> laid_in(const Plan& plan, int subfield, const PieceFrame& frame) {
  std::vector<Laid> out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    if (plan.pieces[i].subfield == subfield)
      out.push_back(laid(frame, plan.pieces[i].start, plan.pieces[i].end, i));
  for (const DroppedPiece& dropped : plan.dropped)
    if (dropped.subfield == subfield && on_the_map(dropped.start) && on_the_map(dropped.end))
      out.push_back(laid(frame, dropped.start, dropped.end, std::nullopt));
  std::sort(out.begin(), out.end(), [](const Laid& a, const Laid& b) { return a.across_m < b.across_m; });
  auto line = out.begin();
  for (auto next = line; line != out.end(); line = next) {
    while (next != out.end() && next->across_m <= line->across_m + kLengthTolerance_m) ++next;
    std::sort(line, next, [](const Laid& a, const Laid& b) { return a.from_m < b.from_m; });
  }
  return out;
}

/// Gaps of one subfield against the encounters there.
class Meetings {
 public:
  Meetings(const Case& c, int subfield, Violations& out)
      : c_(c),
        out_(out),
        frame_(c.plan.field.outer.front(),
               c.plan.field.outer.front() +
                   c.plan.subfields[static_cast<std::size_t>(subfield)].direction.unit()) {
    for (const Encounter& encounter : c.plan.encounters)
      if (encounter.subfield == subfield) encounters_.push_back(&encounter);
    const std::vector<Laid> all = laid_in(c.plan, subfield, frame_);
    for (std::size_t i = 0, farthest = 0; i < all.size(); ++i) {
      const bool same_line = all[i].across_m <= all[farthest].across_m + kLengthTolerance_m;
      if (i > 0 && same_line && all[i].from_m > all[farthest].to_m) check({all[farthest], all[i]});
      if (!same_line || all[i].to_m > all[farthest].to_m) farthest = i;
    }
  }

 private:
  void check(const Gap& gap) {
    const double half = 0.5 * c_.plan.machine.width_m, across = gap.before.across_m;
    const Box core =
        Box{across - half, gap.before.to_m, across + half, gap.behind.from_m}.grown(-kLengthTolerance_m);
    if (core.width() <= 0 || core.height() <= 0) return;
    const Clipped blocked = clipped(c_.blocking, frame_, core);
    const Clipped left_out = clipped(c_.given_up, frame_, core);
    if (blocked.area_m2 + left_out.area_m2 <= kTouch_m2) return;
    const std::vector<const Encounter*> there = encounters_in(gap);
    if (there.empty())
      out_.push_back({rule::kEncounters,
                      describe(gap) + " is cut by an obstacle or land given up, and no encounter is there",
                      frame_.to_field({across, core.centre().y}), 1});
    else if (blocked.area_m2 > kTouch_m2)
      check_names(gap, core, there);
  }

  std::vector<const Encounter*> encounters_in(const Gap& gap) const {
    std::vector<const Encounter*> out;
    for (const Encounter* encounter : encounters_) {
      const Point at = frame_.to_local(encounter->at);
      if (std::abs(at.x - gap.before.across_m) <= kLengthTolerance_m &&
          at.y >= gap.before.to_m - kLengthTolerance_m && at.y <= gap.behind.from_m + kLengthTolerance_m &&
          is_of_track(*encounter, gap.before) && is_of_track(*encounter, gap.behind))
        out.push_back(encounter);
    }
    return out;
  }

  /// The file does not say which track a dropped piece was of.
  bool is_of_track(const Encounter& encounter, const Laid& part) const {
    return !part.piece || c_.plan.pieces[*part.piece].track == encounter.track;
  }

  void check_names(const Gap& gap, const Box& core, const std::vector<const Encounter*>& there) {
    const Box near = frame_.field_box(core);
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || passes_round(c_.plan, k) > 0) continue;
      if (!intersects(c_.obstacle_boxes[k], near)) continue;
      const Clipped part = clipped(obstacles[k].shape, frame_, core);
      if (part.area_m2 <= kTouch_m2 || names(there, static_cast<int>(k))) continue;
      out_.push_back(
          {rule::kEncounters,
           fmt::format("{} is cut by obstacle {}, which no encounter there names", describe(gap), k + 1),
           part.at, static_cast<double>(k + 1)});
    }
  }

  static std::string describe(const Gap& gap) {
    if (gap.before.piece && gap.behind.piece)
      return fmt::format("the track between {} and {}", piece_name(*gap.before.piece),
                         piece_name(*gap.behind.piece));
    const auto& piece = gap.before.piece ? gap.before.piece : gap.behind.piece;
    return piece ? fmt::format("the track between {} and a dropped one", piece_name(*piece))
                 : "the track between two dropped pieces";
  }

  const Case& c_;
  Violations& out_;
  PieceFrame frame_;
  std::vector<const Encounter*> encounters_;
};

}  // namespace

void check_meetings(const Case& c, Violations& out) {
  if (is_repair(c.plan)) return;
  for (int i = 0; i < static_cast<int>(c.plan.subfields.size()); ++i)
    if (!follows_curve(c.plan, i)) Meetings(c, i, out);
}

}  // namespace tramline::check
