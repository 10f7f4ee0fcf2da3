#pragma once
// The layout of a page. All page coordinates are pixels, x right, y down.

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline::render {

/// The transformation from the field's frame to the page: one scale, north up.
struct MapView {
  Point centre_m;   ///< the point of the field's frame in the middle of the map
  Point centre_px;  ///< the middle of the map on the page
  double px_per_m = 1;

  Point to_page(Point p) const {
    return {centre_px.x + (p.x - centre_m.x) * px_per_m, centre_px.y - (p.y - centre_m.y) * px_per_m};
  }
};

/// The page and its parts. Boxes are in pixels, min_y at the top.
struct PageLayout {
  int width_px = 0;
  int height_px = 0;
  double text_scale = 1;  ///< 1 for pages up to 1600 px wide: text never becomes smaller than 14 px
  Box title;
  Box map;          ///< the drawing, labels of tracks included
  Box scale_strip;  ///< under the map: north arrow and scale bar
  Box panel;        ///< the legend, at the right of the map or below it
  int panel_columns = 1;
  MapView view;
};

/// Lays a page out for a field: the legend at the right of a compact field, below a wide one.
/// `block_heights` are those of the legend's blocks in pixels at text scale 1.
PageLayout lay_out_page(const Box& drawn_m, int width_px, const std::vector<double>& block_heights);

/// The box round everything a plan draws, m: field, swaths, dropped pieces.
Box drawn_box(const Plan& plan);

/// The column of each legend block, where blocks are put one after the other into the column that is shortest
/// so far (the leftmost among equals).
std::vector<int> columns_of_blocks(const std::vector<double>& block_heights, int columns);

}  // namespace tramline::render
