#pragma once
// The layers of the map, in the order they are drawn.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

/// The land of the field, and the pale tint of each subfield.
void draw_ground(Canvas& canvas, const Plan& plan);
/// The land of the headland, under everything except that of the field.
void draw_headland_ground(Canvas& canvas, const Plan& plan);
/// Every second headland pass a shade darker, as swaths are.
void draw_headland_swaths(Canvas& canvas, const Plan& plan);
/// Headland passes, with arrow heads where they are inside `seen`, m.
void draw_headland_passes(Canvas& canvas, const Plan& plan, const Box& seen);
/// The reference lines that tracks run parallel to, where they are inside `seen`, m, or a little beyond.
void draw_references(Canvas& canvas, const Plan& plan, const Box& seen);
/// Every second swath of a subfield a shade darker, where the scale allows swaths to be distinguished.
void draw_swaths(Canvas& canvas, const Plan& plan);
/// Passable obstacles, then obstacles.
void draw_obstacles(Canvas& canvas, const Plan& plan);
/// Borders of subfields, then the field's outline.
void draw_outlines(Canvas& canvas, const Plan& plan);
/// Centre lines, and dropped pieces dashed.
void draw_track_lines(Canvas& canvas, const Plan& plan);
/// The turns between tracks: the way of the axle's middle, dashed in reverse; those without room in red.
/// Where tracks are far apart and nothing fits, nothing is drawn.
void draw_turns(Canvas& canvas, const Plan& plan);
/// The legs of the route with the work off and with room: turns, transits, and backing out dashed as
/// everything in reverse.
void draw_route(Canvas& canvas, const Plan& plan);
/// Those without room, in red.
void draw_ways_without_room(Canvas& canvas, const Plan& plan);
/// Where the route starts and where it ends.
void draw_route_ends(Canvas& canvas, const Plan& plan);
/// An arrow head on each track, or on some of very close tracks, where it is inside `seen`, m.
void draw_arrow_heads(Canvas& canvas, const Plan& plan, const Box& seen);
/// The parts of tracks that go round obstacles, on a white rim.
void draw_detours(Canvas& canvas, const Plan& plan);
/// Uncovered land, unworked headland and overlap, drawn at least kSliverWidth wide so that every sliver is
/// visible. Land given up on purpose is uncovered too, and hatched.
void draw_faults(Canvas& canvas, const Plan& plan);
/// A mark wherever the machine has to back out.
void draw_stops(Canvas& canvas, const Plan& plan);
/// Whether there is room between the stop marks of neighbouring tracks.
bool stops_stand_apart(const Canvas& canvas, const Plan& plan);

/// The width of swaths on the page, px.
double swath_px(const Canvas& canvas, const Plan& plan);
/// Narrower swaths than this cannot be distinguished, px at text scale 1.
inline constexpr double kLeastStripe = 2.5;

/// Least width of a drawn fault, px at text scale 1.
inline constexpr double kSliverWidth = 1.5;

}  // namespace tramline::render
