// tramline repair: what a drive has missed in, passes over it out.

#include <fmt/format.h>

#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/many_fields.h"
#include "options/common_options.h"
#include "options/field_options.h"
#include "options/plan_options.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/search_end.h"
#include "report/repair_report.h"
#include "request/gap_fields.h"
#include "request/output_names.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/model/limits.h"
#include "tramline/planner/validate_request.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kRepairAbout =
    "Plan passes over the land that a drive has missed, from the coverage file of 'tramline evaluate'.";
constexpr const char* kRepairExample =
    "Examples:\n"
    "  tramline evaluate spraying.csv --field field.geojson --width 24 -o coverage.gpkg\n"
    "  tramline repair coverage.gpkg --width 24 --radius 8 -o repair.gpkg --picture repair.png\n"
    "  tramline evaluate spraying.csv --field field.geojson --width 24 --with repair.gpkg\n"
    "Passes keep to the directions driven, stay in the field and out of obstacles, and may run on over "
    "worked\n"
    "land; between two gaps on a line the work is off. A pass that costs more than it wins back is left "
    "out.\n"
    "Without -o and --picture nothing is written.";

class RepairCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "repair", kRepairAbout);
    command.footer(kRepairExample);
    command.add_option("COVERAGE", coverage_file_, "A coverage file, as written by 'tramline evaluate -o'.")
        .required();
    add_machine_options(command, options_, "0");
    add_objective_options(command, options_);
    command.begin_group("Swaths");
    command
        .add_option("--min-area", min_area_m2_,
                    "Missed land smaller than this, in m², is listed but not worked.")
        .takes("M2")
        .shows_default();
    command
        .add_option("--end-rule", end_rule_,
                    "Where swaths end on worked land: 'cheapest', 'cover', 'centre' or 'inside'.")
        .takes("WORD")
        .shows_default();
    command.begin_group("Output");
    add_output_option(command, output_, "Write the plan to this GeoPackage (.gpkg).");
    add_picture_option(command, picture_, "Draw the plan to this .png, .svg or .pdf.");
    add_report_options(command, json_, "Print one JSON object per field.", quiet_);
    command.begin_group("Run");
    add_seconds_option(command, seconds_);
    add_threads_option(command, threads_);
    return command;
  }

  int run() override {
    const RepairTerms terms = terms_typed();
    require_writable(output_, "--output", {".gpkg"}, {coverage_file_, options_.machine_file});
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"},
                     {coverage_file_, options_.machine_file});
    const Coverage coverage = io::read_coverage(coverage_file_);
    const std::vector<GapField> fields = gap_fields(coverage, coverage_file_);
    const Naming naming = fields.size() > 1 ? Naming::kWithId : Naming::kAsGiven;
    Outputs outputs{{output_, naming}, {picture_, naming}};
    const ManyFieldsReport report{json_, quiet_, "repaired"};
    if (fields.size() == 1) {
      const InterruptEndsSearches interruptible;
      return show_single(fields.front().field, repair(fields.front(), terms, outputs), report);
    }
    FieldInput input;
    for (const GapField& field : fields) input.fields.push_back(field.field);
    return work_on_many_fields(input, report, [&](const Field& field) {
      return repair(fields[static_cast<std::size_t>(field.source.part)], terms, outputs);
    });
  }

 private:
  struct Outputs {
    OutputNames plans, pictures;
  };

  RepairTerms terms_typed() const {
    RepairTerms out{machine_of(options_), objective_of(options_), EndRule::kCheapest};
    if (!options_.min_length_m && out.machine.min_length_m < 0) out.machine.min_length_m = 0;
    const std::optional<EndRule> rule = end_rule_named(end_rule_);
    if (!rule)
      throw bad_input(fmt::format("--end-rule takes cheapest, cover, centre or inside, not '{}'", end_rule_));
    out.end_rule = *rule;
    PlanSettings settings;
    settings.end_rule = out.end_rule;
    validate_request(out.machine, out.objective, settings);
    if (!(min_area_m2_ > 0 && min_area_m2_ <= kFarthest_m))
      throw bad_input(
          fmt::format("--min-area must be more than 0 and at most {} m², not {}", kFarthest_m, min_area_m2_));
    return out;
  }

  FieldResult repair(const GapField& part, const RepairTerms& terms, Outputs& outputs) const {
    const auto start = std::chrono::steady_clock::now();
    const RepairPlan done = repaired(part, terms);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    if (!output_.empty()) io::write_plan(done.plan, outputs.plans.next(part.field.id));
    if (!picture_.empty()) render::draw_plan(done.plan, outputs.pictures.next(part.field.id));
    return {repair_json(done, min_area_m2_, elapsed.count()),
            repair_table(done, min_area_m2_, elapsed.count()),
            {}};
  }

  RepairPlan repaired(const GapField& part, const RepairTerms& terms) const {
    ProgressLine progress(quiet_);
    return repair_plan(part.field, part.gaps, part.missed, part.driven, terms, min_area_m2_, threads_,
                       [&, end = SearchEnd(seconds_)](int done, int total) {
                         progress.show("repairing " + part.field.id, done, total, "steps");
                         return end.demand();
                       });
  }

  PlanOptions options_;
  std::string coverage_file_, end_rule_ = "cheapest", output_, picture_;
  double min_area_m2_ = 1;
  int threads_ = 0;
  std::optional<double> seconds_;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_repair_command() { return std::make_unique<RepairCommand>(); }

}  // namespace tramline::app
