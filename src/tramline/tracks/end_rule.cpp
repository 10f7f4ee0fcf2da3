#include "tramline/tracks/end_rule.h"

#include <algorithm>

#include "tramline/tracks/tolerances.h"

namespace tramline {

EndCriterion end_criterion(EndRule rule, const Objective& objective, double width_m) {
  const double least = kWidthTolerance, most = width_m - kWidthTolerance;
  switch (rule) {
    case EndRule::kCentre:
      return {true, 0};
    case EndRule::kCover:
      return {false, least};
    case EndRule::kInside:
      return {false, most};
    case EndRule::kCheapest:
      return {false, std::clamp(cheapest_share(objective) * width_m, least, most)};
  }
  return {};
}

Intervals allowed_by(const EndCriterion& criterion, const TrackProfile& subfield) {
  return criterion.by_centre_line ? subfield.centre_inside()
                                  : subfield.where_at_least(criterion.least_width_m);
}

Intervals allowed_by(const EndCriterion& criterion, const StripProfile& subfield) {
  return criterion.by_centre_line ? subfield.centre_line : where_at_least(subfield, criterion.least_width_m);
}

}  // namespace tramline
