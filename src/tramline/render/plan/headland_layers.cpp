#include <algorithm>

#include "tramline/render/page/arrow_positions.h"
#include "tramline/render/page/page_headings.h"
#include "tramline/render/plan/layers.h"

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
    for (const PointOnLine& place :
         arrow_positions_round(pass.path, 2.5 * arrow / metre, kArrowsApart * k / metre, seen)) {
      const Point heading = on_page(place.along);
      const Point tip = canvas.view().to_page(place.at) + (0.5 * arrow) * heading;
      draw_arrow_head(canvas, tip, heading, arrow, kHeadlandPassColour);
    }
  }
}

namespace {

/// Of what is seen, where tracks follow the line.
Box followed_in(const Plan& plan, const Path& reference, const Box& seen) {
  Box box;
  for (const Subfield& subfield : plan.subfields)
    if (subfield.reference == reference) box.extend(bounds(subfield.shape));
  return {std::max(box.min_x, seen.min_x), std::max(box.min_y, seen.min_y), std::min(box.max_x, seen.max_x),
          std::min(box.max_y, seen.max_y)};
}

}  // namespace

void draw_references(Canvas& canvas, const Plan& plan, const Box& seen) {
  const double k = canvas.scale();
  const std::vector<Path> lines = references(plan);
  for (const Path& reference : lines) {
    // The line is as long as any track could need it, and no part of the field.
    const Box box = lines.size() == 1 ? seen : followed_in(plan, reference, seen);
    if (box.empty()) continue;
    const Point low = canvas.view().to_page({box.min_x, box.max_y});
    const Point high = canvas.view().to_page({box.max_x, box.min_y});
    cairo_save(canvas.cr());
    clip_to(canvas, Box{low.x, low.y, high.x, high.y}.grown(kReferenceBeyond * k));
    curve(canvas, reference, {kReferenceRim, (kReferenceLine + 2 * kDetourRimWidth) * k});
    curve(canvas, reference, {kReferenceColour, kReferenceLine * k, reference_dashes(k)});
    cairo_restore(canvas.cr());
  }
}

}  // namespace tramline::render
