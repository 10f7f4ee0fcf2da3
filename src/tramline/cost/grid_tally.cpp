#include "tramline/cost/grid_tally.h"

#include <algorithm>

#include "tramline/geometry/region.h"

namespace tramline {
namespace {

void append_boxes(const Region& region, const Box& reach, std::vector<Box>& out) {
  for (const Polygon& part : region) {
    const Box box = bounds(part);
    if (intersects(box, reach)) out.push_back(box);
  }
}

void add_piece(Tally& tally, double length_m, double width_m, double useful_m2, double& useful_sum) {
  tally.track_length_m += length_m;
  tally.worked_m2 += width_m * length_m;
  tally.pieces += 1;
  useful_sum += useful_m2;
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

void GridTally::mark_obstructed(const StripGrid& grid, StripRange range, StripMask& out) const {
  for (const Box& box : subfield_.obstacles) {
    const int first = std::max(grid.strip_at(box.min_x - kWidthTolerance), range.first);
    const int last = std::min(grid.strip_at(box.max_x + kWidthTolerance), range.last);
    for (int k = first; k <= last; ++k) out[static_cast<std::size_t>(k - range.first)] = true;
  }
}

Tally GridTally::at(double origin_m) const {
  thread_local PlainEnds ends;
  const StripGrid grid = this->grid(origin_m);
  const StripRange range = strips_over(grid, subfield_.reach, kWidthTolerance);
  StripMask intricate(static_cast<std::size_t>(range.size()), false);
  mark_obstructed(grid, range, intricate);
  ends.collect(subfield_.outline, grid, range, plain_criterion_);

  Tally tally;
  double useful_m2 = 0;
  bool any_intricate = false;
  for (std::size_t i = 0; i < intricate.size(); ++i) {
    const PlainEnds::InStrip strip = intricate[i] ? PlainEnds::InStrip{} : ends.in_strip(i);
    intricate[i] = !strip.plain;
    any_intricate = any_intricate || !strip.plain;
    for (const PlainEnd* end = strip.begin; end != strip.end; end += 2) {
      const double length_m = end[1].at - end[0].at;
      if (length_m < std::max(terms_.min_length_m, kNoPiece_m)) continue;
      const double over_m2 = end[0].over_m2 + end[1].over_m2;
      add_piece(tally, length_m, terms_.width_m, terms_.width_m * length_m - over_m2, useful_m2);
    }
  }
  if (any_intricate) {
    SubfieldTracks tracks{grid, {}, {}};
    for (const Strip& strip :
         strips_of(grid, range, intricate, subfield_.shape, subfield_.ground, terms_.criterion).strips)
      append_pieces(strip, {}, terms_.min_length_m, tracks);
    for (const StripPiece& piece : tracks.pieces) {
      add_piece(tally, length(piece), terms_.width_m, piece.inside_m2, useful_m2);
      tally.crossings += piece.after_crossing ? 1 : 0;
      tally.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    }
  }
  tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
  tally.overlap_m2 = tally.worked_m2 - useful_m2;
  tally.uncovered_m2 = subfield_.area_m2 - useful_m2;
  return tally;
}

}  // namespace tramline
