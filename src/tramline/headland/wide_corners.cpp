#include "tramline/headland/wide_corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tramline/geometry/offset/offset_curve.h"
#include "tramline/geometry/polygon/smallest_disc.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// A line is too near to a boundary only where it would be so a little longer, m.
constexpr double kMargin_m = 1e-3;

/// The offset line's arc about a corner.
struct TightArc {
  Point corner;
  double slack_m = 0;  ///< a disc covers the arc if its centre is no farther than this from the corner
  Point first{};       ///< unit vectors from the corner to the arc's ends
  Point last{};
  double turned_rad = 0;  ///< from the first one to the last one
  std::size_t offset_boundary = 0;

  double offset_radius_m(double radius_m) const { return radius_m - slack_m; }
};

/// Consecutive arcs with one disc.
struct Group {
  std::vector<TightArc> arcs;
  Point centre;
  std::optional<Point> ahead{};  ///< from the centre to the land; nullopt: on all sides
};

Point turned_right(Point direction, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * direction.x + s * direction.y, c * direction.y - s * direction.x};
}

double angle_right(Point from, Point to) { return std::atan2(-cross(from, to), dot(from, to)); }

bool covers(Point centre, const std::vector<TightArc>& arcs, std::size_t count) {
  return std::all_of(
      arcs.begin(), arcs.begin() + static_cast<std::ptrdiff_t>(count),
      [&](const TightArc& arc) { return distance(centre, arc.corner) <= arc.slack_m + kTouch_m; });
}

/// The centre that covers the arcs and lies farthest back, away from the land; false where there is none.
/// Adds the arcs one by one: if one is not covered, the new centre is as far from it as allowed.
bool farthest_back(const std::vector<TightArc>& arcs, Point back, Point& centre) {
  for (std::size_t i = 0; i < arcs.size(); ++i) {
    const TightArc& arc = arcs[i];
    if (i > 0 && covers(centre, {arc}, 1)) continue;
    std::vector<Point> candidates{arc.corner + arc.slack_m * back};
    for (std::size_t j = 0; j < i; ++j) {
      const Point apart = arcs[j].corner - arc.corner;
      const double d = length(apart);
      if (d < kTouch_m) continue;
      const double r = arc.slack_m, s = arcs[j].slack_m;
      const double ahead = 0.5 * (d + (r - s) * (r + s) / d), aside = r * r - ahead * ahead;
      if (aside < 0) continue;
      const Point unit = (1 / d) * apart;
      for (const double sign : {-1.0, 1.0})
        candidates.push_back(arc.corner + ahead * unit + sign * std::sqrt(aside) * Point{-unit.y, unit.x});
    }
    std::erase_if(candidates, [&](Point p) { return !covers(p, arcs, i + 1); });
    if (candidates.empty()) return false;
    centre = *std::max_element(candidates.begin(), candidates.end(),
                               [&](Point p, Point q) { return dot(p, back) < dot(q, back); });
  }
  return true;
}

/// Finds the disc for all arcs of a group.
bool find_disc(Group& group) {
  const auto& arcs = group.arcs;
  double turned = arcs.front().turned_rad;
  for (std::size_t i = 1; i < arcs.size(); ++i)
    turned += angle_right(arcs[i - 1].last, arcs[i].first) + arcs[i].turned_rad;
  // Arcs that turn nearly all round a small obstacle have no common side to move the disc to.
  if (turned > 1.25 * std::numbers::pi) {
    std::vector<Point> corners;
    for (const TightArc& arc : arcs) corners.push_back(arc.corner);
    group.centre = smallest_disc(corners).centre;
    group.ahead.reset();
    return covers(group.centre, arcs, arcs.size());
  }
  group.ahead = turned_right(arcs.front().first, 0.5 * turned);
  return farthest_back(arcs, -1.0 * *group.ahead, group.centre);
}

/// Largest depth of the arcs' ends and middles in any of the discs.
double depth(const std::vector<const Group*>& arcs_of, const std::vector<Point>& centres, double radius_m) {
  double out = 0;
  for (const Group* group : arcs_of)
    for (const TightArc& arc : group->arcs)
      for (const Point out_of_corner : {arc.first, turned_right(arc.first, 0.5 * arc.turned_rad), arc.last})
        for (const Point centre : centres)
          out = std::max(
              out, radius_m - distance(centre, arc.corner + arc.offset_radius_m(radius_m) * out_of_corner));
  return out;
}

/// Joins two groups into one, where that is possible and takes no more of the land.
bool join(Group& a, const Group& b, double radius_m) {
  Group both = a;
  both.arcs.insert(both.arcs.end(), b.arcs.begin(), b.arcs.end());
  if (!find_disc(both)) return false;
  if (depth({&both}, {both.centre}, radius_m) > depth({&a, &b}, {a.centre, b.centre}, radius_m) + kTouch_m)
    return false;
  a = std::move(both);
  return true;
}

std::vector<Group> tight_arcs(const OffsetRing& ring, double radius_m) {
  std::vector<Group> out;
  for (const OffsetPiece& piece : ring) {
    const double offset_radius = radius(piece.segment);
    if (piece.segment.straight() || offset_radius >= radius_m) continue;
    const Point first{-piece.from_heading.y, piece.from_heading.x};
    const Point last{-piece.to_heading.y, piece.to_heading.x};
    Group group{{{piece.centre, radius_m - offset_radius, first, last, std::abs(turning(piece.segment)),
                  piece.offset_boundary}},
                {},
                {}};
    find_disc(group);
    out.push_back(std::move(group));
  }
  return out;
}

bool meets(const OffsetCurve& line, const OffsetPiece& piece) {
  const PathSegment& segment = piece.segment;
  if (segment.straight()) {
    const Box box = bounds(segment.from, segment.to).grown(kTouch_m);
    return intersects(box, line.box) && !meetings(line, offset_line(segment.from, segment.to)).empty();
  }
  const double radius_m = radius(segment);
  if (distance_to_segment(piece.centre, line.from, line.to) > radius_m + kTouch_m) return false;
  return !meetings(line, offset_arc(piece.centre, radius_m, segment.from, segment.to)).empty();
}

/// Whether a line through a place in the middle that is too near to a boundary is so all along, by this much
/// to both sides.
bool is_too_near(Point middle, Point along, double half_m, const std::vector<OffsetRing>& all) {
  const OffsetCurve line = offset_line(middle - half_m * along, middle + half_m * along);
  return std::ranges::none_of(all, [&](const OffsetRing& ring) {
    return std::ranges::any_of(ring, [&](const OffsetPiece& piece) { return meets(line, piece); });
  });
}

/// The disc of a group, or the part of it ahead of its corners where the line that cuts it off is too near to
/// the boundaries all along: then no end of that line lies in the land. turning_centres() makes disc and
/// distances larger by a radius r. There the half line, of √((2r)² - s²) at a distance s from the centre, is
/// too near where this one is so up to r before its end, which is beyond √(r² - s²).
OffsetDisc disc_of(const Group& group, double radius_m, const std::vector<OffsetRing>& all) {
  OffsetDisc out{group.centre, radius_m + kCoversSurely_m, group.arcs.front().offset_boundary};
  if (!group.ahead) return out;
  const auto ahead_m = [&](const TightArc& arc) { return dot(*group.ahead, arc.corner - group.centre); };
  const TightArc& rearmost = *std::ranges::min_element(group.arcs, {}, ahead_m);
  const double line_m = ahead_m(rearmost), square_m2 = out.radius_m * out.radius_m - line_m * line_m;
  if (square_m2 <= 0) return out;
  const Point middle = group.centre + line_m * *group.ahead;
  if (distance(middle, rearmost.corner) >= rearmost.offset_radius_m(radius_m)) return out;
  const double half_m = std::sqrt(square_m2 + 3 * radius_m * radius_m) - radius_m + kMargin_m;
  if (!is_too_near(middle, left_of(*group.ahead), half_m, all)) return out;
  out.ahead = *group.ahead;
  out.line_m = line_m;
  return out;
}

}  // namespace

std::vector<OffsetDisc> wide_corners(const std::vector<OffsetRing>& rings, const std::vector<OffsetRing>& all,
                                     double radius_m) {
  std::vector<OffsetDisc> out;
  for (const OffsetRing& ring : rings) {
    std::vector<Group> groups = tight_arcs(ring, radius_m);
    for (bool joined = groups.size() > 1; joined && groups.size() > 1;) {
      joined = false;
      for (std::size_t i = 0; i < groups.size() && groups.size() > 1;) {
        const std::size_t next = (i + 1) % groups.size();
        if (!join(groups[i], groups[next], radius_m)) {
          ++i;
          continue;
        }
        groups.erase(groups.begin() + static_cast<std::ptrdiff_t>(next));
        joined = true;
        if (next == 0) break;
      }
    }
    for (const Group& group : groups) out.push_back(disc_of(group, radius_m, all));
  }
  return out;
}

}  // namespace tramline
