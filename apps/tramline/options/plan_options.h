#pragma once
// The options of `plan` that shape a plan.

#include "options/command_options.h"
#include "request/given_land.h"
#include "request/plan_request.h"

namespace tramline::app {

/// What is planned where options are not given: tracks alone, or a plan to be driven (plan_defaults.h), and
/// tracks alone only where the options ask for them.
enum class PlanDefaults { kTracks, kWhole };
void add_plan_options(CommandOptions& command, PlanOptions& options,
                      PlanDefaults defaults = PlanDefaults::kTracks);
/// Makes what is not given part of a plan to be driven, unless tracks alone are asked for. To be called after
/// take_conventions().
void take_whole_plan(const CommandOptions& command, PlanOptions& options);
/// What --like stands for, but for options that were given. To be called after parsing. Throws kBadInput.
void take_conventions(const CommandOptions& command, PlanOptions& options);
/// --subfields, --only and --done.
void add_land_options(CommandOptions& command, LandOptions& options);
/// Of those only --width, --radius, --machine and --min-length, whose default is said in words.
void add_machine_options(CommandOptions& command, PlanOptions& options, const char* least_length);
/// What the machine needs to turn: --reverse, --working-speed … --vehicle-width.
void add_turning_options(CommandOptions& command, TurningOptions& options);
/// What the work of the machine costs.
void add_rate_options(CommandOptions& command, RateOptions& options);
/// Only --weights, --prices and --minimise.
void add_objective_options(CommandOptions& command, PlanOptions& options,
                           PlanDefaults defaults = PlanDefaults::kTracks);

}  // namespace tramline::app
