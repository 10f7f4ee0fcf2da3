#include "tramline/geometry/path/smoothed_line.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/line_crossing.h"
#include "tramline/geometry/path/merged_kinks.h"
#include "tramline/geometry/path/simplified_line.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Wider arcs have centres so far away that distances from them lose digits, m.
constexpr double kWidest = 1e5;

/// Required and preferred length of the tangents of the arc at a kink.
struct Tangents {
  double least = 0;
  double wanted = 0;
};

Tangents tangents_at(double turn, double radius, double tolerance) {
  if (std::abs(turn) < kLeastKink_rad) return {};
  const double tangent = std::tan(0.5 * std::abs(turn)), least = radius * tangent;
  // An arc with tangents this long leaves the vertex by length·tan(turn/4).
  const double widest = std::min(tolerance / std::tan(0.25 * std::abs(turn)), kWidest * tangent);
  return {least, std::max(least, widest)};
}

std::vector<double> tangent_lengths(const std::vector<Point>& line, double radius, double tolerance) {
  std::vector<Tangents> asked(line.size());
  for (std::size_t i = 1; i + 1 < line.size(); ++i)
    asked[i] = tangents_at(turn_at(line[i - 1], line[i], line[i + 1]), radius, tolerance);
  std::vector<double> out;
  for (const Tangents& t : asked) out.push_back(t.wanted);
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Tangents &a = asked[i], &b = asked[i + 1];
    const double edge = distance(line[i], line[i + 1]), more = a.wanted + b.wanted - a.least - b.least;
    if (a.wanted + b.wanted <= edge) continue;
    const double share = more > 0 ? std::max(0.0, edge - a.least - b.least) / more : 0;
    out[i] = std::min(out[i], a.least + share * (a.wanted - a.least));
    out[i + 1] = std::min(out[i + 1], b.least + share * (b.wanted - b.least));
  }
  return out;
}

Path rounded(const std::vector<Point>& line, double radius, double tolerance) {
  const std::vector<double> tangents = tangent_lengths(line, radius, tolerance);
  Path path;
  Point at = line.front();
  for (std::size_t i = 1; i + 1 < line.size(); ++i) {
    const double turn = turn_at(line[i - 1], line[i], line[i + 1]);
    if (std::abs(turn) < kLeastKink_rad) continue;
    const Point back = line[i - 1] - line[i], on = line[i + 1] - line[i];
    Point from = line[i] + (tangents[i] / length(back)) * back;
    const Point to = line[i] + (tangents[i] / length(on)) * on;
    // Tangents may overlap by rounding: then the straight part between them would run backwards.
    if (dot(at - from, back) < kShortestStraight_m * length(back))
      from = at;
    else
      path.push_back({at, from, 0});
    path.push_back({from, to, std::tan(0.5 * turn) / tangents[i]});
    at = to;
  }
  if (distance(at, line.back()) >= kShortestStraight_m || path.empty())
    path.push_back({at, line.back(), 0});
  else
    path.back().to = line.back();
  return path;
}

/// Distances to many short edges.
class Nearness {
 public:
  explicit Nearness(const std::vector<Point>& line) : line_(line) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      boxes.emplace_back();
      boxes.back().extend(line[i]);
      boxes.back().extend(line[i + 1]);
    }
    grid_ = BoxGrid(boxes);
  }

  double distance_to(Point p) const {
    const double most = grid_.bounds().width() + grid_.bounds().height();
    for (double reach = 0.1 * grid_.cell_m();; reach *= 4) {
      Box window;
      window.extend(p);
      double least = std::numeric_limits<double>::infinity();
      grid_.each_meeting(window.grown(reach), [&](std::size_t i) {
        least = std::min(least, distance_to_segment(p, line_[i], line_[i + 1]));
      });
      if (least <= reach || reach > 1e3 * most) return least;
    }
  }

 private:
  const std::vector<Point>& line_;
  BoxGrid grid_;
};

/// Both ways: at the polyline's vertices, and at the vertices and arcs' middles of the path.
void measure_deviation(const std::vector<Point>& polyline, const std::vector<Point>& distinct,
                       Smoothed& out) {
  const auto weigh = [&out](Point p, const Nearness& line) {
    const double off = line.distance_to(p);
    if (off <= out.deviation_m) return;
    out.deviation_m = off;
    out.worst = p;
  };
  const std::vector<Point> driven = chords(out.path, kMeasuredSagitta_m);
  const Nearness to_path(driven), to_line(distinct);
  out.worst = polyline.front();
  for (const Point p : polyline) weigh(p, to_path);
  for (const Point p : driven) weigh(p, to_line);
}

}  // namespace

SmoothedOrRefused try_smoothed(const std::vector<Point>& polyline, double radius_m, double tolerance_m) {
  const auto refused = [](std::string why) { return SmoothedOrRefused{std::nullopt, std::move(why)}; };
  const std::vector<std::size_t> names = simplified_line(polyline, tolerance_m);
  if (names.size() < 2) return refused("a reference line needs two points that differ");
  std::vector<Point> kept, distinct;
  for (const std::size_t i : names) kept.push_back(polyline[i]);
  for (const std::size_t i : simplified_line(polyline, 0)) distinct.push_back(polyline[i]);
  if (const auto edges = self_crossing(kept))
    return refused("the reference line crosses or touches itself: the edges after its vertices " +
                   std::to_string(names[edges->first]) + " and " + std::to_string(names[edges->second]) +
                   " (numbered from 0) meet");
  const MergedKinks merged = merged_kinks(kept, radius_m);
  if (merged.hairpin)
    return refused("the reference line turns more sharply than the machine can at its vertex " +
                   std::to_string(names[*merged.hairpin]) + " (numbered from 0): leave the hairpin out");
  Smoothed out{rounded(merged.line, radius_m, tolerance_m)};
  const std::vector<Point> driven = chords(out.path, kCrossedSagitta_m);
  if (const auto edges = self_crossing(driven)) {
    const auto near = std::min_element(names.begin(), names.end(), [&](std::size_t a, std::size_t b) {
      return distance(polyline[a], driven[edges->first]) < distance(polyline[b], driven[edges->first]);
    });
    return refused("rounded for the machine, the reference line crosses itself near its vertex " +
                   std::to_string(*near) + " (numbered from 0)");
  }
  measure_deviation(polyline, distinct, out);
  return {std::move(out), ""};
}

Smoothed smoothed(const std::vector<Point>& polyline, double radius_m, double tolerance_m) {
  SmoothedOrRefused out = try_smoothed(polyline, radius_m, tolerance_m);
  if (!out.smoothed) throw bad_input(out.refusal);
  return std::move(*out.smoothed);
}

}  // namespace tramline
