#include "tramline/check/measure/swath_core.h"

#include <algorithm>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/plan_facts.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

/// A corner of the rectangle that lies outside, or its middle where only an edge bulges.
Point point_outside(const Ring& outer, const PieceFrame& frame, const Box& box) {
  for (const double x : {box.min_x, box.max_x})
    for (const double y : {box.min_y, box.max_y})
      if (!contains(outer, frame.to_field({x, y}))) return frame.to_field({x, y});
  return frame.to_field(box.centre());
}

bool is_met(const Ring& ring, const Box& box) {
  for (std::size_t i = 0; i < ring.size(); ++i)
    if (intersects(bounds(ring[i], ring[i + 1 < ring.size() ? i + 1 : 0]), box)) return true;
  return false;
}

Clipped sum_of(const Region& parts) { return {area(parts), point_on_largest(parts)}; }

}  // namespace

SwathCore::SwathCore(const Path& path, double width_m) {
  if (path.size() == 1 && path.front().straight()) {
    const PieceFrame frame(path.front().from, path.front().to);
    const Box box = Box{-0.5 * width_m, 0, 0.5 * width_m, frame.length()}.grown(-kLengthTolerance_m);
    if (box.width() > 0 && box.height() > 0) rectangle_ = Rectangle{frame, box};
    return;
  }
  const double core_m = width_m - 2 * kLengthTolerance_m;
  if (core_m > 0) bands_ = bands_along(shortened(path, kLengthTolerance_m), core_m);
  for (const Polygon& band : bands_) boxes_.push_back(bounds(band));
}

Clipped SwathCore::part_on(const BoundedRegion& land) const {
  if (rectangle_) return clipped(land, rectangle_->frame, rectangle_->box);
  Region parts;
  for (const BoundedPolygon& polygon : land)
    for (std::size_t i = 0; i < bands_.size(); ++i)
      if (intersects(boxes_[i], polygon.box))
        for (Polygon& part : intersection({bands_[i]}, {*polygon.shape})) parts.push_back(std::move(part));
  return sum_of(parts);
}

Clipped SwathCore::Rectangle::part_beyond(const Ring& outer) const {
  const double outside_m2 = area_m2() - clipped(Polygon{outer, {}}, frame, box).area_m2;
  // A difference of large areas: rounding grows with them.
  if (outside_m2 <= kAreaRounding * area_m2()) return {};
  return {outside_m2, point_outside(outer, frame, box)};
}

Clipped SwathCore::part_beyond(const Ring& outer) const {
  if (rectangle_) return rectangle_->part_beyond(outer);
  Region parts;
  for (std::size_t i = 0; i < bands_.size(); ++i)
    if (!contains(outer, bands_[i].outer.front()) || is_met(outer, boxes_[i]))
      for (Polygon& part : difference({bands_[i]}, {{outer, {}}})) parts.push_back(std::move(part));
  return sum_of(parts);
}

double SwathCore::slivers_m2() const { return rectangle_ ? kThinnestLand_m * rectangle_->box.height() : 0; }

}  // namespace tramline::check
