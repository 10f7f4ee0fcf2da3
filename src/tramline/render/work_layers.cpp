#include <algorithm>
#include <cmath>

#include "tramline/render/layers.h"
#include "tramline/render/visible_faults.h"

namespace tramline::render {
namespace {

// Narrower swaths than this are too fine to be told apart, px.
constexpr double kLeastStripe = 2.5;
constexpr double kArrowSize = 9;
constexpr double kLeastArrow = 6;
constexpr double kStopRadius = 4.2;

bool drivable(const TrackPiece& piece) {
  return !(piece.start == piece.end);
}

// Unit vector on the page (y down) from start to end.
Point heading_on_page(const TrackPiece& piece) {
  const Point along = (1 / length(piece)) * (piece.end - piece.start);
  return {along.x, -along.y};
}

// Arrow heads stand side by side in the middle of the tracks: on every n-th one where tracks are
// close. n is odd, so that both headings of a boustrophedon get their share.
int arrow_stride(double swath_px, double arrow_px) {
  const int needed = static_cast<int>(std::ceil(1.2 * arrow_px / swath_px));
  return std::max(1, needed | 1);
}

}  // namespace

void draw_swaths(Canvas& canvas, const Plan& plan) {
  if (plan.machine.width_m * canvas.view().px_per_m < kLeastStripe * canvas.scale()) return;
  for (const TrackPiece& piece : plan.pieces)
    if (piece.track % 2 == 0 && drivable(piece))
      fill(canvas, {{swath(piece, plan.machine.width_m), {}}}, kStripe);
}

void draw_tracks(Canvas& canvas, const Plan& plan) {
  const double k = canvas.scale();
  const double swath_px = std::max(0.05, plan.machine.width_m * canvas.view().px_per_m);
  const double thickness = std::clamp(0.2 * swath_px, 0.4 * k, kTrackLine * k);
  const double arrow = std::clamp(0.7 * swath_px, kLeastArrow * k, kArrowSize * k);
  const int stride = arrow_stride(swath_px, arrow);
  for (const DroppedPiece& piece : plan.dropped)
    line(canvas, piece.start, piece.end, {kDroppedColour, kDroppedLine * k, {5 * k, 3 * k}});
  int index = 0;
  for (const TrackPiece& piece : plan.pieces) {
    if (!drivable(piece)) continue;
    line(canvas, piece.start, piece.end, {kTrackColour, thickness});
    const bool long_enough = length(piece) * canvas.view().px_per_m > 2.5 * arrow;
    if (index++ % stride == 0 && long_enough) {
      const Point heading = heading_on_page(piece);
      const Point middle = canvas.view().to_page(midpoint(piece.start, piece.end));
      draw_arrow_head(canvas, middle + (0.5 * arrow) * heading, heading, arrow, kFieldEdge);
    }
  }
}

void draw_faults(Canvas& canvas, const Plan& plan) {
  const double thickness = kSliverWidth * canvas.scale();
  const Region uncovered = visible_faults(plan.uncovered);
  fill(canvas, uncovered, kUncoveredColour);
  outline(canvas, uncovered, {kUncoveredColour, thickness});
  hatch(canvas, plan.given_up, given_up_hatch());
  const Region overlap = visible_faults(plan.overlap);
  fill(canvas, overlap, kOverlapColour);
  outline(canvas, overlap, {kOverlapColour, thickness});
}

void draw_stops(Canvas& canvas, const Plan& plan) {
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.stop_at_start) draw_stop_mark(canvas, canvas.view().to_page(piece.start));
    if (piece.stop_at_end) draw_stop_mark(canvas, canvas.view().to_page(piece.end));
  }
}

void draw_stop_mark(Canvas& canvas, Point at) {
  const double r = kStopRadius * canvas.scale();
  disc(canvas, at, r, kBackgroundColour);
  disc(canvas, at, 0.68 * r, kInk);
}

void draw_arrow_head(Canvas& canvas, Point tip, Point heading, double size, Colour colour) {
  const Point aside{-heading.y, heading.x};
  const Point tail = tip - size * heading;
  fill_shape(canvas,
             {tip, tail + (0.42 * size) * aside, tip - (0.75 * size) * heading, tail - (0.42 * size) * aside},
             colour);
}

}  // namespace tramline::render
