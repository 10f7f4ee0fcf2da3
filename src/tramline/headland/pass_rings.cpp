#include "tramline/headland/pass_rings.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/headland/wide_corners.h"

namespace tramline {
namespace {

/// Land just wide enough to turn on is wide enough: passes come nearer to their boundaries by this, m.
constexpr double kJustFits = 1e-7;
constexpr double kStraightOn = 1e-7;  // rad: less is no turn
constexpr double kNothing = 1e-7;     // m: shorter segments are left out

Point right_of(Point direction) { return {direction.y, -direction.x}; }

Point turned_left(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * p.x - s * p.y, s * p.x + c * p.y};
}

/// An arc about `centre` from the unit vector `out` on, in parts that know their centre well.
void append_arc(Point centre, double radius_m, Point out, double angle, Path& path) {
  constexpr double kMost = 2;
  const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(angle) / kMost)));
  const auto at = [&](int i) { return centre + radius_m * turned_left(out, angle * i / parts); };
  for (int i = 0; i < parts; ++i) path.push_back({at(i), at(i + 1), std::copysign(1 / radius_m, angle)});
}

void append_piece(const LevelPiece& piece, double radius_m, Path& path) {
  const Point out = right_of(piece.from_heading);
  if (piece.segment.straight()) {
    path.push_back(
        {piece.segment.from + radius_m * out, piece.segment.to + radius_m * right_of(piece.to_heading), 0});
    return;
  }
  const double angle =
      std::atan2(cross(piece.from_heading, piece.to_heading), dot(piece.from_heading, piece.to_heading));
  append_arc(piece.centre, radius(piece.segment) - radius_m, -1.0 * out, angle, path);
}

void append_corner(const LevelPiece& before, const LevelPiece& after, double radius_m, Path& path) {
  const Point a = before.to_heading, b = after.from_heading;
  double angle = std::atan2(cross(a, b), dot(a, b));
  if (angle < -0.5 * std::numbers::pi) angle += 2 * std::numbers::pi;  // straight back
  if (angle > kStraightOn) append_arc(before.segment.to, radius_m, right_of(a), angle, path);
}

/// Leaves out what has no length and lets each segment begin where the last one ended.
Path linked(Path path) {
  std::erase_if(path, [](const PathSegment& s) { return distance(s.from, s.to) < kNothing; });
  for (std::size_t i = 0; i < path.size(); ++i) path[i].from = path[i == 0 ? path.size() - 1 : i - 1].to;
  return path;
}

/// Where the centre of the turning circle may be: the circle's far side draws the pass.
std::vector<LevelRing> turning_centres(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                       int number, double radius_m) {
  std::vector<Shore> shores;
  bool any_tight = false;
  for (const Boundary& boundary : boundaries) {
    const double distance_m = pass_distance_m(boundary, number, terms.width_m) - kJustFits;
    shores.push_back({boundary.ring, distance_m});
    any_tight = any_tight || distance_m < radius_m;
  }
  std::vector<ShoreDisc> discs;
  if (any_tight) discs = wide_corners(level_rings(shores), radius_m);
  for (Shore& shore : shores) {
    shore.round_corners = shore.distance_m >= radius_m;
    shore.distance_m += radius_m;
  }
  for (ShoreDisc& disc : discs) disc.radius_m += radius_m;
  return level_rings(shores, discs);
}

/// How much of a ring follows boundaries that have the pass, and boundaries whose passes are used up, m.
/// Those without headland are on neither side: they have to be gone round in any case.
bool worth_driving(const LevelRing& ring, const std::vector<Boundary>& boundaries, int number) {
  double own = 0, used_up = 0;
  for (const LevelPiece& piece : ring) {
    const int passes = boundaries[static_cast<std::size_t>(piece.shore)].passes;
    if (passes >= number)
      own += length(piece.segment);
    else if (passes > 0)
      used_up += length(piece.segment);
  }
  return own > 0 && own >= used_up;
}

HeadlandPass pass_along(const LevelRing& ring, const std::vector<Boundary>& boundaries, int number,
                        double radius_m) {
  HeadlandPass pass{closed_path(ring, radius_m), number, false, {}};
  for (const LevelPiece& piece : ring) {
    const int obstacle = boundaries[static_cast<std::size_t>(piece.shore)].obstacle;
    if (obstacle < 0)
      pass.around_field = true;
    else
      pass.obstacles.push_back(obstacle);
  }
  if (const std::vector<Point> line = chords(pass.path, 1.0); signed_area(line) < 0)
    for (const Boundary& boundary : boundaries)
      if (boundary.obstacle >= 0 && contains(line, boundary.ring.front()))
        pass.obstacles.push_back(boundary.obstacle);
  std::sort(pass.obstacles.begin(), pass.obstacles.end());
  pass.obstacles.erase(std::unique(pass.obstacles.begin(), pass.obstacles.end()), pass.obstacles.end());
  return pass;
}

}  // namespace

Path closed_path(const LevelRing& ring, double radius_m) {
  Path path;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    append_piece(ring[i], radius_m, path);
    append_corner(ring[i], ring[(i + 1) % ring.size()], radius_m, path);
  }
  return linked(std::move(path));
}

std::vector<HeadlandPass> pass_rings(const std::vector<Boundary>& boundaries, const HeadlandTerms& terms,
                                     int number) {
  const double radius_m = std::max(terms.radius_m, 0.5 * terms.width_m);
  std::vector<HeadlandPass> out;
  for (const LevelRing& ring : turning_centres(boundaries, terms, number, radius_m))
    if (worth_driving(ring, boundaries, number))
      out.push_back(pass_along(ring, boundaries, number, radius_m));
  return out;
}

}  // namespace tramline
