#include "request/turns_request.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"
#include "tramline/model/limits.h"
#include "tramline/planner/validate_request.h"

namespace tramline::app {
namespace {

/// Nearer to the tracks than this a border is one that they run along.
constexpr double kLeastBorder_deg = 5;

}  // namespace

TurnTableSettings turns_asked(const Machine& machine, std::optional<double> spacing_m, double border_deg) {
  validate_request(machine, {}, {});
  if (machine.radius_m == 0)
    throw bad_input(
        "a machine with the turning radius 0 turns on the spot and needs no more than half its width: give "
        "the "
        "radius of its curves, such as 0.5");
  TurnTableSettings out;
  if (!(border_deg >= kLeastBorder_deg && border_deg <= 180 - kLeastBorder_deg))
    throw bad_input(
        fmt::format("the angle between track and border must lie between {:g} and {:g} degrees, not at {:g}",
                    kLeastBorder_deg, 180 - kLeastBorder_deg, border_deg));
  out.border = Angle::degrees(border_deg);
  if (!spacing_m) return out;
  if (!(*spacing_m > 0 && *spacing_m <= kFarthest_m))
    throw bad_input(fmt::format("the spacing of the tracks must be more than 0 and at most {} m, not {:g}",
                                kFarthest_m, *spacing_m));
  out.spacings_m = {*spacing_m};
  return out;
}

}  // namespace tramline::app
