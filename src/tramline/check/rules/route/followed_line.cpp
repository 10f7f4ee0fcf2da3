#include "tramline/check/rules/route/followed_line.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <utility>

namespace tramline::check {
namespace {

constexpr double kTurnsAtMost = 0.5;
constexpr double kKink = 1e-6, kSharperShare = 1e-6;
constexpr double kSamePlace_m = 1e-6;

double turned(Point ahead, Point from) { return dot(ahead, from) > 0 ? std::abs(cross(ahead, from)) : 1; }

}  // namespace

std::vector<LinePiece> pieces_from(const WorkedCourse& course, double sense) {
  const double begin_m = course.ahead_m(), end_m = course.ahead_m() + course.length_m();
  std::vector<LinePiece> out;
  const auto add = [&](double from_m, double to_m, double curvature) {
    const double length_m = std::min(to_m, end_m) - std::max(from_m, begin_m);
    if (length_m > 0) out.push_back({length_m, curvature});
  };
  constexpr double kBeyond_m = std::numeric_limits<double>::infinity();
  add(-kBeyond_m, 0, 0);
  double at_m = 0;
  for (const PathSegment& segment : course.line().path()) {
    add(at_m, at_m + length(segment), segment.straight() ? 0 : segment.curvature);
    at_m += length(segment);
  }
  add(at_m, kBeyond_m, 0);
  if (sense < 0) std::ranges::reverse(out);
  return out;
}

std::vector<LinePiece> pieces_behind(const WorkedCourse& course, double sense, double from_m) {
  std::vector<LinePiece> out = pieces_from(course, sense);
  double at_m = 0;
  std::erase_if(out, [&](const LinePiece& piece) {
    const double begins_m = std::exchange(at_m, at_m + piece.length_m);
    return begins_m < from_m - kSamePlace_m;
  });
  return out;
}

bool can_drive(const LinePiece& piece, double radius_m) {
  return std::abs(piece.curvature) * radius_m <= 1 + kSharperShare;
}

bool kinked_at(const WayEnd& end, double at_m) {
  constexpr double kJust_m = 1e-9;
  return turned(end.backed(at_m + kJust_m).heading.unit(), end.backed(at_m - kJust_m).heading.unit()) > kKink;
}

void follow_line(WayEnd& end, double radius_m, Followed followed) {
  assert(end.course && radius_m > 0);
  const Point heading = end.at.heading.unit();
  Point before = heading;
  double at_m = 0;
  const std::vector<LinePiece> pieces = pieces_behind(*end.course, end.sense, end.behind_m);
  for (const LinePiece& piece : pieces) {
    // A position at a kink itself may be on either side of it; headings turn by nothing within so little.
    constexpr double kJustInside_m = 1e-9;
    const double inside_m = std::min(kJustInside_m, 0.5 * piece.length_m);
    const Point first = end.backed(at_m + inside_m).heading.unit();
    const Point last = end.backed(at_m + piece.length_m - inside_m).heading.unit();
    if (turned(first, before) > kKink) break;
    if (followed == Followed::kStraight && piece.curvature != 0) break;
    if (!can_drive(piece, radius_m)) break;
    if (std::max(turned(first, heading), turned(last, heading)) > kTurnsAtMost) break;
    end.turns = std::max(end.turns, turned(last, heading));
    before = last;
    at_m += piece.length_m;
    end.to_far_end = &piece == &pieces.back();
  }
  end.follows_m = at_m;
}

}  // namespace tramline::check
