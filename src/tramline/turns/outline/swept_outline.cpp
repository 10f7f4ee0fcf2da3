#include "tramline/turns/outline/swept_outline.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/turns/outline/even_motion.h"
#include "tramline/turns/outline/tolerances.h"
#include "tramline/turns/outline/towed_motion.h"

namespace tramline {
namespace {

/// Adds what a side covers whose ends move in chords: the quadrilateral between its two places, or two
/// triangles where these cross.
void add_swept_side(Region& out, Point a, Point b, Point b_after, Point a_after) {
  const Ring quad{a, b, b_after, a_after};
  if (convex_hull(quad).empty()) return;
  std::array<double, 4> turns{};
  for (std::size_t i = 0; i < quad.size(); ++i)
    turns[i] = cross(quad[(i + 1) % 4] - quad[i], quad[(i + 2) % 4] - quad[(i + 1) % 4]);
  const auto [least, most] = std::minmax_element(turns.begin(), turns.end());
  if (*least > 0 || *most < 0) {
    out.push_back(oriented({quad, {}}));
  } else {
    for (Polygon& part : made_valid({quad, {}})) out.push_back(std::move(part));
  }
}

void add_part(Region& out, const Box& part, const Placement& frame) {
  Ring ring;
  for (const Point corner : corners_of(part)) ring.push_back(to_ground(frame, corner));
  if (part.width() > 0 && part.height() > 0) out.push_back({ring, {}});
}

void add_even_sweep(Region& out, const Box& part, const EvenMotion& motion, double sagitta_m) {
  const double farthest = std::hypot(farthest_corner_m(part), motion.way_m);
  const double steps = std::ceil(std::abs(motion.turn_rad) * std::sqrt(farthest / (8 * sagitta_m))) + 1;
  Placement before = motion.start;
  add_part(out, part, before);
  const auto corners = corners_of(part);
  for (double i = 1; i <= steps; ++i) {
    const double share = i / steps;
    const Placement after = end_of(EvenMotion{motion.start, share * motion.way_m, share * motion.turn_rad});
    add_part(out, part, after);
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Point next = corners[(k + 1) % corners.size()];
      if (corners[k] == next) continue;
      add_swept_side(out, to_ground(before, corners[k]), to_ground(before, next), to_ground(after, next),
                     to_ground(after, corners[k]));
    }
    before = after;
  }
}

template <class PieceOf>
void add_sweep(Region& out, const Box& part, double from_m, double to_m, double sagitta_m,
               const PieceOf& piece_of) {
  const MotionPiece piece = piece_of(from_m, to_m);
  if (piece.margin_m(part) <= 0.5 * sagitta_m) {
    add_even_sweep(out, part, piece.even, 0.5 * sagitta_m);
    return;
  }
  const double middle = 0.5 * (from_m + to_m);
  add_sweep(out, part, from_m, middle, sagitta_m, piece_of);
  add_sweep(out, part, middle, to_m, sagitta_m, piece_of);
}

}  // namespace

Region swept_outline(const SteeredPath& path, const Outline& outline, double sagitta_m) {
  assert(sagitta_m > 0);
  Region out;
  for (const SteeredStretch& stretch : path)
    for (const Box& part : outline.on_machine)
      add_sweep(out, part, 0, stretch.length_m, sagitta_m,
                [&](double from_m, double to_m) { return machine_motion(stretch, from_m, to_m); });
  if (outline.tows()) {
    const TowedMotion motion(path, outline);
    for (std::size_t i = 0; i < path.size(); ++i) {
      const double pieces = motion.pieces(i);
      for (const Box& part : outline.on_implement)
        for (double k = 0; k < pieces; ++k)
          add_sweep(out, part, k / pieces * path[i].length_m, (k + 1) / pieces * path[i].length_m, sagitta_m,
                    [&](double from_m, double to_m) { return motion.motion(i, from_m, to_m); });
    }
  }
  return unite(out);
}

}  // namespace tramline
