#include "tramline/headland/worth/pass_work.h"

#include <algorithm>

#include "tramline/headland/tolerances.h"

namespace tramline {
namespace {

/// Segments in a section: those that follow one another lie together.
constexpr std::size_t kInSection = 32;

double area_on(const Region& land, const Path& path, const Box& window, double width_m,
               const Swaths* covered) {
  RisingCurves curves;
  for (const Ring& ring : rings_of(land))
    if (intersects(bounds(ring), window)) append_ring(ring, Layer::kBody, window, curves);
  if (curves.empty()) return 0;
  if (covered != nullptr) covered->append_near(window, curves);
  append_band(path, width_m, Layer::kNew, curves);
  return newly_covered_area(curves);
}

}  // namespace

bool is_closed(const Path& path) { return distance(path.back().to, path.front().from) < kSamePlace_m; }

void Swaths::add(const Path& path) {
  for (const PathSegment& segment : path) {
    if (segments_.size() % kInSection == 0) sections_.emplace_back();
    segments_.push_back(segment);
    boxes_.push_back(reach_of({segment}, width_m_));
    sections_.back().extend(boxes_.back());
  }
}

void Swaths::append_near(const Box& window, RisingCurves& out) const {
  for (std::size_t section = 0; section < sections_.size(); ++section) {
    if (!intersects(window, sections_[section])) continue;
    const std::size_t first = section * kInSection;
    for (std::size_t i = first; i < std::min(first + kInSection, segments_.size()); ++i)
      if (intersects(window, boxes_[i])) append_band({segments_[i]}, width_m_, Layer::kCovered, out);
  }
}

Swaths swaths_of(const std::vector<HeadlandPass>& passes, double width_m) {
  Swaths out(width_m);
  for (const HeadlandPass& pass : passes) out.add(pass.path);
  return out;
}

PassWork work_of(const Path& path, const GroundToWork& to_work, const Swaths& covered) {
  const Box window = reach_of(path, to_work.width_m);
  PassWork out{to_work.width_m * length(path),
               area_on(to_work.ground, path, window, to_work.width_m, &covered)};
  if (!to_work.passable.empty())
    out.worked_m2 -= area_on(to_work.passable, path, window, to_work.width_m, nullptr);
  return out;
}

}  // namespace tramline
