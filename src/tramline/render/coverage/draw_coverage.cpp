#include "tramline/render/coverage/draw_coverage.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/coverage/coverage_layers.h"
#include "tramline/render/coverage/coverage_legend.h"
#include "tramline/render/coverage/gap_labels.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"

namespace tramline::render {
namespace {

Box common(const Box& a, const Box& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

std::string title_of(const Coverage& coverage) {
  return coverage.field_id.empty() ? "work done" : "work done: " + coverage.field_id;
}

std::string subtitle_of(const Coverage& coverage) {
  const std::string width = fmt::format("working width {:g} m", coverage.width_m);
  return coverage.log.empty() ? width : fmt::format("{}, {}", coverage.log, width);
}

void draw_coverage_map(Canvas& canvas, const Coverage& coverage, const Box& map) {
  cairo_save(canvas.cr());
  clip_to(canvas, map);
  draw_covered(canvas, coverage);
  draw_repeated(canvas, coverage);
  draw_missed(canvas, coverage);
  draw_not_recorded(canvas, coverage);
  draw_driven(canvas, coverage);
  draw_field_outline(canvas, coverage);
  draw_gap_labels(canvas, place_gap_labels(coverage.gaps, canvas.view(), canvas.scale(), map));
  cairo_restore(canvas.cr());
}

}  // namespace

Box drawn_box(const Coverage& coverage) {
  if (coverage.field.empty()) return bounds(coverage.covered);
  Box box = bounds(coverage.field);
  const double margin = std::max(2 * coverage.width_m, 0.1 * std::max(box.width(), box.height()));
  const Box near = common(bounds(coverage.covered), box.grown(margin));
  if (near.min_x < near.max_x && near.min_y < near.max_y) box.extend(near);
  return box;
}

PageLayout layout_of(const Coverage& coverage, const PictureOptions& options) {
  require_picture_width(options);
  const Box drawn = drawn_box(coverage);
  if (!std::isfinite(drawn.width()) || !std::isfinite(drawn.height()) || drawn.empty())
    throw bad_input(fmt::format("{}: there is neither a field nor covered land to draw", coverage.log));
  return lay_out_page(drawn, options.width_px, heights_of(legend_of(coverage)));
}

void draw_coverage(const Coverage& coverage, const std::filesystem::path& path,
                   const PictureOptions& options) {
  const PictureFormat format = format_of(path);
  const PageLayout page = layout_of(coverage, options);
  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use(page.view, page.text_scale);
  draw_coverage_map(canvas, coverage, page.map);
  draw_title(canvas, page.title, title_of(coverage), subtitle_of(coverage));
  draw_scale_strip(canvas, page.scale_strip);
  draw_legend(canvas, page, legend_of(coverage));
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
