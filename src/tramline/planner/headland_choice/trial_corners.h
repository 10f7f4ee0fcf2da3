#pragma once
// The headland of a trial with its corners worked out.

#include <array>
#include <optional>

#include "tramline/planner/headland_choice/headland_trial.h"

namespace tramline {

/// How closed passes whose corners are worked out are driven. kAsBefore: from where their route enters them,
/// so that it may go on as before but for the corners. Else from behind a corner, which saves cutting them
/// there, one way round or the other.
enum class RoundPasses { kAsBefore, kAsLaid, kOtherWay };

/// How corners are worked out.
struct WorkOut {
  double times_the_cost = 1;  ///< what land in corners has to be worth, in what it costs to work it
  RoundPasses round = RoundPasses::kAsLaid;
};

/// What is tried. Where all corners together do not pay, those that are clearly worth it may.
inline constexpr std::array kWaysToWorkOut{
    WorkOut{1, RoundPasses::kAsLaid}, WorkOut{1, RoundPasses::kOtherWay}, WorkOut{1, RoundPasses::kAsBefore},
    WorkOut{3, RoundPasses::kAsLaid}, WorkOut{3, RoundPasses::kAsBefore}};

/// Whether a plan costs so much less with its corners worked out, EUR, that one would back out of them: by a
/// hundredth of the plan.
bool corners_pay(double euros_without, double euros_with);

/// Whether what is expected to cost so much may cost less than the least, EUR: routes between parts of passes
/// may turn out a little quicker than those round whole ones.
bool may_cost_less(double expected, double least);

/// A trial, without its route, and how much less than with it round its corners it is expected to cost, EUR.
struct ExpectedTrial {
  HeadlandTrial trial;
  double saved = 0;
};

/// The same tracks, with passes driven on into the corners where that is worth it by the rates of the machine
/// (with_worked_corners()); the draft is still the old one. nullopt where no corner is worth it, or passes
/// are not drivable. Precondition: the trial has a route.
std::optional<ExpectedTrial> with_worked_corners(const HeadlandTrial& trial, const WorkOut& how);

/// The trial, or with its corners worked out where its route then costs less. Precondition: it has a route.
HeadlandTrial or_with_worked_corners(HeadlandTrial trial);

}  // namespace tramline
