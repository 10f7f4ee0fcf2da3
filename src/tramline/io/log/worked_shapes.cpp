#include "tramline/io/log/worked_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

bool is_whole(const RawRing& ring) {
  return ring.points.size() >= 3 && std::all_of(ring.points.begin(), ring.points.end(), [](Point p) {
           return std::isfinite(p.x) && std::isfinite(p.y);
         });
}

}  // namespace

std::vector<Polygon> worked_shapes(const RawFeature& feature) {
  std::vector<Polygon> out;
  for (const RawPolygon& polygon : feature.polygons) {
    if (polygon.rings.empty() || !is_whole(polygon.rings.front())) continue;
    Polygon shape{polygon.rings.front().points, {}};
    for (std::size_t i = 1; i < polygon.rings.size(); ++i)
      if (is_whole(polygon.rings[i])) shape.holes.push_back(polygon.rings[i].points);
    out.push_back(oriented(std::move(shape)));
  }
  return out;
}

void finish_shapes(WorkLog& log, const FixRows& rows, const std::string& place) {
  const bool tells = rows.has(LogColumn::kTime) || rows.has(LogColumn::kWork) ||
                     rows.has(LogColumn::kWidth) || rows.has(LogColumn::kRate);
  if (!tells)
    throw bad_input(
        fmt::format("{} has polygons without a time, work state, width or rate: they look like fields rather "
                    "than like work; name the columns with --columns",
                    place));
  log.notes.emplace_back("the polygons are taken as worked land");
  std::size_t nothing = 0;
  for (Fix& fix : log.fixes) {
    if (fix.work != WorkState::kUnknown || fix.rate_per_ha != 0) continue;
    fix.work = WorkState::kOff;
    ++nothing;
  }
  if (nothing == 0) return;
  log.notes.push_back(fmt::format("{} of the polygons had a rate of 0: they count as not worked", nothing));
  for (Fix& fix : log.fixes)
    if (fix.work == WorkState::kUnknown) fix.work = WorkState::kOn;
}

}  // namespace tramline::io
