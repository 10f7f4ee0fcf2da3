#include "tramline/render/dose/draw_dose.h"

#include <fmt/format.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/dose/dose_layers.h"
#include "tramline/render/dose/dose_legend.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"

namespace tramline::render {
namespace {

/// Ground, and cells that got a hundredth of the reference or more.
Box dose_box(const DoseMap& map) {
  constexpr double kSeen = 0.01;
  Box box;
  for (int row = 0; row < map.grid.rows; ++row)
    for (int column = 0; column < map.grid.columns; ++column) {
      const std::size_t i = map.grid.index(column, row);
      if (!(map.ground[i] > 0) && !(rate_per_ha(map, i) > kSeen * map.figures.reference_per_ha)) continue;
      const Point low = map.grid.low + map.grid.cell_m * Point{1.0 * column, 1.0 * row};
      box.extend(low);
      box.extend(low + Point{map.grid.cell_m, map.grid.cell_m});
    }
  return box;
}

std::string title_of(const DoseMap& map) {
  return map.field_id.empty() ? "amount applied" : "amount applied: " + map.field_id;
}

std::string subtitle_of(const DoseMap& map) {
  const std::string width =
      std::isfinite(map.width_m) ? fmt::format("working width {:g} m", map.width_m) : std::string();
  return map.log.empty() || width.empty() ? map.log + width : map.log + ", " + width;
}

}  // namespace

PageLayout layout_of(const DoseMap& map, const PictureOptions& options) {
  require_picture_width(options);
  const Box drawn = dose_box(map);
  if (drawn.empty()) throw bad_input(fmt::format("{}: there is nothing to draw", map.log));
  return lay_out_page(drawn, options.width_px, heights_of(legend_of(map)));
}

void draw_dose(const DoseMap& map, const std::filesystem::path& path, const PictureOptions& options) {
  const PictureFormat format = format_of(path);
  const PageLayout page = layout_of(map, options);
  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use(page.view, page.text_scale);
  cairo_save(canvas.cr());
  clip_to(canvas, page.map);
  draw_cells(canvas, map);
  draw_dose_field(canvas, map);
  cairo_restore(canvas.cr());
  draw_title(canvas, page.title, title_of(map), subtitle_of(map));
  draw_scale_strip(canvas, page.scale_strip);
  draw_wind(canvas, page.scale_strip, map);
  const std::vector<LegendBlock> blocks = legend_of(map);
  draw_legend(canvas, page, blocks);
  draw_histogram(canvas, rows_of_blocks(page, blocks).front(), map);
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
