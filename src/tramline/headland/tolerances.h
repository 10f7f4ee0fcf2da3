#pragma once
// Tolerances of passes and their offset lines, and of the distance that passes keep. Tolerances of a single
// algorithm stand with it.

#include "tramline/geometry/tolerances.h"

namespace tramline {

// Tolerances of lengths.

/// Excess of a circle's radius over the machine's, m: what the circle just touches is then nearer for sure.
inline constexpr double kCoversSurely_m = 1e-8;
/// Shorter pieces of a path or of an offset line are left out, m: the nodes where they end are not exact
/// enough to give them a heading.
inline constexpr double kShortestPiece_m = 1e-7;
/// Circles that roll along centre lines may touch them beyond their ends by this, m: each end is a node.
inline constexpr double kBeyondCentreLine_m = 1e-7;
/// Vertices of a boundary that are no farther from the line through their neighbours are left out, m.
inline constexpr double kIdleVertex_m = 1e-7;
/// Passes may come nearer to their boundaries by this, m, so that land just wide enough to turn on is wide
/// enough.
inline constexpr double kJustFits_m = 1e-7;
/// A pass may come nearer to a boundary than it should by this, m: the sum of the slack for land that just
/// fits and of the vertices left out.
inline constexpr double kNearerPass_m = 2e-7;
/// Groups of passes may come nearer to another boundary by this, m, without meeting it: the error of a
/// distance on the precision grid.
inline constexpr double kNearerGroup_m = 1e-6;
/// Pieces of a ring that are no longer may lie on no centre line, m: there are such where rings of two offset
/// lines join.
inline constexpr double kOffCentreLines_m = 1e-5;
/// An edge of a plain pass whose middle is no farther from the offset of a boundary follows it, m: both were
/// cut on the precision grid, and vertices within kMitredIdle_m left out.
inline constexpr double kOnPlainRing_m = 1e-4;
/// What reaches into a swath's sides by no more is not in its way, m: chords of bodies and boundaries lie
/// beside arcs.
inline constexpr double kBeside_m = 1e-4;
/// A pass is not extended by less, m.
inline constexpr double kNoRun_m = 1e-4;

// Tolerances of headings.

/// A smaller turn is none, rad.
inline constexpr double kStraightOn_rad = 1e-7;
/// A pass that turns by more at a joint has a kink there, rad: joints are inexact by the effect of grid and
/// nodes on short pieces.
inline constexpr double kKink_rad = 1e-6;

// Tolerances of areas.

/// A path whose area is less than width · length by more than this meets itself, m²: rounding of the area of
/// a long pass.
inline constexpr double kSelfOverlap_m2 = 1e-6;
/// Rings are better only if they leave and double less ground by more than this, m²: less is rounding.
inline constexpr double kNoGain_m2 = 1e-3;
/// Smaller polygons between passes are gaps between chords where bands meet, m².
inline constexpr double kBandsMeet_m2 = 1e-3;

// Largest distances between arcs and the chords that replace them.

/// The largest distance between the edge of the body about a corner, an arc, and the chords that replace it,
/// m.
inline constexpr double kBodySagitta = 1e-3;

// What has to be nearer or farther for sure is so by more than distances are distinguished by, and by less
// than the slack for what fits.
static_assert(kSameDistance_m < kCoversSurely_m && kCoversSurely_m < kJustFits_m);
// Pieces end at nodes.
static_assert(kSameNode_m < kShortestPiece_m && kSameNode_m < kBeyondCentreLine_m);
// A pass that fits is not refused for using its slack, nor put into one group with what lies at its side.
static_assert(kJustFits_m + kIdleVertex_m <= kNearerPass_m && kNearerPass_m < kNearerGroup_m);
static_assert(kNearerGroup_m <= kSamePlace_m && kSamePlace_m < kOffCentreLines_m);
// Chords beside a swath are not in its way.
static_assert(kChordSagitta < kBeside_m && kLayerSagitta <= kBeside_m);
// What goes straight on has no kink, and a joint has none where an offset line has no corner.
static_assert(kStraightOn_rad <= kSameHeading_rad && kStraightOn_rad < kKink_rad);
static_assert(kNoCorner_rad < kKink_rad);
// The rounding of one pass is below that of all of them together.
static_assert(kSelfOverlap_m2 < kNoGain_m2);
// The body, against which all tracks are computed, has fewer vertices than pictures.
static_assert(kLayerSagitta < kBodySagitta);

}  // namespace tramline
