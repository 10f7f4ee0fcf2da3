#include <fmt/format.h>

#include "tramline/check/bands.h"
#include "tramline/check/comparison.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

/// What the passes work, by polygon booleans.
struct HeadlandWork {
  Region land;  ///< union of the swaths
  double worked_m2 = 0;
  double arcs_m = 0;
};

/// On passables the work is interrupted: what lies there is not worked, as often as it is driven over.
HeadlandWork work(const Case& c) {
  HeadlandWork out;
  Region bands;
  for (const HeadlandPass& pass : c.plan.headland.passes) {
    out.worked_m2 += c.plan.machine.width_m * length(pass.path);
    out.arcs_m += arcs_m(pass.path);
    for (Polygon& band : flat_bands_along(pass.path, c.plan.machine.width_m)) {
      out.worked_m2 -= area_common_to({band}, c.passables);
      bands.push_back(std::move(band));
    }
  }
  out.land = unite(bands);
  return out;
}

}  // namespace

void check_headland_tally(const Case& c, Violations& out) {
  const Headland& stored = c.plan.headland;
  const HeadlandWork found = work(c);
  const double ground_m2 = area(stored.ground);
  const double covered_m2 = area(intersection(found.land, stored.ground));
  const double tolerance_m2 = c.area_tolerance_m2 + kChordSagitta * 2 * found.arcs_m;
  Comparison compare("the headland's passes", c.plan.field.outer.front(), out);
  compare.number("worked area of the headland", " m²", stored.worked_m2, found.worked_m2, tolerance_m2);
  compare.number("overlap in the headland", " m²", stored.overlap_m2, found.worked_m2 - covered_m2,
                 tolerance_m2);
  compare.number("uncovered area of the headland", " m²", stored.uncovered_m2, ground_m2 - covered_m2,
                 tolerance_m2);
  compare.number("worked area of the headland, as ground less uncovered plus overlap,", " m²",
                 ground_m2 - stored.uncovered_m2 + stored.overlap_m2, found.worked_m2, tolerance_m2);

  const Region off = symmetric_difference(stored.unworked, difference(stored.ground, found.land));
  const double amount = area(off);
  if (amount > c.area_tolerance_m2 + kRoundEdge_m * 2 * found.arcs_m)
    out.push_back({"tally",
                   fmt::format("what the headland's passes leave is drawn wrong by {:.3f} m²", amount),
                   place_on_largest(off), amount});
}

}  // namespace tramline::check
