#pragma once
// What counts as nothing on passes and levels, and how near passes may come. What one algorithm alone needs
// stands with it.

#include "tramline/geometry/tolerances.h"

namespace tramline {

// Of lengths.

/// A circle has more than the machine's radius by this, m: what it just touches is then nearer for sure.
inline constexpr double kCoversSurely_m = 1e-8;
/// Pieces of a path or of a level that are shorter are left out, m: the nodes where they end are not known
/// well enough to give them a heading.
inline constexpr double kShortestPiece_m = 1e-7;
/// Circles that roll along centre_lines may touch them as little beyond their ends, m: each end is a node.
inline constexpr double kBeyondRail_m = 1e-7;
/// Vertices of a boundary that are no farther off the line beside them are left out, m.
inline constexpr double kIdleVertex_m = 1e-7;
/// Land just wide enough to turn on is wide enough: passes come nearer to their boundaries by this, m.
inline constexpr double kJustFits_m = 1e-7;
/// A pass may come nearer to a boundary than it should by this, m: what land that just fits and vertices left
/// out take.
inline constexpr double kNearerPass_m = 2e-7;
/// Groups of passes may come nearer to another boundary by this, m, and do not meet it: what the precision
/// grid makes of a distance.
inline constexpr double kNearerGroup_m = 1e-6;
/// Pieces of a ring that are no longer may be on no centre_line, m: where rings of two levels join there are
/// such.
inline constexpr double kOffRails_m = 1e-5;
/// What a swath touches along its sides by no more is not in its way, m: chords of bodies and boundaries lie
/// beside arcs.
inline constexpr double kBeside_m = 1e-4;
/// A pass is not driven on by less, m.
inline constexpr double kNoRun_m = 1e-4;

// Of headings.

/// Less is no turn, rad.
inline constexpr double kStraightOn_rad = 1e-7;
/// A pass that turns by more at a joint has a kink there, rad: joints are off by what grid and nodes make of
/// short pieces.
inline constexpr double kKink_rad = 1e-6;

// Of areas.

/// A path that works less ground than its length makes, by more than this, meets itself, m²: rounding of the
/// area of a long pass.
inline constexpr double kSelfOverlap_m2 = 1e-6;
/// Rings that leave and double less ground are better by more than this, m²: below, it is rounding.
inline constexpr double kNoGain_m2 = 1e-3;
/// Smaller polygons between passes are what chords leave where bands meet, m².
inline constexpr double kBandsMeet_m2 = 1e-3;

// How far chords may be off the arcs they stand for.

/// The largest distance between the edge of the body about a corner, an arc, and the chords that stand for
/// it, m.
inline constexpr double kBodySagitta = 1e-3;

// What has to be nearer or farther for sure is so by more than distances are told apart, and by less than
// what fits.
static_assert(kSameDistance_m < kCoversSurely_m && kCoversSurely_m < kJustFits_m);
// Pieces end at nodes.
static_assert(kSameNode_m < kShortestPiece_m && kSameNode_m < kBeyondRail_m);
// A pass that fits is not refused for having used what was granted to it, nor put into one group with what
// lies at its side.
static_assert(kJustFits_m + kIdleVertex_m <= kNearerPass_m && kNearerPass_m < kNearerGroup_m);
static_assert(kNearerGroup_m <= kSamePlace_m && kSamePlace_m < kOffRails_m);
// Chords beside a swath are not in its way.
static_assert(kChordSagitta < kBeside_m && kLayerSagitta <= kBeside_m);
// What goes on straight has no kink, and a joint does not have one where a level has no corner.
static_assert(kStraightOn_rad <= kSameHeading_rad && kStraightOn_rad < kKink_rad);
static_assert(kNoCorner_rad < kKink_rad);
// The rounding of one pass is below that of all of them together.
static_assert(kSelfOverlap_m2 < kNoGain_m2);
// The body, against which all tracks are computed, has fewer vertices than pictures.
static_assert(kLayerSagitta < kBodySagitta);

}  // namespace tramline
