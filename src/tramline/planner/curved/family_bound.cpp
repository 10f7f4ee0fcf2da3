#include "tramline/planner/curved/family_bound.h"

#include <algorithm>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

/// A generous allowance for the length that discs rolled round corners may add to a track.
constexpr double kLonger = 1.5;

}  // namespace

double FamilyBound::after(int index, const LaidTracks& tracks) {
  for (; seen_ < tracks.pieces.size(); ++seen_) {
    const LaidPiece& piece = tracks.pieces[seen_];
    inside_m2_ += piece.inside_m2;
    overlap_m2_ += task_.machine.width_m * piece.length_m - piece.inside_m2;
    stops_ += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
  }
  const Objective& price = task_.objective;
  const double sure =
      price.overlap * overlap_m2_ + price.stop * stops_ + price.turn * (static_cast<double>(seen_) - 1);
  return (sure + least_for_the_rest(index)) * (1 - kRounding_share) - kRounding_cost;
}

/// The land of the body not worked yet either stays uncovered or is worked by tracks that take a turn each.
double FamilyBound::least_for_the_rest(int index) const {
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
  const double rate = std::min(price.uncovered, price.turn / (width_m * kLonger * longest_m));
  return rate * std::max(0.0, task_.body_m2 - inside_m2_);
}

}  // namespace tramline
