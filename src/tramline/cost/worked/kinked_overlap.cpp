#include "tramline/cost/worked/kinked_overlap.h"

#include <algorithm>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

struct Cell {
  std::size_t piece = 0;
  Direction along;
  Ring ring;
};

std::vector<Cell> cells_of(const std::vector<TrackPiece>& pieces, double width_m) {
  std::vector<Cell> out;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const Path line = centre_line(pieces[i]);
    std::vector<Ring> rings = kinked_cells(line, width_m);
    for (std::size_t k = 0; k < rings.size(); ++k)
      out.push_back({i, Direction::along(line[k].from, line[k].to), std::move(rings[k])});
  }
  return out;
}

}  // namespace

std::vector<double> overlap_by_kinked_piece(const Region& body, const std::vector<TrackPiece>& pieces,
                                            double width_m) {
  const std::vector<Cell> cells = cells_of(pieces, width_m);
  const std::vector<Ring> rings = rings_of(body);
  std::vector<Box> boxes;
  for (const Cell& cell : cells) boxes.push_back(bounds(cell.ring));
  const BoxGrid grid(boxes);
  std::vector<double> out;
  for (const TrackPiece& piece : pieces) out.push_back(width_m * length(piece));
  for (std::size_t i = 0; i < cells.size(); ++i) {
    // In a frame along the cell its window holds little else.
    const TrackFrame frame(cells[i].along);
    const Ring own = frame.to_track(cells[i].ring);
    const Box window = bounds(own);
    RisingCurves curves;
    append_ring(own, Layer::kNew, window, curves);
    for (const Ring& ring : rings) append_ring(frame.to_track(ring), Layer::kBody, window, curves);
    grid.each_meeting(boxes[i], [&](std::size_t k) {
      if (k < i) append_ring(frame.to_track(cells[k].ring), Layer::kCovered, window, curves);
    });
    out[cells[i].piece] -= newly_covered_area(curves);
  }
  for (double& overlap_m2 : out) overlap_m2 = std::max(0.0, overlap_m2);
  return out;
}

}  // namespace tramline
