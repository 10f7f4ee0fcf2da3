// tramline check: does a plan hold?

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "options/common_options.h"
#include "options/field_options.h"
#include "output/result_output.h"
#include "report/check_report.h"
#include "report/report_parts.h"
#include "request/judge_plan.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kCheckHelp =
    "Verify a plan independently of the planner. Areas, turns and stops are recomputed from the tracks "
    "alone; every track has to keep clear of obstacles and to end where its rule says. Exit code: 0 the plan "
    "holds, 1 it does not, 2 bad input.";
constexpr const char* kCheckExample =
    "Examples:\n"
    "  tramline check plan.gpkg\n"
    "  tramline check plan.gpkg --field field.geojson\n"
    "  tramline check plans.gpkg --id mill-field\n"
    "  tramline check plan.gpkg --json | jq .violations";

class CheckCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "check", kCheckHelp);
    command.add_option("PLAN", plan_file_, "The plan: a GeoPackage written by 'tramline plan'.").required();
    command.begin_group("Field");
    const Option field =
        command
            .add_option("--field", input_.file,
                        "The file the plan was made from: also check that field and obstacles are the same.")
            .takes("FILE")
            .shows_default("not compared");
    add_crs_option(command, input_);
    add_obstacle_options(command, input_);
    command
        .add_option(
            "--id", id_,
            "In a file of many plans ('tramline plan --one-file'): check only that of the field of this "
            "id or key.")
        .takes("ID")
        .shows_default("all plans");
    for (const char* option : {"--crs", "--obstacles", "--obstacle-size", "--passable"})
      command.option(option).needs(field);
    command.begin_group("Output");
    command.add_flag("--json", json_,
                     "Print one JSON object instead of the table; one per line for many plans.");
    command.begin_group("Run");
    add_unused_threads_option(command, threads_);
    command.footer(kCheckExample);
    return command;
  }

  int run() override {
    const std::vector<io::FieldNames> fields = io::fields_in(plan_file_);
    if (fields.empty() || !id_.empty()) return check_one(id_) ? 0 : 1;
    bool all_hold = true;
    for (const io::FieldNames& field : fields) all_hold = check_one(field.key) && all_hold;
    return all_hold ? 0 : 1;
  }

 private:
  /// Does the plan of this field hold? Empty: the only one of the file.
  bool check_one(const std::string& field) const {
    const io::PlanFile file = io::read_plan_file(plan_file_, field);
    const check::Verdict verdict = judge(file, input_field(file.plan));
    const bool many = !field.empty() && id_.empty();
    if (json_ && many)
      print_json_line(check_json(plan_file_, file.plan, verdict));
    else if (json_)
      print_json(check_json(plan_file_, file.plan, verdict));
    else
      print_result(check_table(plan_file_, file.plan, verdict));
    return verdict.holds();
  }

  /// The input's field that the plan was made for: the same layer, feature and part.
  std::optional<Field> input_field(const Plan& plan) const {
    if (input_.file.empty()) return std::nullopt;
    return load_field(input_, plan.field.source);
  }

  FieldOptions input_;
  std::string plan_file_, id_;
  int threads_ = 0;
  bool json_ = false;
};

}  // namespace

std::unique_ptr<Command> make_check_command() { return std::make_unique<CheckCommand>(); }

}  // namespace tramline::app
