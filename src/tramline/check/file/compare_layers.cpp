#include "tramline/check/file/compare_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

void check_order(const std::vector<int>& order, const char* layer, Violations& out) {
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (order[i] == static_cast<int>(i) + 1) continue;
    out.push_back(
        {Rule::kLayers,
         fmt::format("the layer {} numbers its feature {} in driving order as {}", layer, i + 1, order[i]),
         {},
         static_cast<double>(order[i])});
    return;
  }
}

double distance_to_outline(Point p, const Ring& ring) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < ring.size(); ++i)
    out = std::min(out, distance_to_edge({ring[i], ring[i + 1 < ring.size() ? i + 1 : 0], 0}, p, p));
  return out;
}

/// Largest distance between corresponding corners. For rings with different numbers of corners: between a
/// corner of one and the outline of the other, less the possible difference of arcs divided into other
/// chords.
double apart(const Ring& a, const Ring& b) {
  if (b.empty()) return std::numeric_limits<double>::infinity();
  double out = 0;
  if (a.size() == b.size()) {
    for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, distance(a[i], b[i]));
    return out;
  }
  for (const Point p : a) out = std::max(out, distance_to_outline(p, b));
  for (const Point p : b) out = std::max(out, distance_to_outline(p, a));
  return std::max(0.0, out - kChordSagitta);
}

}  // namespace

std::vector<Violation> compare_swaths(const Plan& plan, const std::vector<int>& track_order,
                                      const Region& swaths, const std::vector<int>& swath_order) {
  std::vector<Violation> out;
  check_order(track_order, "tracks", out);
  check_order(swath_order, "swaths", out);
  if (swaths.size() != plan.pieces.size()) {
    out.push_back({Rule::kLayers,
                   fmt::format("there are {} swaths for {} tracks", swaths.size(), plan.pieces.size()),
                   {},
                   static_cast<double>(swaths.size()) - static_cast<double>(plan.pieces.size())});
    return out;
  }
  for (std::size_t i = 0; i < swaths.size(); ++i) {
    const TrackPiece& piece = plan.pieces[i];
    const double off = swaths[i].holes.empty() ? apart(swath(piece, plan.machine.width_m), swaths[i].outer)
                                               : std::numeric_limits<double>::infinity();
    if (!(off <= kSaidTwice))
      out.push_back({Rule::kLayers,
                     fmt::format("the swath stored for {} is not the one its track works: {:.6f} m apart",
                                 piece_name(i), off),
                     midpoint(piece.start, piece.end), off});
  }
  return out;
}

void compare_text(const std::string& where, const std::string& stored, const std::string& from_shape,
                  Point at, std::vector<Violation>& out) {
  if (stored == from_shape) return;
  out.push_back({Rule::kLayers,
                 fmt::format("{} is stored as '{}', its shape gives '{}'", where, stored, from_shape), at,
                 1});
}

void compare_number(const std::string& where, double stored, double from_shape, double rounding, Point at,
                    std::vector<Violation>& out) {
  const double tolerance = rounding + kSaidTwice * std::max(1.0, std::abs(from_shape));
  if (std::abs(stored - from_shape) <= tolerance) return;
  out.push_back({Rule::kLayers,
                 fmt::format("{} is stored as {:.6f}, its shape gives {:.6f}", where, stored, from_shape), at,
                 stored - from_shape});
}

}  // namespace tramline::check
