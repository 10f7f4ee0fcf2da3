// tramline check: does a plan hold?

#include <fmt/format.h>

#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "options/field_options.h"
#include "output/result_output.h"
#include "report/check_report.h"
#include "report/report_parts.h"
#include "request/judge_plan.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kHelp =
    "Verify a plan by another road: its areas, turns and stops are recomputed from the tracks alone, and "
    "every track "
    "has to keep clear of obstacles and end where its rule says. Exit code: 0 the plan holds, 1 it does not, "
    "2 bad "
    "input.";
constexpr const char* kExample =
    "Example:\n"
    "  tramline check plan.gpkg\n"
    "  tramline check plan.gpkg --field field.geojson\n"
    "  tramline check plans.gpkg --id mill-field\n"
    "  tramline check plan.gpkg --json | jq .violations";

class CheckCommand : public Command {
 public:
  Verb setup(CLI::App& program) override {
    Verb verb(program, "check", kHelp);
    verb.add_option("PLAN", plan_file_, "the plan: a GeoPackage written by tramline plan").required();
    const Option field = verb.add_option(
        "--field", input_.file, "the file the plan was made from: are field and obstacles the same?");
    add_obstacle_options(verb, input_);
    verb.add_option("--id", id_,
                    "in a file of many plans (plan --one-file): only that of the field of this id or key");
    for (const char* option : {"--crs", "--obstacles", "--obstacle-size", "--passable"})
      verb.option(option).needs(field);
    add_unused_threads_option(verb, threads_);
    verb.add_flag("--json", json_, "print one JSON object instead of the table, of many plans one per line");
    verb.footer(kExample);
    return verb;
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
