#include "tramline/cost/worked/covered_land.h"

#include <algorithm>
#include <cassert>

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

  void add(const CoveringSwath& swath) {
    if (swath.edges == SwathEdges::kMitred)
      add_mitred(swath.path);
    else
      add_smooth(swath.path);
  }
  double area_on(const std::vector<const Region*>& land) {
    for (const Region* region : land) append_land(*region);
    return newly_covered_area(curves_);
  }

 private:
  void add_smooth(const Path& path) {
    const Path turned = moved(path, [this](Point p) { return frame_.to_track(p); });
    window_.extend(reach_of(turned, width_m_));
    append_band(turned, width_m_, Layer::kNew, curves_);
  }
  /// A swath with kinks has no band; its cells have its area.
  void add_mitred(const Path& path) {
    assert(std::all_of(path.begin(), path.end(), [](const PathSegment& s) { return s.straight(); }));
    for (const Ring& cell : kinked_cells(path, width_m_)) {
      const Ring turned = frame_.to_track(cell);
      window_.extend(bounds(turned));
      append_ring(turned, Layer::kNew, bounds(turned), curves_);
    }
  }
  void append_land(const Region& land) {
    for (const Ring& ring : rings_of(frame_.to_track(land)))
      append_ring(ring, Layer::kBody, window_, curves_);
  }

  TrackFrame frame_;
  double width_m_;
  Box window_;
  RisingCurves curves_;
};

}  // namespace

double covered_m2(const std::vector<CoveringSwath>& swaths, const std::vector<const Region*>& land,
                  double width_m, Direction main) {
  Works works(main, width_m);
  for (const CoveringSwath& swath : swaths) works.add(swath);
  return works.area_on(land);
}

}  // namespace tramline
