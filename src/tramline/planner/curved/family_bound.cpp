#include "tramline/planner/curved/family_bound.h"

#include <algorithm>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

/// A generous allowance for the length that discs rolled round corners may add to a track.
constexpr double kLonger = 1.5;
/// An allowance for what swaths of one family share, by rounding: it is none of what they are made to.
constexpr double kShared = 1e-4;

}  // namespace

FamilyBound::FamilyBound(const SearchTask& task, const Subfield& subfield, const StripRange& range)
    : task_(task), reference_(subfield.reference), range_(range), subfield_m2_(area(subfield.shape)) {}

void FamilyBound::add(const LaidTracks& pieces, double inside_m2) {
  for (const LaidPiece& piece : pieces.pieces) {
    worked_m2_ += piece.inside_m2;
    overlap_m2_ += task_.machine.width_m * piece.length_m - piece.inside_m2;
    stops_ += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
    if (!piece.after_crossing) ++entered_;
  }
  passed_m2_ += inside_m2;
}

bool FamilyBound::exceeds(const CostLimits& limits, int index) const {
  const Objective& price = task_.objective;
  const double not_worked_m2 = std::max(0.0, task_.body_m2 - worked_m2_);
  const double not_passed_m2 = std::max(0.0, subfield_m2_ - (1 - kShared) * passed_m2_);
  const double left_m2 = std::max(0.0, not_worked_m2 - not_passed_m2);
  const double without_stops = price.overlap * overlap_m2_ + price.uncovered * left_m2 +
                               price.turn * (entered_ - 1) + least_rate(index) * (not_worked_m2 - left_m2);
  const auto is_above = [&](double limit, double stop_price) {
    return (without_stops + stop_price * stops_) * (1 - kRounding_share) - kRounding_cost > limit;
  };
  return is_above(limits.cost, price.stop) && is_above(limits.soft, std::min(price.stop, price.turn));
}

/// What land costs at least that has not been passed: it stays uncovered or is worked by tracks that take a
/// turn each.
double FamilyBound::least_rate(int index) const {
  const double width_m = task_.machine.width_m;
  double longest_m = 0;
  const auto look = [&](int k) {
    longest_m = std::max(longest_m, uncut_length(reference_, (k + 0.5) * width_m));
  };
  // A sum of convex functions of the distance is greatest at one end.
  if (index < 0) {
    look(index);
    look(range_.first);
  }
  look(std::max(index, 0));
  look(range_.last);
  const Objective& price = task_.objective;
  return std::min(price.uncovered, price.turn / (width_m * kLonger * longest_m));
}

}  // namespace tramline
