#pragma once
// Given lines as pieces of tracks.

#include <optional>
#include <vector>

#include "tramline/model/plan.h"
#include "tramline/planner/price/given_lines.h"

namespace tramline {

/// Whether a line that ends where it begins may stay so: a headland pass may, a piece has two ends.
enum class Rings { kStay, kAreOpened };

/// The path that a swath of the given width can follow: without vertices in one place. Arcs are kept where
/// the swath does not fold, else they become chords. nullopt for a line without length.
std::optional<Path> workable_path(const Path& given, double width_m, Rings rings);

/// Whether the swath along a workable path has smooth edges; else it is mitred.
bool has_smooth_edges(const Path& path);

/// The pieces along lines with workable paths, in their order. `hard`: obstacles and other land that ends lie
/// against. `passable`: land between two pieces that makes the second one go on after a crossing. O(n·v) for
/// n pieces and v vertices of that land.
std::vector<TrackPiece> given_pieces(const std::vector<GivenLine>& lines, const Region& hard,
                                     const Region& passable, double width_m);

}  // namespace tramline
