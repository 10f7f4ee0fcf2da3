#pragma once
// Where the numbers go: on subfields, and on tracks so that no two labels meet.

#include <string>
#include <vector>

#include "tramline/render/page/canvas.h"

namespace tramline::render {

struct TrackLabel {
  std::string text;  ///< the piece's number in driving order, from 1
  Point centre;      ///< page
  Box box;           ///< page
};

struct SubfieldBadge {
  std::size_t subfield = 0;
  Point centre;        ///< page
  double room_px = 0;  ///< radius of the free circle round it
};

struct RoomyPlace {
  Point centre;        ///< page
  double room_px = 0;  ///< radius of the free circle round it; 0 where the polygon is too thin to tell
};
/// Where a text has the most room inside the polygon. Precondition: a valid polygon with area.
RoomyPlace roomiest_place(const Polygon& polygon, const MapView& view);

/// One badge per subfield, where it has the most room; none where there is room for no text at all.
std::vector<SubfieldBadge> place_badges(const Plan& plan, const MapView& view, double scale);

/// Labels at the start ends of every 1st, 2nd, 5th, 10th, 20th … piece in driving order: the first of
/// these strides at which nearly all labels find room. None overlaps another or `taken`.
std::vector<TrackLabel> place_track_labels(const Plan& plan, const MapView& view, double scale,
                                           const std::vector<Box>& taken);

/// Boxes that track labels have to keep off.
std::vector<Box> boxes_of(const std::vector<SubfieldBadge>& badges, double scale);

void draw_badges(Canvas& canvas, const Plan& plan, const std::vector<SubfieldBadge>& badges);
void draw_track_labels(Canvas& canvas, const std::vector<TrackLabel>& labels);

}  // namespace tramline::render
