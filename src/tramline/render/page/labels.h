#pragma once
// The positions of numbers on subfields, and on tracks so that no two labels overlap.

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

struct RoomyPoint {
  Point centre;        ///< page
  double room_px = 0;  ///< radius of the free circle round it; 0 where the polygon is too thin to tell
};
/// The centre of the largest free circle inside the polygon. Precondition: a valid polygon with area.
RoomyPoint roomiest_point(const Polygon& polygon, const MapView& view);

/// One badge per subfield, where there is the most room; none where there is no room for any text.
std::vector<SubfieldBadge> place_badges(const Plan& plan, const MapView& view, double scale);

/// Labels at the start ends of every 1st, 2nd, 5th, 10th, 20th … piece in driving order: the first of these
/// strides at which there is room for nearly all labels. None overlaps another or a box in `occupied`.
std::vector<TrackLabel> place_track_labels(const Plan& plan, const MapView& view, double scale,
                                           const std::vector<Box>& occupied);

/// The boxes of badges, which track labels have to avoid.
std::vector<Box> boxes_of(const std::vector<SubfieldBadge>& badges, double scale);

void draw_badges(Canvas& canvas, const Plan& plan, const std::vector<SubfieldBadge>& badges);
void draw_track_labels(Canvas& canvas, const std::vector<TrackLabel>& labels);

}  // namespace tramline::render
