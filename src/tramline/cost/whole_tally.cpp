#include "tramline/cost/whole_tally.h"

#include <algorithm>

#include "tramline/cost/settled_areas.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/strip/track_frame.h"

namespace tramline {
namespace {

/// Collects everything that is worked, turned so that most tracks lie across the sweep of
/// newly_covered_area(): each is then met at few heights.
class Works {
 public:
  Works(Direction tracks, double width_m) : frame_(tracks.perpendicular()), width_m_(width_m) {}

  void add(const Path& path) {
    const Path turned = moved(path, [this](Point p) { return frame_.to_track(p); });
    window_.extend(reach_of(turned, width_m_));
    append_band(turned, width_m_, Layer::kNew, curves_);
  }
  /// A swath with kinks has no band; its cells have its area.
  void add_kinked(const Path& path) {
    for (const Ring& cell : kinked_cells(path, width_m_)) {
      const Ring turned = frame_.to_track(cell);
      window_.extend(bounds(turned));
      append_ring(turned, Layer::kNew, bounds(turned), curves_);
    }
  }
  double area_on(const Region& body, const Region& ground) {
    append_land(body);
    append_land(ground);
    return newly_covered_area(curves_);
  }

 private:
  void append_land(const Region& land) {
    for (const Ring& ring : rings_of(frame_.to_track(land)))
      append_ring(ring, Layer::kBody, window_, curves_);
  }

  TrackFrame frame_;
  double width_m_;
  Box window_;
  RisingCurves curves_;
};

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
  Works works(main_direction(pieces), width_m);
  for (const TrackPiece& piece : pieces)
    if (has_kinks(piece.curve))
      works.add_kinked(piece.curve);
    else
      works.add(centre_line(piece));
  for (const HeadlandPass& pass : headland.passes)
    if (has_kinks(pass.path))
      works.add_kinked(pass.path);
    else
      works.add(pass.path);
  const double covered_m2 = works.area_on(body, headland.ground);
  Tally out = tracks;
  out.worked_m2 = tracks.worked_m2 + headland.worked_m2;
  settle_areas(out, covered_m2, area(body) + area(headland.ground));
  return out;
}

}  // namespace tramline
