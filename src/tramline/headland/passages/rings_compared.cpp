#include "tramline/headland/passages/rings_compared.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

bool is_before(const PathSegment& a, const PathSegment& b) {
  const auto key = [](const PathSegment& s) {
    return std::tuple(s.from.x, s.from.y, s.to.x, s.to.y, s.curvature);
  };
  return key(a) < key(b);
}

Path sorted_segments(const std::vector<HeadlandPass>& rings) {
  Path out;
  for (const HeadlandPass& ring : rings) out.insert(out.end(), ring.path.begin(), ring.path.end());
  std::ranges::sort(out, is_before);
  return out;
}

/// Segments of two sets of rings: those of both, and those of one alone.
struct Segments {
  Path common, own, other;

  Segments(const std::vector<HeadlandPass>& rings, const std::vector<HeadlandPass>& than) {
    const Path a = sorted_segments(rings), b = sorted_segments(than);
    std::ranges::set_intersection(a, b, std::back_inserter(common), is_before);
    std::ranges::set_difference(a, b, std::back_inserter(own), is_before);
    std::ranges::set_difference(b, a, std::back_inserter(other), is_before);
  }
};

void extend_over(const Path& segments, double width_m, Box& box) {
  for (const PathSegment& segment : segments) box.extend(reach_of({segment}, width_m));
}

void append_bands(const Path& segments, double width_m, Layer layer, RisingCurves& out) {
  for (const PathSegment& segment : segments) append_band({segment}, width_m, layer, out);
}

Path near_to(const Path& segments, const Box& box, double width_m) {
  Path out;
  for (const PathSegment& segment : segments)
    if (intersects(box, reach_of({segment}, width_m))) out.push_back(segment);
  return out;
}

int meetings_of(const std::vector<HeadlandPass>& rings) {
  std::vector<Path> paths;
  for (const HeadlandPass& ring : rings) paths.push_back(ring.path);
  return meeting_count(paths);
}

}  // namespace

double more_missed_and_doubled_m2(const std::vector<HeadlandPass>& rings,
                                  const std::vector<HeadlandPass>& than, const GroundToWork& to_work,
                                  const std::vector<HeadlandPass>& before) {
  const double width_m = to_work.width_m;
  const Segments segments(rings, than);
  if (segments.own.empty() && segments.other.empty()) return 0;
  Box differs;
  extend_over(segments.own, width_m, differs);
  extend_over(segments.other, width_m, differs);
  const Path beside = near_to(segments.common, differs, width_m);
  Box window = differs;
  extend_over(beside, width_m, window);
  RisingCurves shared;
  append_bands(beside, width_m, Layer::kNew, shared);
  for (const HeadlandPass& pass : before)
    append_bands(near_to(pass.path, window, width_m), width_m, Layer::kCovered, shared);
  for (const Ring& ring : rings_of(to_work.ground)) append_ring(ring, Layer::kBody, window, shared);
  const auto cost_m2 = [&](const Path& alone) {
    RisingCurves curves = shared;
    append_bands(alone, width_m, Layer::kNew, curves);
    return width_m * length(alone) - (1 + kMissedToDoubled) * newly_covered_area(curves);
  };
  return cost_m2(segments.own) - cost_m2(segments.other);
}

bool are_better(const std::vector<HeadlandPass>& rings, const std::vector<HeadlandPass>& than,
                const GroundToWork& to_work, const std::vector<HeadlandPass>& before) {
  const int meetings = meetings_of(rings), of_others = meetings_of(than);
  if (meetings != of_others) return meetings < of_others;
  return more_missed_and_doubled_m2(rings, than, to_work, before) < -kNoGain_m2;
}

}  // namespace tramline
