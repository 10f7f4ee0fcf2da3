#include <algorithm>

#include "tramline/render/arrow_places.h"
#include "tramline/render/layers.h"
#include "tramline/render/page_headings.h"

namespace tramline::render {
namespace {

constexpr double kArrowsApart = 260;  // px

}  // namespace

void draw_headland_ground(Canvas& canvas, const Plan& plan) {
  if (plan.headland.ground.empty()) return;
  fill(canvas, plan.headland.ground, kHeadlandColour);
}

void draw_headland_swaths(Canvas& canvas, const Plan& plan) {
  if (swath_px(canvas, plan) < kLeastStripe * canvas.scale()) return;
  for (const HeadlandPass& pass : plan.headland.passes)
    if (pass.number % 2 == 0)
      fill(canvas, {swath(pass, plan.machine.width_m, sagitta_m(canvas.view()))}, kStripe);
}

void draw_headland_passes(Canvas& canvas, const Plan& plan, const Box& seen) {
  const double k = canvas.scale();
  const double swath = std::max(0.05, swath_px(canvas, plan));
  const double thickness = std::clamp(0.25 * swath, 0.5 * k, kHeadlandLine * k);
  for (const HeadlandPass& pass : plan.headland.passes)
    curve(canvas, pass.path, {kHeadlandPassColour, thickness, {kHeadlandDash * k, 0.5 * kHeadlandDash * k}});
  const double arrow = arrow_size(swath, k);
  const int stride = arrow_stride(swath, arrow);
  const double metre = canvas.view().px_per_m;
  for (const HeadlandPass& pass : plan.headland.passes) {
    if ((pass.number - 1) % stride != 0) continue;
    for (const PlaceOnLine& place :
         arrow_places_round(pass.path, 2.5 * arrow / metre, kArrowsApart * k / metre, seen)) {
      const Point heading = on_page(place.along);
      const Point tip = canvas.view().to_page(place.at) + (0.5 * arrow) * heading;
      draw_arrow_head(canvas, tip, heading, arrow, kHeadlandPassColour);
    }
  }
}

void draw_references(Canvas& canvas, const Plan& plan, const Box& seen) {
  const double k = canvas.scale();
  const Point low = canvas.view().to_page({seen.min_x, seen.max_y});
  const Point high = canvas.view().to_page({seen.max_x, seen.min_y});
  cairo_save(canvas.cr());
  // The line is as long as any track could need it, and no part of the field.
  clip_to(canvas, Box{low.x, low.y, high.x, high.y}.grown(kReferenceBeyond * k));
  for (const Path& reference : references(plan)) {
    curve(canvas, reference, {kReferenceRim, (kReferenceLine + 2 * kDetourRimWidth) * k});
    curve(canvas, reference, {kReferenceColour, kReferenceLine * k, reference_dashes(k)});
  }
  cairo_restore(canvas.cr());
}

std::vector<double> reference_dashes(double scale) { return {12 * scale, 3 * scale, 2 * scale, 3 * scale}; }

}  // namespace tramline::render
