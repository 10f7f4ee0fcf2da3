#include <algorithm>
#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/render/page/legend.h"
#include "tramline/render/page/map_decorations.h"
#include "tramline/render/page/text.h"
#include "tramline/render/plan/draw_plan.h"
#include "tramline/render/plan/layers.h"
#include "tramline/render/plan/small_map.h"

namespace tramline::render {
namespace {

constexpr double kSheetMargin = 28;
constexpr double kSheetTitle = 62;
constexpr double kSheetGap = 28;
constexpr double kCaptionHeading = 26;
constexpr double kCaptionLine = 22;

/// The page from top to bottom: title, rows of maps with their captions, legend.
struct Sheet {
  int width_px = 0, height_px = 0;
  double k = 1;
  Box title;
  PageLayout panel;  ///< for draw_legend()
  std::size_t columns = 1;
  double cell_width = 0, caption_height = 0, map_height = 0;

  Box map(std::size_t index) const {
    const auto column = static_cast<double>(index % columns);
    const std::size_t row_number = index / columns;
    const auto row = static_cast<double>(row_number);
    const double left = kSheetMargin * k + column * (cell_width + kSheetGap * k);
    const double top = title.max_y + row * (map_height + caption_height + kSheetGap * k) + caption_height;
    return {left, top, left + cell_width, top + map_height};
  }
};

/// Rows as even as they can be, of four maps at most.
std::size_t columns_for(std::size_t maps) {
  constexpr std::size_t kMost = 4;
  const std::size_t rows = (maps + kMost - 1) / kMost;
  return std::max<std::size_t>(2, (maps + rows - 1) / rows);
}

Sheet lay_out_sheet(const Box& drawn_m, const std::vector<SmallMap>& maps, int width_px,
                    double legend_height) {
  Sheet out;
  out.width_px = width_px;
  out.k = std::max(1.0, width_px / 1600.0);
  const double k = out.k, left = kSheetMargin * k, right = width_px - kSheetMargin * k;
  out.title = {left, kSheetMargin * k, right, (kSheetMargin + kSheetTitle) * k};
  out.columns = columns_for(maps.size());
  const auto columns = static_cast<double>(out.columns);
  out.cell_width = (right - left - (columns - 1) * kSheetGap * k) / columns;
  std::size_t lines = 0;
  for (const SmallMap& map : maps) lines = std::max(lines, map.lines.size());
  out.caption_height = (kCaptionHeading + static_cast<double>(lines) * kCaptionLine) * k;
  out.map_height = small_map_height(drawn_m, out.cell_width);
  const double below = out.map(maps.size() - 1).max_y + kSheetGap * k;
  out.panel.panel = {left, below, right, below + legend_height * k};
  out.height_px = static_cast<int>(std::ceil(out.panel.panel.max_y + kSheetMargin * k));
  return out;
}

/// Of tracks too close together to be seen one by one, every how manieth is drawn.
int drawn_every(double swath_px, double k) {
  constexpr double kApart = 6;  ///< of the tracks drawn, px at text scale 1
  if (swath_px >= kLeastStripe * k) return 1;
  return static_cast<int>(std::ceil(kApart * k / swath_px));
}

/// The plan with those tracks only, and all that stop or leave their line.
Plan thinned(Plan plan, int every) {
  if (every == 1) return plan;
  std::erase_if(plan.pieces, [every](const TrackPiece& piece) {
    return piece.track % every != 0 && piece.detours.empty() && !piece.stop_at_start && !piece.stop_at_end;
  });
  return plan;
}

/// The legend of what small maps show.
LegendBlock legend_of_sheet(const std::vector<Plan>& plans, const char* track) {
  LegendBlock out = legend_of_all(plans);
  std::erase_if(out.rows, [](const LegendRow& row) {
    return row.symbol == Symbol::kHeadlandPass || row.symbol == Symbol::kReference;
  });
  for (LegendRow& row : out.rows)
    if (row.symbol == Symbol::kTrack) row.text = track;
  return out;
}

/// Of the narrowest swaths.
double least_width_m(const std::vector<SmallMap>& maps) {
  double out = maps.front().plan.machine.width_m;
  for (const SmallMap& map : maps) out = std::min(out, map.plan.machine.width_m);
  return out;
}

void draw_small_map_caption(Canvas& canvas, const SmallMap& map, const Box& map_px, double caption_height) {
  const double k = canvas.scale();
  const TextStyle bold{kTextSize, true}, plain{kSmallTextSize, false, Align::kLeft, kFaintInk};
  double y = map_px.min_y - caption_height + 0.5 * kCaptionHeading * k;
  draw_text(canvas, {map_px.min_x, y}, fitted(canvas, map.heading, bold, map_px.width()), bold);
  for (const std::string& line : map.lines) {
    y += kCaptionLine * k;
    draw_text(canvas, {map_px.min_x, y}, fitted(canvas, line, plain, map_px.width()), plain);
  }
}

}  // namespace

void draw_small_maps(const std::string& title, const std::string& subtitle, const std::vector<SmallMap>& maps,
                     const std::filesystem::path& path, const PictureOptions& options) {
  const PictureFormat format = format_of(path);
  require_picture_width(options);
  if (maps.empty()) throw bad_input("there is no map to draw");
  std::vector<Plan> plans;
  for (const SmallMap& map : maps) plans.push_back(map.plan);
  std::vector<LegendBlock> legend{legend_of_sheet(plans, "track")};
  const Box drawn = drawn_box(plans);
  const Sheet page = lay_out_sheet(drawn, maps, options.width_px, heights_of(legend).front());
  const double m_per_px = small_map_scale(drawn, page.map(0), page.k);
  if (drawn_every(least_width_m(maps) / m_per_px, page.k) > 1)
    legend = {legend_of_sheet(plans, "track, where they are close only some of them")};

  Canvas canvas(format, page.width_px, page.height_px);
  canvas.use({}, page.k);
  draw_title(canvas, page.title, title, subtitle);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    draw_small_map_caption(canvas, maps[i], page.map(i), page.caption_height);
    const int every = drawn_every(plans[i].machine.width_m / m_per_px, page.k);
    draw_small_map(canvas, thinned(plans[i], every), drawn, page.map(i), page.k);
  }
  draw_legend(canvas, page.panel, legend);
  write_whole(path, canvas.finish());
}

}  // namespace tramline::render
