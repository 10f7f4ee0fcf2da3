#include "tramline/check/rules/route/worked_ground.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/check/turning/axle_line.h"

namespace tramline::check {
namespace {

/// Where a point is beside a segment: along it, and to which side, m.
struct Beside {
  double along_m, across_m;
};

Beside beside(const PathSegment& segment, Point p) {
  if (segment.straight()) {
    const Point along = (1 / length(segment)) * (segment.to - segment.from);
    return {dot(p - segment.from, along), cross(along, p - segment.from)};
  }
  const Point middle = centre(segment);
  const Point half_way = turned(segment.from - middle, 0.5 * turning(segment));
  const double sense = segment.curvature > 0 ? 1 : -1;
  // Counted from the middle of the arc, so that what lies just before its beginning is not far behind its
  // end.
  const double turned_rad = sense * std::atan2(cross(half_way, p - middle), dot(half_way, p - middle));
  return {0.5 * length(segment) + turned_rad * radius(segment), distance(p, middle) - radius(segment)};
}

}  // namespace

WorkedGround::WorkedGround(const Plan& plan) : half_m_(0.5 * plan.machine.width_m) {
  const double ahead_m = std::abs(ahead_of_work_m(plan.machine));
  for (std::size_t i = 0; i < plan.route.legs.size(); ++i) {
    const std::optional<std::size_t>& piece = plan.route.legs[i].piece;
    if (piece && *piece < plan.pieces.size()) add(centre_line(plan.pieces[*piece]), i, kWorkedMargin_m);
  }
  for (std::size_t i = 0; i < plan.headland.passes.size(); ++i) {
    const HeadlandPass& pass = plan.headland.passes[i];
    const std::vector<std::size_t> legs = legs_of_pass(plan, i);
    if (!legs.empty()) add(pass.path, legs.front(), is_closed(pass) ? 0 : kWorkedMargin_m + ahead_m);
  }
  std::vector<Box> boxes;
  for (const Strip& strip : strips_)
    boxes.push_back(reach_of({strip.segment}, plan.machine.width_m)
                        .grown(kWorkedMargin_m + std::max(strip.unsure_before_m, strip.unsure_behind_m)));
  grid_ = BoxGrid(boxes);
}

void WorkedGround::add(const Path& path, std::size_t leg, double unsure_m) {
  for (std::size_t i = 0; i < path.size(); ++i)
    strips_.push_back({path[i], leg, i == 0 ? unsure_m : 0, i + 1 == path.size() ? unsure_m : 0});
}

WorkedGround::First WorkedGround::first_at(Point p) const {
  First out;
  grid_.each_meeting({p.x, p.y, p.x, p.y}, [&](std::size_t i) {
    const Strip& strip = strips_[i];
    const auto [along_m, across_m] = beside(strip.segment, p);
    const double before_m = along_m, behind_m = length(strip.segment) - along_m;
    const double inside_m = half_m_ - std::abs(across_m);
    if (inside_m >= kWorkedMargin_m && before_m >= strip.unsure_before_m && behind_m >= strip.unsure_behind_m)
      out.surely = std::min(out.surely, strip.leg);
    if (inside_m >= -kWorkedMargin_m && before_m >= -strip.unsure_before_m &&
        behind_m >= -strip.unsure_behind_m)
      out.perhaps = std::min(out.perhaps, strip.leg);
  });
  return out;
}

}  // namespace tramline::check
