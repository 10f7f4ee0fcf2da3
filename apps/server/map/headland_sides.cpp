#include "server/map/headland_sides.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

#include "tramline/geometry/angle.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

/// The boundary has a corner where it turns by more.
constexpr double kCorner_deg = 25;
/// Shorter sides are not worth a row.
constexpr double kShortest_m = 5;

/// Edges of a ring, one after the other.
struct Side {
  std::size_t first = 0, count = 0;
  double length_m = 0;
  int passes = 0;
};

/// By edge of the outer ring.
std::vector<int> passes_by_edge(const Plan& plan) {
  if (!plan.headland.edge_passes.empty()) return plan.headland.edge_passes;
  return std::vector<int>(plan.field.outer.size(), plan.settings.headlands);
}

class Boundary {
 public:
  explicit Boundary(const Plan& plan) : ring_(plan.field.outer), passes_(passes_by_edge(plan)) {}

  std::vector<Side> sides() const {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < ring_.size(); ++i)
      if (begins_side(i)) begins.push_back(i);
    if (begins.empty()) begins.push_back(0);
    std::vector<Side> out;
    for (std::size_t k = 0; k < begins.size(); ++k) {
      const std::size_t next = k + 1 < begins.size() ? begins[k + 1] : begins.front() + ring_.size();
      out.push_back(side(begins[k], next - begins[k]));
    }
    return out;
  }

  Point vertex(std::size_t i) const { return ring_[i % ring_.size()]; }

 private:
  bool begins_side(std::size_t edge) const {
    const std::size_t before = (edge + ring_.size() - 1) % ring_.size();
    if (passes_[before] != passes_[edge]) return true;
    const Point in = vertex(before + 1) - vertex(before), out = vertex(edge + 1) - vertex(edge);
    return dot(in, out) < std::cos(Angle::degrees(kCorner_deg).radians()) * length(in) * length(out);
  }

  Side side(std::size_t first, std::size_t count) const {
    Side out{first, count, 0, passes_[first]};
    for (std::size_t i = first; i < first + count; ++i) out.length_m += distance(vertex(i), vertex(i + 1));
    return out;
  }

  const Ring& ring_;
  std::vector<int> passes_;
};

}  // namespace

ordered_json headland_sides(const Plan& plan) {
  const Boundary boundary(plan);
  std::vector<Side> sides = boundary.sides();
  ordered_json out = ordered_json::array();
  if (std::ranges::none_of(sides, [](const Side& side) { return side.passes > 0; })) return out;
  std::ranges::stable_sort(sides, std::greater<>(), &Side::length_m);
  for (const Side& side : sides) {
    if (side.length_m < kShortest_m) continue;
    const Point from = boundary.vertex(side.first), to = boundary.vertex(side.first + side.count);
    const bool closed = side.count == plan.field.outer.size();
    out.push_back(
        {{"length_m", side.length_m},
         {"bearing_deg", closed ? ordered_json() : ordered_json(Heading::from_to(from, to).degrees())},
         {"passes", side.passes},
         {"depth_m", side.passes * plan.machine.width_m}});
  }
  return out;
}

}  // namespace tramline::server
