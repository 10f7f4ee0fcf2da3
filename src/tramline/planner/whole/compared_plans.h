#pragma once
// Plans that are compared by the cost of their whole routes, and which of them others are made from.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/planner/whole/dropped_tracks.h"
#include "tramline/planner/whole/route_layouts.h"

namespace tramline {

/// A plan to be compared. It has its route where it has a price.
struct ComparedPlan {
  LaidOut laid;
  double floor = 0;               ///< route_floor(), EUR
  std::optional<double> price{};  ///< the cost of its route, EUR
  /// What its route costs beyond the floor, but for legs without room, EUR; of those only told of nothing.
  std::optional<double> beyond_floor{};
  double lacks_room_like_others = 0;  ///< what its legs without room are expected to cost, EUR
  bool only_told_of = false;          ///< it was not expected to win: nothing is made from it

  const Plan& plan() const { return laid.trial.draft.plan; }
  const PassesByBoundary& passes() const { return laid.trial.passes; }
};
using ComparedPlans = std::vector<ComparedPlan>;

/// A plan with its floor, without a route.
ComparedPlan compared_plan(LaidOut laid);

/// Plans come near the best one where they cost no more than this share above it.
inline constexpr double kComesNear = 0.1;

/// Whether as many passes lie along all edges.
bool all_round(const PassesByBoundary& passes);

/// Where several routes behind as many passes all round leave the land the shape of the land lacks room: what
/// their legs without room cost at the least, EUR; else 0. O(n), as all that follow: none looks at anything
/// but directions, passes and prices.
double room_lacked_by_others(const ComparedPlans& plans, const ComparedPlan& plan);

/// Whether one of them has these passes and directions.
bool has_such(const ComparedPlans& plans, const Plan& like, const PassesByBoundary& passes);
/// Whether one of them has its passes and directions, and no higher a floor: other subfields in the same
/// directions may cost less.
bool has_such_as_cheap(const ComparedPlans& plans, const ComparedPlan& plan);

/// The one that has the same tracks behind the same passes as a plan to be compared, to a few centimetres,
/// and its price: their routes would be about the same. O(plans, and pieces² where floors are about equal).
std::optional<std::size_t> same_tracks_priced(const ComparedPlans& plans, const ComparedPlan& plan);

/// The few of them in different directions that come near the least price, EUR, the cheapest last: worth
/// laying anew behind other passes. Indices.
std::vector<std::size_t> near_the_best(const ComparedPlans& plans, double least_price);

/// The few of them behind different passes that cost about the least price, the cheapest first: worth moving
/// their tracks a little. Indices.
std::vector<std::size_t> about_as_good(const ComparedPlans& plans, double least_price);

/// The cheapest behind each of the few depths of headland that cost hardly more than the least price.
/// Indices.
std::vector<std::size_t> best_of_each_depth(const ComparedPlans& plans, double least_price);

/// The cheapest few that cost slightly more than the least price at the most, in the best order that was
/// found for them so far, the cheapest first. Indices.
std::vector<std::size_t> worth_ordering_longer(const ComparedPlans& plans, double least_price);

/// About what a plan would cost without these runs of its tracks, EUR. Precondition: it has its route.
double expected_without(const std::vector<PieceRun>& runs, const ComparedPlan& plan);

/// A plan, and about what it would cost without the tracks that are not worth their ways.
struct Hopeful {
  double expected = 0;   ///< EUR
  std::size_t plan = 0;  ///< index
};

/// Those that may cost less than the least price without such tracks, the most hopeful first.
std::vector<Hopeful> hopeful_without_tracks(const ComparedPlans& plans, double least_price);

}  // namespace tramline
