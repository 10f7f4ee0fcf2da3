#include "options/compare_options.h"

#include "options/field_options.h"
#include "options/plan_options.h"
#include "request/machines_asked.h"
#include "tramline/geometry/error.h"
#include "tramline/planner/validate_request.h"

namespace tramline::app {

void add_machines_options(CommandOptions& command, MachinesOptions& o) {
  command.begin_group("Several machines");
  Option widths = command.add_option("--widths", o.widths,
                                     "Compare the whole cost at these working widths, in metres, separated "
                                     "by commas.");
  Option machines = command.add_option("--machines", o.files,
                                       "Compare the whole cost of these machine files, separated by commas.");
  widths.takes("NUMBERS").shows_default("one machine");
  machines.takes("FILES").shows_default("one machine").excludes(widths);
}

void add_compare_options(CommandOptions& command, CompareOptions& o) {
  add_field_options(command, o.field);
  add_plan_options(command, o.plan);
  command.begin_group("Objective");
  command
      .add_option(
          "--for", o.prices,
          "Also name the plan that costs least at these prices: overlap,uncovered,turn[,stop[,subfield]]. "
          "May be given several times; prices left out are those of --prices.")
      .takes("NUMBERS")
      .one_value_each_time()
      .shows_default("none");
  add_machines_options(command, o.machines);
}

AskedComparison asked_comparison(const CommandOptions& command, CompareOptions& o) {
  take_conventions(command, o.plan);
  AskedComparison out{AskedPlans(o.plan), {}};
  const PlanSettings settings = out.plans.settings_on({});
  if (settings.tracks == TrackConstruction::kPaper || settings.shape != TrackShape::kStraight ||
      !o.plan.ab.empty() || !o.plan.guide_file.empty() || !o.plan.ab_anchor.empty())
    throw bad_input(
        "compare chooses directions itself; leave out --curved, --ab, --ab-anchor, --guide and --tracks");
  for (const std::string& text : o.prices) {
    out.prices.push_back(prices_typed(text, "--for", out.plans.objective()));
    validate_request(out.plans.machine(), out.prices.back(), settings);
  }
  return out;
}

AskedMachines asked_machines(const CommandOptions& command, CompareOptions& o) {
  take_whole_plan(command, o.plan);
  AskedMachines out{machines_asked(machine_of(o.plan), o.machines.widths, o.machines.files),
                    objective_of(o.plan), settings_of(o.plan)};
  if (out.settings.turns != TurnPlanning::kRoute)
    throw bad_input(
        "several machines are compared by their whole routes: leave out what asks for tracks alone, such "
        "as --prices, or --widths and --machines");
  return out;
}

}  // namespace tramline::app
