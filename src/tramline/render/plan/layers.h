#pragma once
// The layers of the map, in the order they are drawn.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

/// The field's ground and the pale tint of each subfield.
void draw_ground(Canvas& canvas, const Plan& plan);
/// The ground of the headland, under everything but the field's.
void draw_headland_ground(Canvas& canvas, const Plan& plan);
/// Every second headland pass a shade darker, as swaths are.
void draw_headland_swaths(Canvas& canvas, const Plan& plan);
/// Headland passes, with arrow heads where they are inside `seen`, m.
void draw_headland_passes(Canvas& canvas, const Plan& plan, const Box& seen);
/// What the tracks run parallel to, as far as it is inside `seen`, m, or a little beyond.
void draw_references(Canvas& canvas, const Plan& plan, const Box& seen);
/// Every second swath of a subfield a shade darker, as far as the scale lets swaths be told apart.
void draw_swaths(Canvas& canvas, const Plan& plan);
/// Passable obstacles, then obstacles.
void draw_obstacles(Canvas& canvas, const Plan& plan);
/// Borders of subfields, then the field's outline.
void draw_outlines(Canvas& canvas, const Plan& plan);
/// Centre lines, and dropped pieces dashed.
void draw_track_lines(Canvas& canvas, const Plan& plan);
/// An arrow head on each track, of very close ones on some, where it is inside `seen`, m.
void draw_arrow_heads(Canvas& canvas, const Plan& plan, const Box& seen);
/// The parts of tracks that go round obstacles, on a white rim.
void draw_detours(Canvas& canvas, const Plan& plan);
/// Uncovered land, unworked headland and overlap, at least kSliverWidth wide so that no sliver escapes the
/// eye. Land given up on purpose is uncovered too, and hatched.
void draw_faults(Canvas& canvas, const Plan& plan);
/// A mark wherever the machine has to back out.
void draw_stops(Canvas& canvas, const Plan& plan);
/// Whether the stops of neighbouring tracks leave room between them.
bool stops_stand_apart(const Canvas& canvas, const Plan& plan);

/// How wide swaths are on the page.
double swath_px(const Canvas& canvas, const Plan& plan);
/// Narrower swaths than this are too fine to be told apart, px at text scale 1.
inline constexpr double kLeastStripe = 2.5;

/// Least width of a drawn fault, px at text scale 1.
inline constexpr double kSliverWidth = 1.5;

}  // namespace tramline::render
