#pragma once
// The distances of passes from boundaries.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/geometry/offset/offset_rings.h"
#include "tramline/headland/headland.h"

namespace tramline {

/// A boundary that no swath crosses.
struct Boundary {
  Ring ring;  ///< the free land on its left; vertices off the ring through the others by up to kIdleVertex_m
              ///< are left out
  int passes = 0;                         ///< of its headland
  std::optional<std::size_t> obstacle{};  ///< index into Field::obstacles; nullopt: the field's outer ring
  double clearance_m = 0;                 ///< to all swaths
};

/// The field's outer ring, then the obstacles that are not passable, without their holes.
std::vector<Boundary> boundaries_of(const Field& field, const HeadlandTerms& terms);

/// Distance between the boundary and the centre line of a pass, m (Zhou §2.3.3, who has no
/// clearance).
double pass_distance_m(const Boundary& boundary, int pass, double width_m);

/// How deep the headland of so many passes is, with the clearance, m.
double headland_depth_m(const Boundary& boundary, int passes, double width_m);

/// Land inside obstacles that have a headland, but for the clearance: the headland lies outside.
Region land_inside_obstacles(const Field& field, const std::vector<Boundary>& boundaries);

/// The land free for tracks as far as headlands are concerned, as a region with chords (kBodySagitta):
/// obstacles without headland are still in it, and land outside where the field has no headland.
Region land_behind_headlands(const std::vector<Boundary>& boundaries, double width_m);

}  // namespace tramline
