#pragma once
// The layers of the map, in the order they are drawn.

#include <vector>

#include "tramline/model/plan.h"
#include "tramline/render/page/canvas.h"

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

/// The marks, also used by the legend. Pixels of the page.
void draw_stop_mark(Canvas& canvas, Point at, double radius);
void draw_arrow_head(Canvas& canvas, Point tip, Point heading, double size, Colour colour);

/// Styles shared with the legend.
const Hatch& obstacle_hatch();
const Hatch& passable_hatch();
const Hatch& given_up_hatch();
const Hatch& not_recorded_hatch();
/// The line of a track, px at text scale 1.
inline constexpr double kTrackLine = 1.1;
inline constexpr double kDetourLine = 2.2;
inline constexpr double kDetourRimWidth = 1.1;  ///< on each side
inline constexpr double kHeadlandLine = 1.4;
inline constexpr double kHeadlandDash = 9;
inline constexpr double kReferenceLine = 2;
inline constexpr double kReferenceBeyond = 18;  ///< how far it is drawn beyond the field
std::vector<double> reference_dashes(double scale);
inline constexpr double kDroppedLine = 1.8;
inline constexpr double kOutlineWidth = 2.2;
inline constexpr double kStopRadius = 4.2;

}  // namespace tramline::render
