#include "tramline/cost/whole_tally.h"

#include "tramline/cost/settled_areas.h"
#include "tramline/cost/worked/covered_land.h"
#include "tramline/geometry/path/kinked_line.h"

namespace tramline {
namespace {

/// Direction of the longest piece.
Direction main_direction(const std::vector<TrackPiece>& pieces) {
  Point along{0, 1};
  for (const TrackPiece& piece : pieces)
    if (distance(piece.start, piece.end) > distance({0, 0}, along)) along = piece.end - piece.start;
  return Direction::along({0, 0}, along);
}

}  // namespace

Tally whole_tally(const Tally& tracks, const std::vector<TrackPiece>& pieces, const Region& body,
                  const Headland& headland, double width_m) {
  if (headland.ground.empty() && headland.passes.empty()) return tracks;
  std::vector<CoveringSwath> swaths;
  for (const TrackPiece& piece : pieces)
    swaths.push_back(
        {centre_line(piece), has_kinks(piece.curve) ? SwathEdges::kMitred : SwathEdges::kSmooth});
  for (const HeadlandPass& pass : headland.passes)
    swaths.push_back({pass.path, has_kinks(pass.path) ? SwathEdges::kMitred : SwathEdges::kSmooth});
  const double covered = covered_m2(swaths, {&body, &headland.ground}, width_m, main_direction(pieces));
  Tally out = tracks;
  out.worked_m2 = tracks.worked_m2 + headland.worked_m2;
  settle_areas(out, covered, area(body) + area(headland.ground));
  return out;
}

}  // namespace tramline
