#include "headland/headland_faults.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/path_stretch.h"

namespace tramline::testing {
namespace {

using Faults = std::vector<std::string>;

double angle_between_units(Point a, Point b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

void look_at_path(const HeadlandPass& pass, double tightest, Faults& out) {
  const Path& path = pass.path;
  const std::size_t joints = is_closed(pass) ? path.size() : path.size() - 1;
  for (std::size_t i = 0; i < joints; ++i) {
    const PathSegment &segment = path[i], &next = path[(i + 1) % path.size()];
    if (!(segment.to == next.from))
      out.push_back(fmt::format("pass {} has a gap of {} m", pass.number, distance(segment.to, next.from)));
    const double kink = angle_between_units(direction_at_end(segment), direction_at_start(next));
    if (!(kink < 1e-6))
      out.push_back(fmt::format(
          "pass {} has a kink of {} rad at ({}, {}) before {} m of curvature {}, after {} m", pass.number,
          kink, segment.to.x, segment.to.y, length(next), next.curvature, length(segment)));
    if (distance(segment.from, segment.to) * std::abs(segment.curvature) > 2)
      out.push_back(fmt::format("pass {} has an impossible arc", pass.number));
  }
  if (smallest_radius(path) < tightest * (1 - 1e-9))
    out.push_back(fmt::format("pass {} has a radius of {} m", pass.number, smallest_radius(path)));
}

/// Chords that cross one another for certain. Paths that touch themselves are not found.
void look_at_crossings(const HeadlandPass& pass, Faults& out) {
  std::vector<Point> ring = chords(pass.path, 1e-3);
  if (is_closed(pass)) ring.pop_back();
  const std::size_t edges = is_closed(pass) ? ring.size() : ring.size() - 1;
  const auto side = [](Point a, Point b, Point c) { return cross(b - a, c - a) / distance(a, b); };
  const auto parts = [&](Point a, Point b, Point c, Point d) {
    return std::min(side(a, b, c), side(a, b, d)) < -1e-3 && std::max(side(a, b, c), side(a, b, d)) > 1e-3;
  };
  for (std::size_t i = 0; i < edges; ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[j], d = ring[(j + 1) % ring.size()];
      if (std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x)) continue;
      if (parts(a, b, c, d) && parts(c, d, a, b))
        out.push_back(fmt::format("pass {} crosses itself near ({}, {})", pass.number, a.x, a.y));
    }
}

double distance_to_ring(const Path& path, const std::vector<Box>& reaches, const Ring& ring, double enough) {
  double out = enough;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    const Box edge = bounds(a, b);
    for (std::size_t k = 0; k < path.size(); ++k)
      if (intersects(edge, reaches[k])) out = std::min(out, distance_to_edge(path[k], a, b));
  }
  return out;
}

/// Of the distance from obstacles the clearance is taken off.
void look_at_sides(const Field& field, const HeadlandTerms& terms, const HeadlandPass& pass, Faults& out) {
  const double width = terms.width_m, enough = width + terms.clearance_m;
  const std::vector<Box> reaches = reaches_of(pass.path, enough);
  double nearest = distance_to_ring(pass.path, reaches, field.outer, width);
  bool inside = contains(field.outer, pass.path.front().from);
  for (const Obstacle& obstacle : field.obstacles) {
    if (obstacle.kind == ObstacleKind::kPassable) continue;
    const double away = distance_to_ring(pass.path, reaches, obstacle.shape.outer, enough);
    nearest = std::min(nearest, away - terms.clearance_m);
    inside = inside && !contains(obstacle.shape.outer, pass.path.front().from);
  }
  // Where an open pass is driven straight on, boundaries may reach a tenth of a millimetre into its sides.
  const double nearer = is_closed(pass) ? 1e-6 : 1e-4 + 1e-6;
  if (nearest < 0.5 * width - nearer)
    out.push_back(fmt::format("pass {} comes to {} m of a boundary", pass.number, nearest));
  if (!inside) out.push_back(fmt::format("pass {} is not in the field", pass.number));
}

/// An open pass may run with its end up to a boundary: flat as it ends there its swath is in the field.
void look_at_ends(const Field& field, const HeadlandTerms& terms, const HeadlandPass& pass, Faults& out) {
  constexpr double kBeside = 2e-4;  // m
  const double width = terms.width_m;
  Region land{{field.outer, {}}};
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kObstacle)
      land = difference(land, terms.clearance_m > 0 ? buffered({obstacle.shape}, terms.clearance_m)
                                                    : Region{obstacle.shape});
  for (const double end : {0.0, length(pass.path) - 0.5 * width}) {
    const Path part =
        stretch_of(pass.path, std::max(0.0, end), std::min(end + 0.5 * width, length(pass.path)));
    const double beyond = area(difference({{band(part, width), {}}}, land));
    if (beyond > kBeside * width)
      out.push_back(fmt::format("pass {} works {} m² beyond a boundary at one end", pass.number, beyond));
  }
}

void look_at_place(const Field& field, const HeadlandTerms& terms, const HeadlandPass& pass, Faults& out) {
  const double width = terms.width_m;
  if (!is_closed(pass)) {
    look_at_ends(field, terms, pass, out);
    if (length(pass.path) < 1.01 * width) return;
    HeadlandPass middle = pass;
    middle.path = stretch_of(pass.path, 0.5 * width, length(pass.path) - 0.5 * width);
    look_at_sides(field, terms, middle, out);
    return;
  }
  look_at_sides(field, terms, pass, out);
}
/// Land that two bands share, m².
double shared(const Path& a, const Path& b, double width) {
  RisingCurves curves;
  append_band(a, width, Layer::kBody, curves);
  append_band(b, width, Layer::kNew, curves);
  return newly_covered_area(curves);
}

/// Land worked twice by passes, each pair by itself. What three share counts three times instead of twice.
double shared_by_pairs(const HeadlandAndBody& headland, double width) {
  double sum = 0;
  const auto& passes = headland.passes;
  for (std::size_t i = 0; i < passes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!intersects(reach_of(passes[i].path, width), reach_of(passes[j].path, width))) continue;
      sum += shared(passes[i].path, passes[j].path, width);
    }
  return sum;
}

void look_at_areas(const Field& field, double width, const HeadlandAndBody& headland, Faults& out) {
  double obstacles = 0, all_around = perimeter(field.outer), driven = 0, wide = 0;
  bool passable = false;
  for (const Obstacle& obstacle : field.obstacles) {
    obstacles += area(obstacle.shape);
    all_around += perimeter(obstacle.shape.outer);
    passable = passable || obstacle.kind == ObstacleKind::kPassable;
  }
  for (const Region* region : {&headland.ground, &headland.body})
    for (const Ring& ring : rings_of(*region)) all_around += perimeter(ring);
  for (const HeadlandPass& pass : headland.passes) {
    driven += length(pass.path);
    wide += width * length(pass.path);
  }
  const double whole = std::abs(signed_area(field.outer));
  const double parts = area(headland.ground) + area(headland.body) + obstacles;
  if (std::abs(whole - parts) > 1e-5 * all_around)
    out.push_back(fmt::format("ground, body and obstacles make {} m², the field has {}", parts, whole));
  const double balance = area(headland.ground) - headland.uncovered_m2 + headland.overlap_m2;
  if (std::abs(headland.worked_m2 - balance) > 1e-6 * std::max(1.0, headland.worked_m2))
    out.push_back(fmt::format("worked {} m², but the balance says {}", headland.worked_m2, balance));
  if (passable ? headland.worked_m2 > wide : std::abs(headland.worked_m2 - wide) > 1e-6 * wide)
    out.push_back(fmt::format("worked {} m², driven {} m²", headland.worked_m2, wide));
  const double drawn = area(unworked_ground(headland, width));
  if (std::abs(drawn - headland.uncovered_m2) > 2e-3 * driven + 1e-5 * all_around)
    out.push_back(fmt::format("uncovered {} m², drawn {}", headland.uncovered_m2, drawn));
  const double pairs = shared_by_pairs(headland, width);
  if (!passable && headland.passes.size() < 3 && pairs > headland.overlap_m2 + 1e-6 * wide)
    out.push_back(fmt::format("passes share {} m², overlap is {}", pairs, headland.overlap_m2));
}

}  // namespace

std::vector<std::string> faults_of(const Field& field, const HeadlandTerms& terms,
                                   const HeadlandAndBody& headland) {
  Faults out;
  for (const HeadlandPass& pass : headland.passes) {
    if (pass.path.empty()) {
      out.push_back("a pass without a path");
      continue;
    }
    look_at_path(pass, tightest_m(terms), out);
    look_at_crossings(pass, out);
    look_at_place(field, terms, pass, out);
  }
  look_at_areas(field, terms.width_m, headland, out);
  return out;
}

double tightest_m(const HeadlandTerms& terms) { return std::max(terms.radius_m, 0.5 * terms.width_m); }

HeadlandTerms terms_of(const Field& field, double width_m, double radius_m, int passes) {
  return {width_m, radius_m, passes, std::vector<int>(field.obstacles.size(), passes)};
}

}  // namespace tramline::testing
