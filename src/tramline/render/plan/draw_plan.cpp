#include "tramline/render/plan/draw_plan.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/page/labels.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"
#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

std::string subtitle_of(const Plan& plan) {
  if (plan.machine.name.empty()) return fmt::format("working width {:g} m", plan.machine.width_m);
  return fmt::format("{}, working width {:g} m", plan.machine.name, plan.machine.width_m);
}

void draw_map(Canvas& canvas, const Plan& plan) {
  draw_ground(canvas, plan);
  draw_headland_swaths(canvas, plan);
  draw_swaths(canvas, plan);
  draw_obstacles(canvas, plan);
  const Box drawn = drawn_box(plan);
  draw_headland_passes(canvas, plan, drawn);
  draw_track_lines(canvas, plan);
  draw_turns(canvas, plan);
  draw_route(canvas, plan);
  draw_arrow_heads(canvas, plan, drawn);
  draw_outlines(canvas, plan);
  draw_references(canvas, plan, drawn);
  // Marks that stand close together would hide the faults between them.
  const bool apart = stops_stand_apart(canvas, plan);
  if (!apart) draw_stops(canvas, plan);
  draw_faults(canvas, plan);
  // They keep to lanes that nobody works: under what is missed they would not be seen.
  draw_ways_without_room(canvas, plan);
  // A detour leaves its strip, so it mostly runs through overlap: under it, it would not be seen.
  draw_detours(canvas, plan);
  if (apart) draw_stops(canvas, plan);
  const auto badges = place_badges(plan, canvas.view(), canvas.scale());
  const auto labels =
      place_track_labels(plan, canvas.view(), canvas.scale(), boxes_of(badges, canvas.scale()));
  draw_badges(canvas, plan, badges);
  draw_track_labels(canvas, labels);
  draw_route_ends(canvas, plan);
}

}  // namespace

void require_picture_width(const PictureOptions& options) {
  if (options.width_px < 600 || options.width_px > 16000)
    throw bad_input(fmt::format("picture width {} px: it must be from 600 to 16000", options.width_px));
}

PageLayout layout_of(const Plan& plan, const PictureOptions& options) {
  require_picture_width(options);
  const Box drawn = drawn_box(plan);
  if (!std::isfinite(drawn.width()) || !std::isfinite(drawn.height()) || drawn.empty())
    throw bad_input(fmt::format("field {}: there is no outline to draw", plan.field.id));
  return lay_out_page(drawn, options.width_px, heights_of(legend_of(plan)));
}

void draw_plan(const Plan& plan, const std::filesystem::path& path, const PictureOptions& options) {
  const PictureFormat format = format_of(path);
  const PageLayout page = layout_of(plan, options);
  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use(page.view, page.text_scale);
  draw_map(canvas, plan);
  draw_title(canvas, page.title, plan.field.id.empty() ? "field" : plan.field.id, subtitle_of(plan));
  draw_scale_strip(canvas, page.scale_strip);
  draw_legend(canvas, page, legend_of(plan));
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
