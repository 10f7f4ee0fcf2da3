#pragma once
// The marks, hatches and line styles that maps and their legends share.

#include <vector>

#include "tramline/render/page/canvas.h"

namespace tramline::render {

/// Marks. Pixels of the page.
void draw_stop_mark(Canvas& canvas, Point at, double radius);
void draw_arrow_head(Canvas& canvas, Point tip, Point heading, double size, Colour colour);

/// Where a route starts or ends: a disc with a white rim.
void draw_route_mark(Canvas& canvas, Point at, Colour colour);

/// A number in a disc.
void draw_gap_badge(Canvas& canvas, Point centre, int number);

/// Its radius, px at text scale 1.
inline constexpr double kGapBadgeRadius = 12;

/// Hatches.
const Hatch& obstacle_hatch();
const Hatch& passable_hatch();
const Hatch& given_up_hatch();
const Hatch& not_recorded_hatch();
/// Widths and dashes of lines, px at text scale 1.
inline constexpr double kTrackLine = 1.1;
inline constexpr double kDetourLine = 2.2;
inline constexpr double kTurnLine = 1.3;
inline constexpr double kDetourRimWidth = 1.1;  ///< on each side
inline constexpr double kHeadlandLine = 1.4;
inline constexpr double kHeadlandDash = 9;
inline constexpr double kReferenceLine = 2;
inline constexpr double kReferenceBeyond = 18;  ///< length drawn beyond the field
std::vector<double> reference_dashes(double scale);
inline constexpr double kDroppedLine = 1.8;
inline constexpr double kOutlineWidth = 2.2;
inline constexpr double kStopRadius = 4.2;
inline constexpr double kRouteMarkRadius = 5;
inline constexpr double kKeepOffLine = 1.6;
inline constexpr double kKeepOffDash = 7;
inline constexpr double kSwathEdgeLine = 0.8;
inline constexpr double kRadiusLine = 1.2;
/// The width of the driven path; thinner where passes lie close together on the page.
inline constexpr double kPathLine = 0.9;
std::vector<double> idle_dashes(double scale);

}  // namespace tramline::render
