#include "tramline/planner/whole/expected_route.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline {
namespace {

/// Parts of the least of all, and of the least of those in about the same directions. A few degrees away
/// tracks may meet the edge at right angles: there they cost a tenth of what oblique ones do that have no
/// room to turn.
constexpr double kOfAny = 0.4, kOfAlike = 0.6;
constexpr double kAlike_deg = 2;

/// The best order of so few tracks is found at once, and a loop more or less is a good part of what they
/// cost: where there are no more, this share of what is expected otherwise.
constexpr std::size_t kFewest = 11;
constexpr double kOfFewest = 0.4;

/// Of more tracks the ways between them differ too much for those of one plan to tell of another.
constexpr std::size_t kFewPieces = 32;

/// Of grids in other directions behind the same passes, as soon as so many have routes, hardly any costs less
/// beyond its floor than this part of the least of them; not of the fewest tracks, of which some cost half as
/// much.
constexpr double kOfMoved = 0.85;
constexpr int kFewestMoved = 2;

/// Passes, and the ways to them and from gates, cost beyond the floor as much as so many tracks.
constexpr double kBesideTracks = 2;

bool has_few_pieces(const ComparedPlan& plan) { return plan.plan().pieces.size() <= kFewPieces; }

/// What the cost beyond the floor grows with: both ends of every track have to be turned at.
double size_of(const ComparedPlan& plan) {
  return static_cast<double>(plan.plan().pieces.size()) + kBesideTracks;
}

/// Whether each subfield of one has one in about the same direction in the other.
bool in_directions_of(const Plan& plan, const Plan& other) {
  return std::ranges::all_of(plan.subfields, [&](const Subfield& one) {
    return std::ranges::any_of(other.subfields, [&](const Subfield& known) {
      return one.reference.empty() == known.reference.empty() &&
             angle_between(one.direction, known.direction).degrees() < kAlike_deg;
    });
  });
}

bool are_alike(const ComparedPlan& a, const ComparedPlan& b) {
  return a.passes().edges == b.passes().edges && in_directions_of(a.plan(), b.plan()) &&
         in_directions_of(b.plan(), a.plan());
}

/// Whether both are grids that have been moved behind the same passes.
bool are_moved(const ComparedPlan& a, const ComparedPlan& b) {
  return a.laid.kind == Alternative::kMovedLines && b.laid.kind == Alternative::kMovedLines &&
         a.passes() == b.passes();
}

}  // namespace

double least_beyond_floor(const ComparedPlans& plans, const ComparedPlan& plan) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double of_any = kNone, of_alike = kNone, of_moved = kNone;
  const bool has_fewest = plan.plan().pieces.size() <= kFewest;
  int moved = 0;
  for (const ComparedPlan& other : plans) {
    if (!other.beyond_floor) continue;
    of_any = std::min(of_any, *other.beyond_floor);
    if (!has_few_pieces(plan)) continue;
    const double as_large = *other.beyond_floor * size_of(plan) / size_of(other);
    if (are_alike(plan, other)) of_alike = std::min(of_alike, as_large);
    if (has_fewest || !are_moved(plan, other)) continue;
    of_moved = std::min(of_moved, as_large);
    ++moved;
  }
  const auto part_of = [](double part, double least) { return least == kNone ? 0.0 : part * least; };
  const double share = has_fewest ? kOfFewest : 1;
  const double of_others = share * std::max(part_of(kOfAny, of_any), part_of(kOfAlike, of_alike));
  return moved < kFewestMoved ? of_others : std::max(of_others, part_of(kOfMoved, of_moved));
}

}  // namespace tramline
