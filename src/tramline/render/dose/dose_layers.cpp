#include "tramline/render/dose/dose_layers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "tramline/render/dose/dose_colours.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

constexpr double kLeastCell = 0.5;  // px

std::uint32_t argb(Colour colour, double opacity) {
  const auto byte = [](double share) { return static_cast<std::uint32_t>(std::lround(255 * share)); };
  return byte(opacity) << 24U | byte(opacity * colour.red) << 16U | byte(opacity * colour.green) << 8U |
         byte(opacity * colour.blue);
}

/// Cells drawn as one.
struct Patch {
  double amount = 0;
  double on_ground = 0;
  double ground = 0;
  int cells = 0;
};

Patch patch(const DoseMap& map, int left, int bottom, int together) {
  Patch out;
  for (int row = bottom; row < std::min(bottom + together, map.grid.rows); ++row)
    for (int column = left; column < std::min(left + together, map.grid.columns); ++column) {
      const std::size_t i = map.grid.index(column, row);
      out.amount += map.amount[i];
      out.on_ground += static_cast<double>(map.on_ground[i]);
      out.ground += static_cast<double>(map.ground[i]);
      ++out.cells;
    }
  return out;
}

std::uint32_t pixel(const DoseMap& map, const Patch& patch) {
  // Where ground is only a part of the cell, the rate is that of the ground: edges are not to look
  // underdosed.
  const bool has_ground = patch.ground > 0.01 * patch.cells;
  const double cells = has_ground ? patch.ground : patch.cells;
  const double rate = (has_ground ? patch.on_ground : patch.amount) / cells / map.grid.cell_area_m2() * 1e4;
  const double reference = map.figures.reference_per_ha;
  const double multiple = reference > 0 ? rate / reference : 0;
  const double ground = std::min(1.0, 2 * patch.ground / patch.cells);
  return argb(dose_colour(multiple), std::max(ground, opacity_off_ground(multiple)));
}

/// From the north-west, row by row.
Surface image_of(const DoseMap& map, int together) {
  const int columns = (map.grid.columns + together - 1) / together,
            rows = (map.grid.rows + together - 1) / together;
  Surface image(cairo_image_surface_create(CAIRO_FORMAT_ARGB32, columns, rows));
  unsigned char* bytes = cairo_image_surface_get_data(image.get());
  if (bytes == nullptr) return image;
  const int stride = cairo_image_surface_get_stride(image.get());
  cairo_surface_flush(image.get());
  for (int row = 0; row < rows; ++row) {
    auto* line = reinterpret_cast<std::uint32_t*>(bytes + static_cast<std::ptrdiff_t>(stride) * row);
    for (int column = 0; column < columns; ++column)
      line[column] = pixel(map, patch(map, column * together, (rows - 1 - row) * together, together));
  }
  cairo_surface_mark_dirty(image.get());
  return image;
}

std::string rate_text(double rate) {
  return rate >= 100 || rate == 0 ? fmt::format("{:.0f}", rate) : fmt::format("{:.3g}", rate);
}

}  // namespace

void draw_cells(Canvas& canvas, const DoseMap& map) {
  const double cell_px = map.grid.cell_m * canvas.view().px_per_m;
  const int together = std::max(1, static_cast<int>(std::ceil(kLeastCell / cell_px)));
  const Surface image = image_of(map, together);
  const int rows = (map.grid.rows + together - 1) / together;
  const double patch_m = map.grid.cell_m * together;
  const Point corner = canvas.view().to_page({map.grid.low.x, map.grid.low.y + rows * patch_m});
  cairo_t* cr = canvas.cr();
  cairo_save(cr);
  cairo_translate(cr, corner.x, corner.y);
  cairo_scale(cr, cell_px * together, cell_px * together);
  cairo_set_source_surface(cr, image.get(), 0, 0);
  cairo_pattern_set_filter(cairo_get_source(cr), CAIRO_FILTER_NEAREST);
  cairo_paint(cr);
  cairo_restore(cr);
}

void draw_dose_field(Canvas& canvas, const DoseMap& map) {
  const Stroke edge{kFieldEdge, kOutlineWidth * canvas.scale()};
  for (const Polygon& polygon : map.field)
    for (const Ring& hole : polygon.holes) hatch(canvas, {{reversed(hole), {}}}, obstacle_hatch());
  outline(canvas, map.field, edge);
}

void draw_wind(Canvas& canvas, const Box& strip, const DoseMap& map) {
  if (!map.drift || !(map.drift->wind_mps > 0)) return;
  const double k = canvas.scale();
  const Point from = map.drift->wind_from.unit();
  const Point blows{-from.x, from.y};  // y points down on the page
  const Point half = 22 * k * blows;
  const double y = strip.centre().y;
  const Point middle{strip.max_x - 130 * k, y};
  stroke_line(canvas, {middle - half, middle + half}, {kInk, 2.2 * k});
  draw_arrow_head(canvas, middle + half, blows, 13 * k, kInk);
  draw_text(canvas, {strip.max_x - 4 * k, y}, fmt::format("wind {:g} m/s", map.drift->wind_mps),
            {kSmallTextSize, false, Align::kRight, kInk});
}

void draw_histogram(Canvas& canvas, const Box& box, const DoseMap& map) {
  const double k = canvas.scale();
  const DoseFigures& figures = map.figures;
  const double ramp_top = box.max_y - 40 * k, ramp_bottom = ramp_top + 14 * k, bars_top = box.min_y + 22 * k;
  double most_m2 = 0;
  for (const DoseBin& bin : figures.histogram) most_m2 = std::max(most_m2, bin.area_m2);
  const auto bins = static_cast<double>(figures.histogram.size());
  if (!(most_m2 > 0) || !(figures.counted_m2 > 0)) return;
  // The bin about 0 is half as wide as the others, the last one is drawn as wide.
  const double px_per_bin = box.width() / (bins - 0.5);
  const auto left_of = [&](double bin) { return box.min_x + std::max(0.0, bin - 0.5) * px_per_bin; };
  for (std::size_t i = 0; i < figures.histogram.size(); ++i) {
    const auto bin = static_cast<double>(i);
    const Box column{left_of(bin), ramp_top, left_of(bin + 1), ramp_bottom};
    const Colour colour = dose_colour(0.1 * bin);
    fill_box(canvas, column, colour);
    const double high = (ramp_top - 3 * k - bars_top) * figures.histogram[i].area_m2 / most_m2;
    if (!(high > 0)) continue;
    const Box bar{column.min_x + 0.6 * k, ramp_top - 3 * k - std::max(high, 0.8 * k), column.max_x - 0.6 * k,
                  ramp_top - 3 * k};
    fill_box(canvas, bar, colour);
    stroke_line(
        canvas,
        {{bar.min_x, bar.max_y}, {bar.min_x, bar.min_y}, {bar.max_x, bar.min_y}, {bar.max_x, bar.max_y}},
        {kFaintInk, 0.8 * k});
  }
  stroke_line(canvas, {{box.min_x, ramp_top - 3 * k}, {box.max_x, ramp_top - 3 * k}}, {kFaintInk, 1 * k});
  for (const int tenths : {0, 5, 10, 15, 20, 25}) {
    const double x = box.min_x + tenths * px_per_bin;
    stroke_line(canvas, {{x, ramp_bottom}, {x, ramp_bottom + 4 * k}}, {kInk, 1 * k});
    const Align align = tenths == 0 ? Align::kLeft : tenths == 25 ? Align::kRight : Align::kCentre;
    const std::string text = rate_text(0.1 * tenths * figures.reference_per_ha) + (tenths == 25 ? "+" : "");
    draw_text(canvas, {tenths == 25 ? box.max_x : x, ramp_bottom + 15 * k}, text,
              {kSmallTextSize, tenths == 10, align});
  }
  draw_text(canvas, {box.min_x, box.min_y + 8 * k},
            fmt::format("ground by rate; tallest bar {:.1f} %", 100 * most_m2 / figures.counted_m2),
            {kSmallTextSize, false, Align::kLeft, kFaintInk});
}

}  // namespace tramline::render
