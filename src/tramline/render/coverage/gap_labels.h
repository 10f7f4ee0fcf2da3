#pragma once
// The numbers of the largest gaps: in the gap where there is room, else beside it with a leader.

#include <vector>

#include "tramline/model/coverage.h"
#include "tramline/render/page/map_symbols.h"

namespace tramline::render {

struct GapLabel {
  int number = 0;
  Point gap;    ///< the gap's centre, on the page
  Point badge;  ///< centre of the badge; the same where there is room
};

/// Labels of the kGapsNumbered first gaps whose centres lie within `map`, a box of the page. No two badges
/// overlap, none hides the centre of another numbered gap, and no leader runs through a badge, as far as
/// there is room for that. The shortest leader is chosen, among equals the one nearest to pointing up and
/// right. Every badge lies in `map`.
std::vector<GapLabel> place_gap_labels(const std::vector<Gap>& gaps, const MapView& view, double scale,
                                       const Box& map);

void draw_gap_labels(Canvas& canvas, const std::vector<GapLabel>& labels);

}  // namespace tramline::render
