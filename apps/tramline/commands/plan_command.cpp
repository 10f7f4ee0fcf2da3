// tramline plan: a field and a machine in, the passes out.

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <span>
#include <utility>

#include "batch/digest.h"
#include "commands/command.h"
#include "commands/many_fields.h"
#include "commands/plan_run_input.h"
#include "options/common_options.h"
#include "options/field_options.h"
#include "options/plan_options.h"
#include "output/output_target.h"
#include "output/plan_outputs.h"
#include "output/progress.h"
#include "output/search_end.h"
#include "report/explain_report.h"
#include "report/map_table_report.h"
#include "report/plan_report.h"
#include "report/plan_summary.h"
#include "report/turning/route_report.h"
#include "request/asked_plans.h"
#include "request/field_key.h"
#include "request/output_names.h"
#include "tables/map_table_run.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/validate_request.h"

namespace tramline::app {
namespace {

constexpr const char* kPlanExample =
    "Examples:\n"
    "  tramline plan field.geojson --width 3 --radius 6 -o plan.gpkg --picture plan.png\n"
    "  tramline plan parcels.gpkg --layer parcels --where \"crop='wheat'\" --all --json\n"
    "  tramline plan parcels.gpkg --all --width 6 -o plans.gpkg --one-file --resume\n"
    "  tramline plan field.geojson --width 3 --explain\n"
    "  tramline plan field.geojson --width 3 --clearance 0.5 --zoom-obstacles closeups\n"
    "  tramline plan field.geojson --width 3 --avoid paper --avoid-threshold 4 -o paper.gpkg\n"
    "  tramline plan field.geojson --width 6 --subfields drawn.gpkg -o plan.gpkg --picture plan.png\n"
    "  tramline plan field.geojson --width 3 --done plan-6m.gpkg -o rest.gpkg\n"
    "Without -o, --picture and --zoom-obstacles nothing is written.\n"
    "A plan is one to be driven: headlands as its turns need them, the whole route, and of several such\n"
    "plans the cheapest in euros. Tracks alone are planned with --prices, --weights, --minimise, --like,\n"
    "--strategy sweep, --tracks paper, --only, --done or --front.\n"
    "Papers: Versleijen 2019, Path planning on agricultural fields with obstacles, MSc thesis, Wageningen\n"
    "University. Zhou et al. 2020, Agronomy 10:83.";

constexpr const char* kMapExample =
    "Examples:\n"
    "  tramline map field.geojson --width 4 --headlands 2 --ab \"9.1871,48.7120 9.1893,48.7131\" -o "
    "map.gpkg\n"
    "  tramline map field.geojson --width 4 --headlands 2 --curved auto --end-rule cover --picture map.png\n"
    "  tramline map field.geojson --width 6 --guide lines.gpkg --guide-where \"name='AB 1'\" --json\n"
    "  tramline map field.geojson --headlands 2 --end-rule cover --directions edges,curved --widths 2,4,6 "
    "\\\n"
    "    --table maps.csv --picture maps.png\n"
    "'tramline map' takes the options of 'tramline plan', and plans tracks alone unless --route is given. "
    "With\n"
    "--directions or\n"
    "--widths it compares maps, and --picture shows all directions at the first width.\n"
    "Papers: Versleijen 2019, Path planning on agricultural fields with obstacles, MSc thesis, Wageningen\n"
    "University. Zhou et al. 2020, Agronomy 10:83.";

const std::vector<Skipped> kNothingSkipped;

/// The commands `plan` and `map`: the second is the first in the words of those who ask for the map of a
/// field.
class PlanCommand : public Command {
 public:
  enum class Tables { kNone, kOfMaps };
  PlanCommand(const char* word, const char* about, const char* example, Tables tables)
      : word_(word),
        about_(about),
        example_(example),
        tables_(tables),
        defaults_(tables == Tables::kNone ? PlanDefaults::kWhole : PlanDefaults::kTracks) {}

  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, word_, about_);
    command.footer(example_);
    add_field_options(command, field_options_);
    add_plan_options(command, plan_options_, defaults_);
    if (tables_ == Tables::kOfMaps) add_map_table_options(command, table_options_);
    add_land_options(command, land_options_);
    command.begin_group("Output");
    const Option output =
        add_output_option(command, wanted_.plan, "Write the plan to this GeoPackage (.gpkg).");
    add_picture_option(command, wanted_.picture, "Draw the plan to this .png, .svg or .pdf.");
    command
        .add_option("--zoom-obstacles", wanted_.close_ups,
                    "Draw a close-up of every obstacle into this folder, which is made if it is missing.")
        .takes("FOLDER")
        .shows_default("none drawn");
    command
        .add_flag("--one-file", wanted_.one_file,
                  "Put the plans of all fields into the one file of --output instead of a file for each.")
        .needs(output);
    command.add_flag("--explain", explain_,
                     "Also report how the plan was found and why it was chosen: its cost by cause, the least "
                     "that any plan could cost, the next best plans, all repairs and notes.");
    command.add_flag("--front", front_,
                     "Also look for other plans that are worth considering (see 'tramline compare'), and "
                     "keep their figures in the plan file and in --json.");
    add_report_options(command, json_, "Print one JSON object per field.", quiet_);
    command.begin_group("Run");
    add_seconds_option(command, seconds_);
    command.add_flag(
        "--resume", resume_,
        "Continue an earlier run of the same command: fields that it has finished are not planned "
        "again.");
    add_threads_option(command, threads_);
    command_.emplace(command);
    return command;
  }

  int run() override {
    take_conventions(*command_, plan_options_);
    // Headlands go round whole fields.
    const bool part_only = !land_options_.only_file.empty() || !land_options_.done_files.empty();
    if (defaults_ == PlanDefaults::kWhole && !front_ && !part_only) take_whole_plan(*command_, plan_options_);
    if (table_options_.asked()) return run_tables();
    asked_ = AskedPlans(plan_options_);
    if (!table_options_.table_file.empty())
      throw bad_input("--table writes the table of --directions or --widths: give one of these");
    std::vector<std::string> inputs{field_options_.file,          field_options_.obstacles_file,
                                    field_options_.passable_file, plan_options_.machine_file,
                                    plan_options_.guide_file,     land_options_.subfields_file,
                                    land_options_.only_file};
    inputs.insert(inputs.end(), land_options_.done_files.begin(), land_options_.done_files.end());
    require_writable(wanted_.plan, "--output", {".gpkg"}, inputs);
    require_writable(wanted_.picture, "--picture", {".png", ".svg", ".pdf"}, inputs);
    require_folder(wanted_.close_ups, "--zoom-obstacles");
    if (resume_ && wanted_.plan.empty() && wanted_.picture.empty() && wanted_.close_ups.empty())
      throw bad_input(
          "--resume needs --output, --picture or --zoom-obstacles: what is finished is noted beside them");
    FieldInput input = load_fields(field_options_);
    asked_.read_files(plan_options_, land_options_, input);
    const bool one_name = !field_options_.all && input.fields.size() == 1;
    const bool single = one_name && !wanted_.one_file && !resume_;
    PlanOutputs outputs(wanted_, input.fields, one_name ? Naming::kAsGiven : Naming::kWithId);
    return single ? plan_single(input.fields.front(), input.skipped, outputs) : plan_many(input, outputs);
  }

 private:
  /// A table of maps for each field.
  int run_tables() {
    require_only_tables();
    std::optional<DirectionWords> directions;
    if (!table_options_.directions.empty()) directions = direction_words(table_options_.directions);
    const std::vector<double> widths_m = take_widths();
    const std::vector<std::string> inputs{field_options_.file, field_options_.obstacles_file,
                                          field_options_.passable_file, plan_options_.machine_file,
                                          plan_options_.guide_file};
    require_writable(table_options_.table_file, "--table", {".csv"}, inputs);
    require_writable(wanted_.picture, "--picture", {".png", ".svg", ".pdf"}, inputs);
    FieldInput input = load_fields(field_options_);
    asked_.read_files(plan_options_, land_options_, input);
    const bool single = !field_options_.all && input.fields.size() == 1;
    const Naming naming = single ? Naming::kAsGiven : Naming::kWithId;
    OutputNames tables(table_options_.table_file, naming), pictures(wanted_.picture, naming);
    const auto work = [&](const Field& field) {
      const MapTableTask task{field, asked_.machine(), asked_.settings_on(field), directions, widths_m};
      const MapTableResult found = mapped(task, [&](const Machine& machine, const PlanSettings& settings) {
        ProgressLine progress(quiet_);
        return plan_field(field, machine, asked_.objective(), settings, threads_, shown(field, progress));
      });
      write(found, field, tables, pictures);
      const std::vector<Skipped>& skipped = single ? input.skipped : kNothingSkipped;
      return FieldResult{map_table_json(found.table, skipped), map_table_text(found.table, skipped), {}};
    };
    const ManyFieldsReport report{json_, quiet_, "mapped"};
    if (!single) return work_on_many_fields(input, report, work);
    const InterruptEndsSearches interruptible;
    return show_single(input.fields.front(), work(input.fields.front()), report);
  }

  /// The widths of a table, of which the machine has the first.
  std::vector<double> take_widths() {
    std::vector<double> out;
    if (!table_options_.widths.empty()) {
      out = map_widths(table_options_.widths);
      plan_options_.width_m = out.front();
    }
    asked_ = AskedPlans(plan_options_);
    if (out.empty()) out.push_back(asked_.machine().width_m);
    const PlanSettings settings = asked_.settings_on({});
    for (const double width_m : out) {
      Machine machine = asked_.machine();
      machine.width_m = width_m;
      validate_request(machine, asked_.objective(), settings);
    }
    return out;
  }

  void write(const MapTableResult& found, const Field& field, OutputNames& tables,
             OutputNames& pictures) const {
    if (!table_options_.table_file.empty()) {
      const std::string csv = map_table_csv(found.table);
      io::write_whole(tables.next(field.id), std::as_bytes(std::span(csv)));
    }
    if (!wanted_.picture.empty())
      render::draw_small_maps(field.id.empty() ? "field" : field.id, picture_subtitle(found), found.shown,
                              pictures.next(field.id));
  }

  /// What makes no sense for a table of maps.
  void require_only_tables() const {
    if (plan_options_.width_m && !table_options_.widths.empty())
      throw bad_input("--widths takes the place of --width: give one of them");
    const bool line = !plan_options_.ab.empty() || !plan_options_.guide_file.empty();
    if (!table_options_.directions.empty() && (line || !plan_options_.curved.empty()))
      throw bad_input(
          "--directions takes the place of --ab, --guide and --curved: leave them out, or --directions");
    if (!wanted_.plan.empty() || !wanted_.close_ups.empty() || wanted_.one_file || explain_ || front_ ||
        resume_)
      throw bad_input(
          "a table of maps writes no plan: with --directions or --widths leave out --output, --one-file, "
          "--zoom-obstacles, --explain, --front and --resume");
    if (!land_options_.subfields_file.empty() || !land_options_.only_file.empty() ||
        !land_options_.done_files.empty())
      throw bad_input(
          "a table of maps is of the whole field: with --directions or --widths leave out --subfields, "
          "--only "
          "and --done");
  }

  static std::string picture_subtitle(const MapTableResult& found) {
    if (found.table.cells.size() == found.table.widths_m.size())
      return fmt::format("{} working widths", found.table.widths_m.size());
    return fmt::format("{} directions, working width {:g} m", found.shown.size(),
                       found.table.widths_m.front());
  }

  int plan_single(const Field& field, const std::vector<Skipped>& skipped, PlanOutputs& outputs) const {
    const InterruptEndsSearches interruptible;
    const Planned planned = plan_one(field);
    outputs.write(planned.plan);
    return show_single(field,
                       {json_of(planned, skipped),
                        plan_summary(planned.plan, skipped) + explanation_of(planned, skipped),
                        {}},
                       report());
  }

  /// Several features, or the parts of one.
  int plan_many(const FieldInput& input, PlanOutputs& outputs) const {
    const auto work = [&](const Field& field) {
      const Planned planned = plan_one(field);
      return FieldResult{json_of(planned, {}),
                         plan_line(planned.plan, planned.seconds) + explanation_of(planned, {}),
                         outputs.write(planned.plan)};
    };
    if (outputs.record_file().empty()) return work_on_many_fields(input, report(), work);
    const RunRecord::Start start = resume_ ? RunRecord::Start::kResume : RunRecord::Start::kAnew;
    RunRecord record(outputs.record_file(), start);
    std::vector<std::pair<std::string, std::string>> made_from;
    for (const Field& field : input.fields) made_from.emplace_back(field_key(field), digest(field));
    outputs.begin(record, made_from, start);
    const int code = work_on_many_fields(input, report(), work,
                                         {&record, [&](const Field& field) { return digest(field); }});
    outputs.finish(record, made_from);
    return code;
  }

  ManyFieldsReport report() const { return {json_, quiet_, "planned"}; }

  /// Of all that the result for a field depends on.
  std::string digest(const Field& field) const {
    Plan asked;
    asked.field = field;
    asked.machine = asked_.machine();
    asked.objective = asked_.objective();
    asked.settings = asked_.settings_on(field);
    return digest_of(text_of(asked.settings.given) +
                     made_from_text(asked, fmt::format("{}\n{}\n{}\n{} {} {} {}", wanted_.plan,
                                                       wanted_.picture, wanted_.close_ups, wanted_.one_file,
                                                       explain_, front_, seconds_.value_or(0))));
  }

  struct Planned {
    Plan plan;
    std::optional<Explanation> why;
    std::vector<RouteAlternative> routes{};  ///< with --explain
    double seconds = 0;
  };

  Planned plan_one(const Field& field) const {
    ProgressLine progress(quiet_);
    const PlanSettings settings = asked_.settings_on(field);
    const auto start = std::chrono::steady_clock::now();
    Planned out;
    if (front_) {
      plan_with_front(field, settings, progress, out);
    } else if (explain_) {
      ExplainedPlan both = plan_and_explain(field, asked_.machine(), asked_.objective(), settings, threads_,
                                            shown(field, progress));
      out.plan = std::move(both.plan);
      out.why = std::move(both.why);
      out.routes = std::move(both.routes);
    } else {
      out.plan =
          plan_field(field, asked_.machine(), asked_.objective(), settings, threads_, shown(field, progress));
    }
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  }

  nlohmann::ordered_json json_of(const Planned& planned, const std::vector<Skipped>& skipped) const {
    nlohmann::ordered_json out = plan_json(planned.plan, skipped, planned.seconds);
    if (explain_) out["explain"] = planned.why ? explain_json(*planned.why) : nlohmann::ordered_json();
    if (!planned.routes.empty()) out["compared_routes"] = compared_routes_json(planned.routes);
    return out;
  }

  std::string explanation_of(const Planned& planned, const std::vector<Skipped>& skipped) const {
    if (!explain_) return "";
    const std::string details = plan_details(planned.plan, skipped, planned.seconds);
    if (!planned.routes.empty()) return details + compared_routes_rows(planned.routes);
    return details + (planned.why ? explain_rows(*planned.why, planned.plan.cost)
                                  : "cost by cause  is known of straight tracks only\n");
  }

  Progress shown(const Field& field, ProgressLine& progress) const {
    return [&field, &progress, end = SearchEnd(seconds_)](int done, int total) {
      progress.show("planning " + field.id, done, total);
      return end.demand();
    };
  }

  /// One search for all that is asked for.
  void plan_with_front(const Field& field, const PlanSettings& settings, ProgressLine& progress,
                       Planned& out) const {
    TradeOff found = trade_off(field, asked_.machine(), asked_.objective(), settings, threads_,
                               [&field, &progress, end = SearchEnd(seconds_)](int done, int total) {
                                 progress.show("comparing " + field.id, done, total, "searches");
                                 return end.demand();
                               });
    out.plan = given_plan(found);
    if (explain_) out.why = why_given(found, threads_);
    out.plan.front = std::move(found.front);
  }

  const char* word_;
  const char* about_;
  const char* example_;
  FieldOptions field_options_;
  std::optional<CommandOptions> command_;
  PlanOptions plan_options_;
  LandOptions land_options_;
  AskedPlans asked_;
  Tables tables_;
  PlanDefaults defaults_;
  MapTableOptions table_options_;
  WantedFiles wanted_;
  int threads_ = 0;
  std::optional<double> seconds_;
  bool explain_ = false, front_ = false, resume_ = false, json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_plan_command() {
  return std::make_unique<PlanCommand>("plan", "Plan every pass over a field.", kPlanExample,
                                       PlanCommand::Tables::kNone);
}
std::unique_ptr<Command> make_map_command() {
  return std::make_unique<PlanCommand>(
      "map", "Map a field: headlands, body, tracks along a line or a curve, swaths and their overlap.",
      kMapExample, PlanCommand::Tables::kOfMaps);
}

}  // namespace tramline::app
