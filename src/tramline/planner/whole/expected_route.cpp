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

}  // namespace

double least_beyond_floor(const ComparedPlans& plans, const ComparedPlan& plan) {
  constexpr double kNone = std::numeric_limits<double>::infinity();
  double of_any = kNone, of_alike = kNone;
  for (const ComparedPlan& other : plans) {
    if (!other.beyond_floor) continue;
    of_any = std::min(of_any, *other.beyond_floor);
    if (has_few_pieces(plan) && are_alike(plan, other))
      of_alike = std::min(of_alike, *other.beyond_floor * size_of(plan) / size_of(other));
  }
  const auto part_of = [](double part, double least) { return least == kNone ? 0.0 : part * least; };
  const double share = plan.plan().pieces.size() <= kFewest ? kOfFewest : 1;
  return share * std::max(part_of(kOfAny, of_any), part_of(kOfAlike, of_alike));
}

}  // namespace tramline
