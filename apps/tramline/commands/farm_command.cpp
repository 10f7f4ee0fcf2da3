// The command `farm`: what the work on all fields of a file costs.

#include "commands/command.h"
#include "options/common_options.h"
#include "options/compare_options.h"
#include "options/field_options.h"
#include "options/plan_options.h"
#include "output/search_end.h"
#include "request/machines_asked.h"
#include "tables/job_cost_run.h"
#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

constexpr const char* kFarmAbout =
    "Say what the work on all fields of a file takes: hours, litres and euros, one table for all fields.";

constexpr const char* kFarmExample =
    "Examples:\n"
    "  tramline farm parcels.gpkg --layer parcels --machine sprayer.toml --pdf quote.pdf\n"
    "  tramline farm parcels.gpkg --where \"crop='wheat'\" --width 24 --operation spraying --table "
    "quote.csv\n"
    "  tramline farm parcels.gpkg --machines drill-3m.toml,drill-6m.toml --json\n"
    "Every field is planned as by 'tramline plan', from the first track to the last headland pass.\n"
    "Without --table and --pdf nothing is written.";

class FarmCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "farm", kFarmAbout);
    command.footer(kFarmExample);
    add_field_options(command, field_options_);
    add_plan_options(command, plan_options_, PlanDefaults::kWhole);
    add_machines_options(command, machines_);
    command.begin_group("Output");
    command.add_option("--table", run_.csv_file, "Write the table to this .csv.")
        .takes("FILE")
        .shows_default("not written");
    command.add_option("--pdf", run_.pdf_file, "Write the table to this .pdf, on pages of A4.")
        .takes("FILE")
        .shows_default("not written");
    add_report_options(command, run_.json, "Print one JSON object per field and machine, and one of sums.",
                       run_.quiet);
    command.begin_group("Run");
    add_seconds_option(command, run_.seconds);
    add_threads_option(command, run_.threads);
    command_.emplace(command);
    return command;
  }

  int run() override {
    field_options_.all = true;
    take_conventions(*command_, plan_options_);
    take_whole_plan(*command_, plan_options_);
    run_.settings = settings_of(plan_options_);
    run_.objective = objective_of(plan_options_);
    if (run_.settings.turns != TurnPlanning::kRoute)
      throw bad_input("farm sums up whole routes: give --route, or leave out what asks for tracks alone");
    run_.machines = machines_asked(machine_of(plan_options_), machines_.widths, machines_.files);
    return run_job_costs(run_, field_options_, plan_options_);
  }

 private:
  FieldOptions field_options_;
  PlanOptions plan_options_;
  MachinesOptions machines_;
  std::optional<CommandOptions> command_;
  JobCostRun run_;
};

}  // namespace

std::unique_ptr<Command> make_farm_command() { return std::make_unique<FarmCommand>(); }

}  // namespace tramline::app
