#include "tramline/render/coverage/coverage_layers.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/path/simplified_line.h"
#include "tramline/render/plan/layers.h"

namespace tramline::render {
namespace {

constexpr double kUnseen = 0.15;  // px
constexpr double kLeastPath = 0.25;
constexpr double kLeastGap = 1.2;

/// What the outer rings of the field enclose and the field leaves out.
Region left_out_of(const Region& field) {
  Region out;
  for (const Polygon& polygon : field)
    for (const Ring& hole : polygon.holes) out.push_back({reversed(hole), {}});
  return out;
}

/// No more vertices than the page can show: a day's log has hundreds of thousands.
std::vector<Point> drawn_line(const Canvas& canvas, const std::vector<Point>& line) {
  std::vector<Point> out;
  for (const std::size_t i : simplified_line(line, kUnseen / canvas.view().px_per_m))
    out.push_back(canvas.view().to_page(line[i]));
  return out;
}

}  // namespace

void draw_covered(Canvas& canvas, const Coverage& coverage) {
  const double k = canvas.scale();
  const Stroke edge{kCoveredEdge, 0.8 * k};
  if (coverage.field.empty()) {
    fill(canvas, coverage.covered, kCoveredColour);
    return outline(canvas, coverage.covered, edge);
  }
  const Region obstacles = left_out_of(coverage.field);
  fill(canvas, obstacles, kObstacleColour);
  hatch(canvas, obstacles, obstacle_hatch());
  fill(canvas, coverage.field, kFieldColour);
  fill(canvas, coverage.covered, kCoveredOutsideColour);
  outline(canvas, coverage.covered, edge);
  cairo_save(canvas.cr());
  clip_to(canvas, coverage.field);
  fill(canvas, coverage.covered, kCoveredColour);
  cairo_restore(canvas.cr());
}

void draw_repeated(Canvas& canvas, const Coverage& coverage) {
  fill(canvas, coverage.repeated, kOverlapColour);
}

void draw_missed(Canvas& canvas, const Coverage& coverage) {
  fill(canvas, coverage.missed, kUncoveredColour);
  for (const Gap& gap : coverage.gaps) {
    const double shown = std::isnan(gap.widest_m) ? 0 : gap.widest_m * canvas.view().px_per_m;
    const double lacking = kLeastGap * canvas.scale() - shown;
    if (lacking > 0) outline(canvas, {gap.shape}, {kUncoveredColour, lacking});
  }
}

void draw_not_recorded(Canvas& canvas, const Coverage& coverage) {
  fill(canvas, coverage.not_recorded, kNotRecordedColour);
  hatch(canvas, coverage.not_recorded, not_recorded_hatch());
}

void draw_driven(Canvas& canvas, const Coverage& coverage) {
  const double k = canvas.scale();
  const double pass = coverage.width_m * canvas.view().px_per_m;
  const double thickness = std::clamp(0.1 * pass, kLeastPath * k, kPathLine * k);
  for (const DrivenLine& driven : coverage.lines) {
    const std::vector<Point> line = drawn_line(canvas, driven.line);
    if (line.size() < 2) continue;
    if (driven.run < 0)
      stroke_line(canvas, line, {kIdlePathColour, kPathLine * k, idle_dashes(k)});
    else
      stroke_line(canvas, line, {kWorkedPathColour, thickness});
  }
}

void draw_field_outline(Canvas& canvas, const Coverage& coverage) {
  outline(canvas, coverage.field, {kFieldEdge, kOutlineWidth * canvas.scale()});
}

}  // namespace tramline::render
