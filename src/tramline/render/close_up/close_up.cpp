#include "tramline/render/close_up/close_up.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/close_up/close_up_labels.h"
#include "tramline/render/close_up/close_up_layers.h"
#include "tramline/render/close_up/close_up_window.h"
#include "tramline/render/close_up/encounter_table.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"
#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

void require_obstacle(const Plan& plan, std::size_t obstacle) {
  const std::size_t count = plan.field.obstacles.size();
  if (obstacle >= count)
    throw bad_input(fmt::format("field {}: there is no obstacle {} to draw, only {}", plan.field.id,
                                obstacle + 1, count));
}

void draw_lines(Canvas& canvas, const Plan& near, std::size_t obstacle, const Box& seen) {
  draw_keep_off_lines(canvas, near);
  draw_swath_edges(canvas, near);
  draw_outlines(canvas, near);
  draw_headland_passes(canvas, near, seen);
  draw_track_lines(canvas, near);
  draw_references(canvas, near, seen);
  draw_tightest_arcs(canvas, near, obstacle);
  draw_detours(canvas, near);
  draw_arrow_heads(canvas, near, seen);
  draw_stops(canvas, near);
}

// Lines come above the faults: here the eye asks why land is worked twice or not at all.
void draw_window(Canvas& canvas, const Plan& near, std::size_t obstacle, const CloseUpLayout& layout) {
  const Box& map = layout.page.map;
  cairo_save(canvas.cr());
  clip_to(canvas, map);
  draw_ground(canvas, near);
  draw_worked_land(canvas, near);
  draw_headland_swaths(canvas, near);
  draw_swaths(canvas, near);
  draw_faults(canvas, near);
  draw_obstacles(canvas, near);
  draw_lines(canvas, near, obstacle, layout.seen);
  std::vector<Box> occupied;
  draw_obstacle_numbers(canvas, near, map, occupied);
  draw_radii(canvas, near, obstacle, map, occupied);
  draw_strip_numbers(canvas, near, map, occupied);
  cairo_restore(canvas.cr());
  draw_frame(canvas, map);
}

}  // namespace

CloseUpLayout close_up_layout(const Plan& plan, std::size_t obstacle, const PictureOptions& options) {
  require_obstacle(plan, obstacle);
  require_picture_width(options);
  const Box window = close_up_window(plan, obstacle);
  CloseUpLayout out;
  // The map shows more than the window where the page has another shape, and the legend has to name
  // that too: the second layout has a legend for what the first one shows.
  out.seen = window;
  for (int round = 0; round < 2; ++round) {
    out.legend_for = out.seen;
    out.page = lay_out_page(window, options.width_px,
                            heights_of(legend_of_close_up(plan, obstacle, out.legend_for)));
    out.seen = shown_box(out.page);
  }
  const double k = out.page.text_scale;
  const double top = out.page.height_px;
  out.table = {out.page.title.min_x, top, out.page.title.max_x,
               top + k * height_of_table(encounter_rows(plan, obstacle))};
  out.page.height_px = static_cast<int>(std::ceil(out.table.max_y + out.page.title.min_x));
  return out;
}

void draw_close_up(const Plan& plan, std::size_t obstacle, const std::filesystem::path& path,
                   const PictureOptions& options) {
  const PictureFormat format = format_of(path);
  const CloseUpLayout layout = close_up_layout(plan, obstacle, options);
  const PageLayout& page = layout.page;
  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use(page.view, page.text_scale);
  draw_window(canvas, part_in(plan, layout.seen), obstacle, layout);
  draw_title(canvas, page.title, close_up_title(plan, obstacle), close_up_subtitle(plan));
  draw_scale_strip(canvas, page.scale_strip);
  draw_legend(canvas, page, legend_of_close_up(plan, obstacle, layout.legend_for));
  draw_encounter_table(canvas, layout.table, encounter_rows(plan, obstacle));
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
