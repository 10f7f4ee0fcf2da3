#pragma once
// The layers that only close-ups have, in the order they are drawn.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

/// The land of all swaths in a light colour; darker where two of them overlap.
void draw_worked_land(Canvas& canvas, const Plan& near);
/// Dashed lines at the least distance of a track from each obstacle.
void draw_keep_off_lines(Canvas& canvas, const Plan& near);
void draw_swath_edges(Canvas& canvas, const Plan& near);
/// The whole circle of the tightest arc of each detour round the obstacle, and a radius to the arc.
void draw_tightest_arcs(Canvas& canvas, const Plan& near, std::size_t obstacle);

void draw_frame(Canvas& canvas, const Box& box_px);

/// The tightest arc of each detour round the obstacle; the longest among equals. Detours without arcs are
/// left out.
std::vector<PathSegment> tightest_arcs(const Plan& near, std::size_t obstacle);
/// The point half way along an arc.
Point middle_of_arc(const PathSegment& arc);

}  // namespace tramline::render
