#include <fmt/format.h>

#include <cmath>
#include <string>

#include "tramline/check/measure/swath_core.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The reason why the second piece does not continue the first, or "" where it does.
std::string not_in_line(const TrackPiece& first, const TrackPiece& second) {
  if (second.subfield != first.subfield || second.track != first.track) return "belongs to another track";
  const PieceFrame frame(first);
  const Point start = frame.to_local(second.start), end = frame.to_local(second.end);
  if (std::abs(start.x) > kLengthTolerance_m || std::abs(end.x) > kLengthTolerance_m) return "is not in line";
  if (start.y <= frame.length() || end.y <= start.y) return "does not lie ahead";
  return "";
}

/// The fault of the gap between two pieces in line, or "".
std::string wrong_gap(const Case& c, const TrackPiece& first, const TrackPiece& second) {
  const PieceFrame frame(first.end, second.start);
  const double width_m = c.plan.machine.width_m;
  const bool repair = is_repair(c.plan);
  if (!repair &&
      clipped(c.passables, frame, {-0.5 * width_m, 0, 0.5 * width_m, frame.length()}).area_m2 <= kTouch_m2)
    return "with no passable obstacle between";
  const SwathCore core(straight_path(first.end, second.start), width_m);
  if (core.empty()) return "";
  if (repair && core.part_on(c.passables).area_m2 > kTouch_m2) return "through an obstacle";
  if (repair && core.part_beyond(c.plan.field.outer).area_m2 > kTouch_m2) return "beyond the field";
  if (core.part_on(c.obstacles).area_m2 > kTouch_m2) return "through an obstacle";
  if (core.part_on(c.given_up).area_m2 > kTouch_m2) return "through land given up";
  return "";
}

/// The same along a curve, where only land near the straight line from one piece to the other is known to be
/// crossed.
std::string not_going_on(const Case& c, const TrackPiece& first, const TrackPiece& second) {
  if (second.subfield != first.subfield || second.track != first.track)
    return "'s continuation belongs to another track";
  const Path before = centre_line(first), behind = centre_line(second);
  const Point gap = second.start - first.end;
  if (length(gap) <= kShortest_m || dot(gap, direction_at_end(before.back())) <= 0 ||
      dot(gap, direction_at_start(behind.front())) <= 0)
    return "'s continuation does not lie ahead";
  const PieceFrame frame(first.end, second.start);
  const double half = 0.5 * c.plan.machine.width_m;
  return clipped(c.passables, frame, {-half, 0, half, frame.length()}).area_m2 > kTouch_m2
             ? ""
             : " is not followed by a passable obstacle";
}

}  // namespace

void check_crossings(const Case& c, Violations& out) {
  const auto& pieces = c.plan.pieces;
  const auto report = [&](std::size_t i, const std::string& why) {
    out.push_back({Rule::kCrossings,
                   fmt::format("{} is flagged as going on after a crossing, but {}", piece_name(i), why),
                   pieces[i].start, 1});
  };
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].after_crossing) continue;
    if (i == 0) {
      report(i, "no piece comes before it");
    } else if (follows_curve(c.plan, pieces[i].subfield) || is_of_lines(c.plan)) {
      if (const std::string why = not_going_on(c, pieces[i - 1], pieces[i]); !why.empty())
        report(i, piece_name(i - 1) + why);
    } else if (const std::string why = not_in_line(pieces[i - 1], pieces[i]); !why.empty()) {
      report(i, fmt::format("{} {}", piece_name(i - 1) + "'s continuation", why));
    } else if (const std::string gap = wrong_gap(c, pieces[i - 1], pieces[i]); !gap.empty()) {
      report(i, "it goes on " + gap);
    }
  }
}

}  // namespace tramline::check
