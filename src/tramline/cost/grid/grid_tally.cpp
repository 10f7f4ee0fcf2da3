#include "tramline/cost/grid/grid_tally.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/cost/tolerances.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {
namespace {

void append_boxes(const Region& region, const Box& reach, std::vector<Box>& out) {
  for (const Polygon& part : region) {
    const Box box = bounds(part);
    if (intersects(box, reach)) out.push_back(box);
  }
}

TurnedSubfield turned_subfield(const TrackFrame& frame, const Polygon& shape, TurnedGround ground) {
  Polygon turned = frame.to_track(Region{shape}).front();
  TurnedSubfield out{frame, turned, rings_of({turned}), std::move(ground), bounds(turned), {}, area(turned)};
  append_boxes(out.ground.hard, out.reach, out.obstacles);
  append_boxes(out.ground.passable, out.reach, out.obstacles);
  append_boxes(out.ground.beyond, out.reach, out.obstacles);
  return out;
}

}  // namespace

GridTally::GridTally(const TrackFrame& frame, const Polygon& shape, TurnedGround ground,
                     const GridTerms& terms)
    : subfield_(turned_subfield(frame, shape, std::move(ground))),
      terms_(terms),
      plain_criterion_(terms.criterion) {
  if (!subfield_.ground.field.empty()) plain_criterion_ = {false, terms.width_m - kWidthTolerance};
}

bool GridTally::mark_obstructed(const StripGrid& grid, StripRange range, StripMask& out) const {
  bool any = false;
  for (const Box& box : subfield_.obstacles) {
    const int first = std::max(grid.strip_at(box.min_x - kWidthTolerance), range.first);
    const int last = std::min(grid.strip_at(box.max_x + kWidthTolerance), range.last);
    for (int k = first; k <= last; ++k) out[static_cast<std::size_t>(k - range.first)] = true;
    any = any || first <= last;
  }
  return any;
}

void GridTally::Sums::add(double length_m, double inside_m2, double width_m) {
  tally.track_length_m += length_m;
  tally.worked_m2 += width_m * length_m;
  tally.pieces += 1;
  useful_m2 += inside_m2;
}

void GridTally::add_open_strips(StripFold& fold, const StripMask& open, Sums& sums) const {
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!open[i]) continue;
    const StripProfile& profile = fold.profile(i);
    for (const Interval& piece : allowed_by(plain_criterion_, profile))
      if (piece.length() >= least_length_m())
        sums.add(piece.length(), area_between(profile, piece.from, piece.to), terms_.width_m);
  }
}

void GridTally::add_obstructed_strips(StripFold& fold, const StripGrid& grid, StripRange range,
                                      const StripMask& obstructed, Sums& sums) const {
  std::vector<StripProfile> profiles(obstructed.size());
  for (std::size_t i = 0; i < obstructed.size(); ++i)
    if (obstructed[i]) profiles[i] = fold.profile(i);
  const TrackFamily family =
      straight_tracks(grid, range, obstructed, std::move(profiles), subfield_.ground, terms_.criterion);
  for (const Track& strip : family.tracks) add_obstructed_strip(strip, grid, sums);
}

/// The pieces as cut_pieces() makes them; most strips have no passable land and need none made.
void GridTally::add_obstructed_strip(const Track& strip, const StripGrid& grid, Sums& sums) const {
  if (strip.passable_stretches.empty()) {
    for (const Interval& whole : strip.stretches) {
      if (whole.length() < least_length_m()) continue;
      sums.add(whole.length(), strip.subfield.area_between(whole.from, whole.to), terms_.width_m);
      sums.tally.stops += (stops_at(strip, whole.from, -1) ? 1 : 0) + (stops_at(strip, whole.to, +1) ? 1 : 0);
    }
    return;
  }
  LaidTracks tracks{grid, {}, {}};
  append_pieces(strip, {}, terms_.min_length_m, tracks);
  for (const LaidPiece& piece : tracks.pieces) {
    sums.add(piece.length_m, piece.inside_m2, terms_.width_m);
    sums.tally.crossings += piece.after_crossing ? 1 : 0;
    sums.tally.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
  }
}

Tally GridTally::at(double origin_m) const {
  thread_local RowEndWedges ends;
  thread_local StripFold fold;
  const StripGrid grid = this->grid(origin_m);
  const StripRange range = strips_over(grid, subfield_.reach, kWidthTolerance);
  StripMask obstructed(static_cast<std::size_t>(range.size()), false), open = obstructed;
  const bool any_obstructed = mark_obstructed(grid, range, obstructed);
  bool any_open = false;
  ends.collect(subfield_.outline, grid, range, plain_criterion_);

  Sums sums;
  for (std::size_t i = 0; i < obstructed.size(); ++i) {
    if (obstructed[i]) continue;
    const RowEndWedges::InStrip strip = ends.in_strip(i);
    open[i] = !strip.plain;
    any_open = any_open || !strip.plain;
    for (const RowEndWedge* end = strip.begin; end != strip.end; end += 2) {
      const double length_m = end[1].at - end[0].at;
      if (length_m < least_length_m()) continue;
      const double over_m2 = end[0].over_m2 + end[1].over_m2;
      sums.add(length_m, terms_.width_m * length_m - over_m2, terms_.width_m);
    }
  }
  if (any_open || any_obstructed) {
    StripMask folded = obstructed;
    for (std::size_t i = 0; i < open.size(); ++i) folded[i] = folded[i] || open[i];
    fold.fold(subfield_.outline, grid, range, folded);
  }
  if (any_open) add_open_strips(fold, open, sums);
  if (any_obstructed) add_obstructed_strips(fold, grid, range, obstructed, sums);

  Tally& tally = sums.tally;
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  settle_areas(tally, sums.useful_m2, subfield_.area_m2);
  return tally;
}

}  // namespace tramline
