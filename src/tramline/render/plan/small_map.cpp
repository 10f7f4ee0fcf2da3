#include "tramline/render/plan/small_map.h"

#include <algorithm>

#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

constexpr double kTallestSmallMap = 1.2;  ///< of its width
constexpr double kSmallMapPadding = 8;
/// Lines of small maps are thinner than those of a page of its own.
constexpr double kMapScale = 0.6;

MapView view_of(const Box& drawn_m, const Box& map, double padding) {
  const double wide = std::max(drawn_m.width(), 0.01), high = std::max(drawn_m.height(), 0.01);
  return {drawn_m.centre(), map.centre(),
          std::min((map.width() - 2 * padding) / wide, (map.height() - 2 * padding) / high)};
}

}  // namespace

LegendBlock legend_of_all(const std::vector<Plan>& plans) {
  LegendBlock out{"Plans", {}};
  for (const Plan& plan : plans) {
    const LegendBlock symbols = legend_of(plan).front();
    for (const LegendRow& row : symbols.rows)
      if (std::none_of(out.rows.begin(), out.rows.end(),
                       [&](const LegendRow& other) { return other.symbol == row.symbol; }))
        out.rows.push_back(row);
  }
  std::stable_sort(out.rows.begin(), out.rows.end(),
                   [](const LegendRow& a, const LegendRow& b) { return a.symbol < b.symbol; });
  for (LegendRow& row : out.rows)
    if (row.symbol == Symbol::kTrack) row.text = "track";  // small maps have no numbers
  return out;
}

Box drawn_box(const std::vector<Plan>& plans) {
  Box out;
  for (const Plan& plan : plans) out.extend(render::drawn_box(plan));
  return out;
}

double small_map_height(const Box& drawn_m, double width_px) {
  const double shape = std::max(drawn_m.height(), 0.01) / std::max(drawn_m.width(), 0.01);
  return std::clamp(shape, 0.2, kTallestSmallMap) * width_px;
}

double small_map_scale(const Box& drawn_m, const Box& map_px, double k) {
  return 1 / small_map_view(drawn_m, map_px, k).px_per_m;
}

MapView small_map_view(const Box& drawn_m, const Box& map_px, double k) {
  return view_of(drawn_m, map_px, kSmallMapPadding * k);
}

void draw_small_map(Canvas& canvas, const Plan& plan, const Box& drawn_m, const Box& map_px, double k) {
  canvas.use(small_map_view(drawn_m, map_px, k), kMapScale * k);
  draw_ground(canvas, plan);
  draw_swaths(canvas, plan);
  draw_obstacles(canvas, plan);
  draw_track_lines(canvas, plan);
  draw_outlines(canvas, plan);
  draw_faults(canvas, plan);
  draw_detours(canvas, plan);
  draw_stops(canvas, plan);
  canvas.use({}, k);
}

}  // namespace tramline::render
