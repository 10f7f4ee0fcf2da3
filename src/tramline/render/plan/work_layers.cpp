#include <algorithm>

#include "tramline/render/page/arrow_positions.h"
#include "tramline/render/page/page_headings.h"
#include "tramline/render/page/visible_faults.h"
#include "tramline/render/plan/layers.h"
#include "tramline/render/stops/stop_places.h"

namespace tramline::render {
namespace {

constexpr double kLeastStop = 1.6;

bool drivable(const TrackPiece& piece) { return !(piece.start == piece.end); }

struct ByWidth {
  Region wide;
  Region thin;
};

ByWidth by_width(const Region& faults, double thin_m) {
  ByWidth out;
  for (const Polygon& fault : faults) (mean_width(fault) < thin_m ? out.thin : out.wide).push_back(fault);
  return out;
}

void draw_fault(Canvas& canvas, const Region& faults, Colour colour) {
  fill(canvas, faults, colour);
  outline(canvas, faults, {colour, kSliverWidth * canvas.scale()});
}

// swath() with no more vertices than the page can show.
Ring drawn_swath(const Canvas& canvas, const TrackPiece& piece, double width_m) {
  if (piece.detours.empty() && piece.curve.empty()) return swath(piece, width_m);
  return band(centre_line(piece), width_m, sagitta_m(canvas.view()));
}

}  // namespace

double swath_px(const Canvas& canvas, const Plan& plan) {
  return plan.machine.width_m * canvas.view().px_per_m;
}

void draw_swaths(Canvas& canvas, const Plan& plan) {
  if (swath_px(canvas, plan) < kLeastStripe * canvas.scale()) return;
  for (const TrackPiece& piece : plan.pieces)
    if (piece.track % 2 == 0 && drivable(piece))
      fill(canvas, {{drawn_swath(canvas, piece, plan.machine.width_m), {}}}, kStripe);
}

void draw_track_lines(Canvas& canvas, const Plan& plan) {
  const double k = canvas.scale();
  const double thickness = std::clamp(0.2 * swath_px(canvas, plan), 0.4 * k, kTrackLine * k);
  for (const DroppedPiece& piece : plan.dropped)
    line(canvas, piece.start, piece.end, {kDroppedColour, kDroppedLine * k, {5 * k, 3 * k}});
  for (const TrackPiece& piece : plan.pieces)
    if (drivable(piece)) curve(canvas, centre_line(piece), {kTrackColour, thickness});
}

void draw_turns(Canvas& canvas, const Plan& plan) {
  const double k = canvas.scale();
  const double thickness = std::clamp(0.25 * swath_px(canvas, plan), 0.5 * k, kTurnLine * k);
  for (const PlannedTurn& turn : plan.turns) {
    if (turn.state == TurnState::kApart) continue;
    const Colour colour = turn.state == TurnState::kFits ? kTurnColour : kNoRoomColour;
    for (const SteeredStretch& stretch : turn.manoeuvre.path) {
      const Path way = trace({stretch}, sagitta_m(canvas.view()));
      if (way.empty()) continue;
      Stroke stroke{colour, thickness};
      if (stretch.gear == Gear::kReverse) stroke = {colour, thickness, {3 * thickness, 3 * thickness}};
      curve(canvas, way, stroke);
    }
  }
}

void draw_arrow_heads(Canvas& canvas, const Plan& plan, const Box& seen) {
  const double k = canvas.scale();
  const double swath = std::max(0.05, swath_px(canvas, plan));
  const double arrow = arrow_size(swath, k);
  const int stride = arrow_stride(swath, arrow);
  int index = 0;
  for (const TrackPiece& piece : plan.pieces) {
    if (!drivable(piece) || index++ % stride != 0) continue;
    const auto place = arrow_position(piece, 2.5 * arrow / canvas.view().px_per_m, seen);
    if (!place) continue;
    const Point heading = on_page(place->along);
    const Point tip = canvas.view().to_page(place->at) + (0.5 * arrow) * heading;
    draw_arrow_head(canvas, tip, heading, arrow, kFieldEdge);
  }
}

void draw_detours(Canvas& canvas, const Plan& plan) {
  const double k = canvas.scale();
  const double swath = swath_px(canvas, plan);
  const double thickness = std::clamp(0.4 * swath, 1.0 * k, kDetourLine * k);
  // Where swaths are fine, rims would hide more than they show.
  const double rim = std::clamp(0.15 * swath, 0.3 * k, kDetourRimWidth * k);
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) curve(canvas, detour.path, {kDetourRim, thickness + 2 * rim});
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours) curve(canvas, detour.path, {kDetourColour, thickness});
}

void draw_faults(Canvas& canvas, const Plan& plan) {
  const double thin_m = 2 * kSliverWidth * canvas.scale() / canvas.view().px_per_m;
  Region left_out = plan.uncovered;
  if (plan.figures == PlanFigures::kTracks)  // older plans count the headland by itself
    left_out.insert(left_out.end(), plan.headland.unworked.begin(), plan.headland.unworked.end());
  const ByWidth uncovered = by_width(visible_faults(left_out), thin_m);
  const ByWidth overlap = by_width(visible_faults(plan.overlap), thin_m);
  // Slivers last: they would vanish under the rims of the wide ones.
  draw_fault(canvas, uncovered.wide, kUncoveredColour);
  hatch(canvas, plan.given_up, given_up_hatch());
  draw_fault(canvas, overlap.wide, kOverlapColour);
  draw_fault(canvas, uncovered.thin, kUncoveredColour);
  draw_fault(canvas, overlap.thin, kOverlapColour);
}

void draw_stops(Canvas& canvas, const Plan& plan) {
  const double k = canvas.scale();
  const double radius = std::clamp(0.36 * swath_px(canvas, plan), kLeastStop * k, kStopRadius * k);
  for (const StopPlace& stop : stop_places(plan)) {
    // On the track's side of its end: a pylon is smaller than two marks.
    const Point at = canvas.view().to_page(stop.at);
    draw_stop_mark(canvas, at + radius * on_page(stop.back), radius);
  }
}

bool stops_stand_apart(const Canvas& canvas, const Plan& plan) {
  return swath_px(canvas, plan) >= 4 * kLeastStop * canvas.scale();
}

}  // namespace tramline::render
