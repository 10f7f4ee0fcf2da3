#include "tramline/render/close_up/close_up_layers.h"

#include <cmath>
#include <numbers>
#include <optional>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/close_up/close_up_window.h"

namespace tramline::render {
namespace {

Ring swath_in_view(const Canvas& canvas, const Plan& near, const TrackPiece& piece) {
  return band(centre_line(piece), near.machine.width_m, sagitta_m(canvas.view()));
}

Polygon swath_in_view(const Canvas& canvas, const Plan& near, const HeadlandPass& pass) {
  return swath(pass, near.machine.width_m, sagitta_m(canvas.view()));
}

// cairo's coordinates end at some 8 million px; a circle that large is a straight line anyway.
constexpr double kLargestCircle = 1e5;

void draw_circle(Canvas& canvas, Point centre, double radius, const Stroke& stroke) {
  cairo_new_path(canvas.cr());
  cairo_arc(canvas.cr(), centre.x, centre.y, radius, 0, 2 * std::numbers::pi);
  set_stroke(canvas, stroke);
  cairo_stroke(canvas.cr());
}

std::optional<PathSegment> tightest_arc(const Path& path) {
  const PathSegment* best = nullptr;
  for (const PathSegment& segment : path) {
    if (segment.straight()) continue;
    // Arcs that are mirror images of one another differ by rounding only.
    constexpr double kSame = 1e-6;
    const bool tighter = best == nullptr || radius(segment) < radius(*best) * (1 - kSame);
    const bool as_tight = best != nullptr && radius(segment) < radius(*best) * (1 + kSame);
    if (tighter || (as_tight && length(segment) > length(*best) * (1 + kSame))) best = &segment;
  }
  return best == nullptr ? std::nullopt : std::optional(*best);
}

}  // namespace

void draw_worked_land(Canvas& canvas, const Plan& near) {
  for (const TrackPiece& piece : near.pieces)
    fill(canvas, {{swath_in_view(canvas, near, piece), {}}}, kWorkedLandColour);
  for (const HeadlandPass& pass : near.headland.passes)
    fill(canvas, {swath_in_view(canvas, near, pass)}, kWorkedLandColour);
}

void draw_keep_off_lines(Canvas& canvas, const Plan& near) {
  const double k = canvas.scale();
  for (const Obstacle& obstacle : near.field.obstacles) {
    if (obstacle.kind != ObstacleKind::kObstacle) continue;
    const Region near_to_it = buffered({obstacle.shape}, keep_off_m(near), JoinStyle::kRound, 32);
    outline(canvas, near_to_it, {kDetourRim, kKeepOffLine * k});
    outline(canvas, near_to_it,
            {kKeepOffColour, kKeepOffLine * k, {kKeepOffDash * k, 0.6 * kKeepOffDash * k}});
  }
}

void draw_swath_edges(Canvas& canvas, const Plan& near) {
  const Stroke edge{kSwathEdgeColour, kSwathEdgeLine * canvas.scale()};
  for (const HeadlandPass& pass : near.headland.passes)
    outline(canvas, {swath_in_view(canvas, near, pass)}, edge);
  for (const TrackPiece& piece : near.pieces)
    outline(canvas, {{swath_in_view(canvas, near, piece), {}}}, edge);
}

void draw_tightest_arcs(Canvas& canvas, const Plan& near, std::size_t obstacle) {
  const double k = canvas.scale();
  for (const PathSegment& arc : tightest_arcs(near, obstacle)) {
    const double radius_px = radius(arc) * canvas.view().px_per_m;
    if (radius_px > kLargestCircle) continue;
    const Point middle = canvas.view().to_page(centre(arc));
    draw_circle(canvas, middle, radius_px, {kRadiusColour, kRadiusLine * k, {3 * k, 3 * k}});
    stroke_line(canvas, {middle, canvas.view().to_page(middle_of_arc(arc))},
                {kRadiusColour, kRadiusLine * k});
    disc(canvas, middle, 2.5 * k, kDetourColour);
  }
}

void draw_frame(Canvas& canvas, const Box& b) {
  stroke_line(
      canvas,
      {{b.min_x, b.min_y}, {b.max_x, b.min_y}, {b.max_x, b.max_y}, {b.min_x, b.max_y}, {b.min_x, b.min_y}},
      {kRule, 1.2 * canvas.scale()});
}

std::vector<PathSegment> tightest_arcs(const Plan& near, std::size_t obstacle) {
  std::vector<PathSegment> out;
  for (const TrackPiece& piece : near.pieces)
    for (const Detour& detour : piece.detours)
      if (avoids(detour, obstacle))
        if (const auto arc = tightest_arc(detour.path)) out.push_back(*arc);
  return out;
}

Point middle_of_arc(const PathSegment& arc) {
  const Point hub = centre(arc);
  const Point spoke = arc.from - hub;
  const double angle = std::atan2(spoke.y, spoke.x) + 0.5 * turning(arc);
  return hub + radius(arc) * Point{std::cos(angle), std::sin(angle)};
}

}  // namespace tramline::render
