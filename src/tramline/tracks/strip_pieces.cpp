#include "tramline/tracks/strip_pieces.h"

#include <algorithm>

namespace tramline {
namespace {

/// Where a strip meets things it may not work, by cause.
struct Blocked {
  StripProfile hard;
  Intervals by_hard;     ///< obstacles and given-up land
  Intervals by_outside;  ///< land beyond a hard field boundary
  Intervals by_passable;
};

/// A piece's end is a stop when the first millimetre beyond it meets something hard, on average over
/// more than half the width tolerance.
bool stops_at(const Blocked& blocked, double end, int sense) {
  constexpr double kLookAhead = 1e-3;
  constexpr double kLeastArea = 0.5 * kLookAhead * kWidthTolerance;
  const double beyond = end + sense * kLookAhead;
  return area_between(blocked.hard, std::min(end, beyond), std::max(end, beyond)) > kLeastArea;
}

/// Parts of one stretch, with what is left between two passable obstacles that all but touch left out.
Intervals parts_between_crossings(const Interval& stretch, const Intervals& passable) {
  constexpr double kDust = 1e-3;
  Intervals parts = without({stretch}, passable);
  std::erase_if(parts, [](const Interval& part) { return part.length() < kDust; });
  return parts;
}

/// The pieces of one undisturbed stretch, which only passable obstacles interrupt. Short ones are
/// dropped from both ends inwards: what lies between two pieces that are driven is driven.
void append_stretch(const Interval& stretch, const Blocked& blocked, const StripProfile& subfield, int strip,
                    double min_length_m, SubfieldTracks& out) {
  const Intervals parts = parts_between_crossings(stretch, blocked.by_passable);
  const auto is_long = [min_length_m](const Interval& part) { return part.length() >= min_length_m; };
  const auto first = std::find_if(parts.begin(), parts.end(), is_long);
  const auto last = std::find_if(parts.rbegin(), parts.rend(), is_long).base();
  for (auto part = parts.begin(); part != parts.end(); ++part) {
    const bool driven = part >= first && part < last;
    StripPiece piece{strip,
                     part->from,
                     part->to,
                     stops_at(blocked, part->from, -1),
                     stops_at(blocked, part->to, +1),
                     driven && part != first,
                     area_between(subfield, part->from, part->to)};
    (driven ? out.pieces : out.dropped).push_back(piece);
  }
}

std::vector<Blocked> blocked_strips(const StripGrid& grid, StripRange range, const TurnedGround& ground) {
  std::vector<Blocked> out(static_cast<std::size_t>(range.size()));
  std::vector<StripProfile> hard = cross_sections(ground.hard, grid, range);
  const std::vector<StripProfile> passable = cross_sections(ground.passable, grid, range);
  const std::vector<StripProfile> field = cross_sections(ground.field, grid, range);
  const Box reach = bounds(ground.field);
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i].by_hard = where_at_least(hard[i], kWidthTolerance);
    out[i].by_passable = where_at_least(passable[i], kWidthTolerance);
    if (!ground.field.empty())
      out[i].by_outside = complement(where_at_least(field[i], grid.width_m - kWidthTolerance),
                                     {reach.min_y - 1, reach.max_y + 1});
    out[i].hard = std::move(hard[i]);
  }
  return out;
}

}  // namespace

SubfieldTracks strip_pieces(const StripGrid& grid, const Polygon& turned, const TurnedGround& ground,
                            const EndCriterion& criterion, double min_length_m) {
  SubfieldTracks out{grid, {}, {}};
  const StripRange range = strips_over(grid, bounds(turned), kWidthTolerance);
  const std::vector<StripProfile> subfield = cross_sections({turned}, grid, range);
  const std::vector<Blocked> blocked = blocked_strips(grid, range, ground);
  for (int k = range.first; k <= range.last; ++k) {
    const auto i = static_cast<std::size_t>(k - range.first);
    const Intervals allowed = allowed_by(criterion, subfield[i]);
    for (const Interval& stretch : without(without(allowed, blocked[i].by_hard), blocked[i].by_outside))
      append_stretch(stretch, blocked[i], subfield[i], k, min_length_m, out);
  }
  return out;
}

}  // namespace tramline
