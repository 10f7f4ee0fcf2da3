#include "tramline/planner/whole/compared_plans.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "tramline/planner/headland_choice/foreseen_passes.h"
#include "tramline/planner/whole/plan_faults.h"
#include "tramline/planner/whole/route_floor.h"

namespace tramline {
namespace {

/// So many layouts are laid anew behind other passes.
constexpr std::size_t kLaidAnew = 3;
/// So many routes behind the same passes lack room before it is held to be the land's fault.
constexpr std::ptrdiff_t kEnoughWithoutRoom = 3;
/// Tracks are moved behind so many depths of headland, where the plan costs no more than this share above the
/// best one.
constexpr std::size_t kDepths = 2;
constexpr double kAsGood = 0.01;
/// Directions all round are looked at behind so many depths, where a plan costs no more than this share above
/// the best one.
constexpr std::size_t kDepthsAllRound = 3;
constexpr double kHardlyMore = 0.25;
/// Orders of so many plans are looked for longer that cost no more than this share above the best one.
constexpr std::size_t kOrderedLonger = 3;
constexpr double kSlightlyMore = 0.05;

/// The passes all round; -1 for others.
int depth_of(const ComparedPlan& plan) { return all_round(plan.passes()) ? deepest(plan.passes()) : -1; }

/// Those that cost no more than this share above the least price, the cheapest first.
std::vector<std::size_t> cheapest_within(const ComparedPlans& plans, double least_price, double share) {
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < plans.size(); ++i)
    if (plans[i].price && !plans[i].only_told_of && *plans[i].price <= (1 + share) * least_price)
      out.push_back(i);
  std::stable_sort(out.begin(), out.end(),
                   [&](std::size_t a, std::size_t b) { return *plans[a].price < *plans[b].price; });
  return out;
}

/// The first few that are like none before.
template <class Like>
std::vector<std::size_t> first_distinct(const std::vector<std::size_t>& from, std::size_t most,
                                        const Like& like) {
  std::vector<std::size_t> out;
  for (const std::size_t i : from) {
    const bool known = std::any_of(out.begin(), out.end(), [&](std::size_t other) { return like(i, other); });
    if (!known && out.size() < most) out.push_back(i);
  }
  return out;
}

/// Routes of tracks that lie so near to one another, m, and whose floors differ by so small a share cost
/// about the same: searches from several sides often end beside one another.
constexpr double kSameTracks_m = 0.05, kSameFloor = 1e-4;

bool same_ends(const TrackPiece& a, const TrackPiece& b) {
  const auto near = [](Point p, Point q) { return distance(p, q) <= kSameTracks_m; };
  return (near(a.start, b.start) && near(a.end, b.end)) || (near(a.start, b.end) && near(a.end, b.start));
}

bool same_tracks(const std::vector<TrackPiece>& a, const std::vector<TrackPiece>& b) {
  return a.size() == b.size() && std::ranges::all_of(a, [&](const TrackPiece& one) {
           return std::ranges::any_of(b, [&](const TrackPiece& other) { return same_ends(one, other); });
         });
}

bool same_floor(double a, double b) { return std::abs(a - b) <= kSameFloor * std::max(a, b); }

}  // namespace

ComparedPlan compared_plan(LaidOut laid) {
  const double floor = route_floor(laid.trial.draft.plan, *laid.trial.prepared.turning_land);
  return {std::move(laid), floor};
}

bool all_round(const PassesByBoundary& passes) {
  return std::adjacent_find(passes.edges.begin(), passes.edges.end(), std::not_equal_to<>()) ==
         passes.edges.end();
}

double room_lacked_by_others(const ComparedPlans& plans, const ComparedPlan& plan) {
  const int depth = depth_of(plan);
  std::ptrdiff_t lacking = 0;
  double least = std::numeric_limits<double>::infinity();
  for (const ComparedPlan& other : plans) {
    if (!other.price || other.only_told_of || depth_of(other) != depth) continue;
    if (!leaves_land(other.laid.trial.draft)) continue;
    ++lacking;
    least = std::min(least, whole_cost(other.plan()).without_room);
  }
  return lacking >= kEnoughWithoutRoom ? least : 0;
}

bool has_such(const ComparedPlans& plans, const Plan& like, const PassesByBoundary& passes) {
  return std::any_of(plans.begin(), plans.end(), [&](const ComparedPlan& one) {
    return one.passes() == passes && same_directions(one.plan(), like);
  });
}

bool has_such_as_cheap(const ComparedPlans& plans, const ComparedPlan& plan) {
  return std::ranges::any_of(plans, [&](const ComparedPlan& one) {
    return (one.floor <= plan.floor || same_floor(one.floor, plan.floor)) && one.passes() == plan.passes() &&
           same_directions(one.plan(), plan.plan());
  });
}

std::optional<std::size_t> same_tracks_priced(const ComparedPlans& plans, const ComparedPlan& plan) {
  const auto same = std::find_if(plans.begin(), plans.end(), [&](const ComparedPlan& one) {
    // Floors have the paths of pieces and their overlap in them: with equal ends these are equal too.
    return one.price && same_floor(one.floor, plan.floor) &&
           one.plan().headland.passes == plan.plan().headland.passes &&
           same_tracks(one.plan().pieces, plan.plan().pieces);
  });
  if (same == plans.end()) return std::nullopt;
  return static_cast<std::size_t>(same - plans.begin());
}

std::vector<std::size_t> near_the_best(const ComparedPlans& plans, double least_price) {
  std::vector<std::size_t> out = first_distinct(
      cheapest_within(plans, least_price, kComesNear), kLaidAnew,
      [&](std::size_t a, std::size_t b) { return same_directions(plans[a].plan(), plans[b].plan()); });
  std::reverse(out.begin(), out.end());
  return out;
}

std::vector<std::size_t> about_as_good(const ComparedPlans& plans, double least_price) {
  return first_distinct(cheapest_within(plans, least_price, kAsGood), kDepths,
                        [&](std::size_t a, std::size_t b) { return plans[a].passes() == plans[b].passes(); });
}

std::vector<std::size_t> worth_ordering_longer(const ComparedPlans& plans, double least_price) {
  std::vector<std::size_t> out;
  for (const std::size_t i : cheapest_within(plans, least_price, kSlightlyMore))
    if (plans[i].laid.kind != Alternative::kAdjacent && out.size() < kOrderedLonger) out.push_back(i);
  return out;
}

std::vector<std::size_t> best_of_each_depth(const ComparedPlans& plans, double least_price) {
  return first_distinct(cheapest_within(plans, least_price, kHardlyMore), kDepthsAllRound,
                        [&](std::size_t a, std::size_t b) { return plans[a].passes() == plans[b].passes(); });
}

double expected_without(const std::vector<PieceRun>& runs, const ComparedPlan& plan) {
  assert(plan.price);
  double out = *plan.price;
  for (const PieceRun& run : runs) out -= run.saved;
  return out;
}

std::vector<Hopeful> hopeful_without_tracks(const ComparedPlans& plans, double least_price) {
  std::vector<Hopeful> out;
  for (std::size_t i = 0; i < plans.size(); ++i) {
    if (!plans[i].price || plans[i].only_told_of) continue;
    const std::vector<PieceRun> runs = not_worth_their_ways(plans[i].laid.trial);
    const double expected = expected_without(runs, plans[i]);
    if (!runs.empty() && expected < least_price) out.push_back({expected, i});
  }
  std::ranges::stable_sort(out, {}, &Hopeful::expected);
  return out;
}

}  // namespace tramline
