#include <fmt/format.h>

#include "tramline/check/rules/rules.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::check {
namespace {

void check_overlaps(const Case& c, Violations& out) {
  const auto& subfields = c.plan.subfields;
  std::vector<Box> boxes;
  for (const Subfield& subfield : subfields) boxes.push_back(bounds(subfield.shape));
  for (std::size_t i = 0; i < subfields.size(); ++i)
    for (std::size_t j = i + 1; j < subfields.size(); ++j) {
      if (!intersects(boxes[i], boxes[j])) continue;
      const Region common = intersection({subfields[i].shape}, {subfields[j].shape});
      if (const double amount = area(common); amount > c.area_tolerance_m2)
        out.push_back({Rule::kSubfields,
                       fmt::format("subfields {} and {} overlap by {:.3f} m²", i + 1, j + 1, amount),
                       point_on_largest(common), amount});
    }
}

}  // namespace

void check_subfields(const Case& c, Violations& out) {
  check_overlaps(c, out);
  Region land = difference(c.plan.body, c.plan.given_up);
  for (const BoundedPolygon& passable : c.passables) land.push_back(*passable.shape);
  Region shapes;
  for (const Subfield& subfield : c.plan.subfields) shapes.push_back(subfield.shape);
  Region off = symmetric_difference(unite(land), unite(shapes));
  // It does not matter whether a subfield includes a passable where that leads through a headland.
  if (!c.near_boundaries.empty() && !c.passables.empty() && !off.empty()) {
    Region passables;
    for (const BoundedPolygon& passable : c.passables) passables.push_back(*passable.shape);
    off = difference(off, intersection(unite(passables), c.near_boundaries));
  }
  // Nor where it leads through land that is not to be worked.
  const bool partly = !c.plan.worked.empty() || c.plan.left_out > 0;
  if (partly && !c.passables.empty() && !off.empty()) {
    Region passables;
    for (const BoundedPolygon& passable : c.passables) passables.push_back(*passable.shape);
    off = difference(off, unite(passables));
  }
  const double tolerance_m2 = c.area_tolerance_m2 + (c.passables.empty() ? 0 : c.round_edges_m2);
  if (const double amount = area(off); amount > tolerance_m2)
    out.push_back(
        {Rule::kSubfields,
         fmt::format("the subfields together differ by {:.3f} m² from the land to be worked", amount),
         point_on_largest(off), amount});
}

}  // namespace tramline::check
