// tramline plan: a field and a machine in, the passes out.

#include <fmt/format.h>

#include <chrono>
#include <optional>
#include <utility>

#include "close_ups.h"
#include "command.h"
#include "field_options.h"
#include "many_fields.h"
#include "output_target.h"
#include "plan_options.h"
#include "progress.h"
#include "report/explain_report.h"
#include "report/plan_report.h"
#include "report/report_parts.h"
#include "request/output_names.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/trade_off.h"
#include "tramline/planner/validate_request.h"
#include "tramline/render/draw_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kExample =
    "Example:\n"
    "  tramline plan field.geojson --width 3 --radius 6 -o plan.gpkg --picture plan.png\n"
    "  tramline plan parcels.gpkg --layer parcels --where \"crop='wheat'\" --all --json\n"
    "  tramline plan field.geojson --width 3 --explain\n"
    "  tramline plan field.geojson --width 3 --clearance 0.5 --zoom-obstacles closeups\n"
    "  tramline plan field.geojson --width 3 --avoid paper --avoid-threshold 4 -o paper.gpkg\n"
    "Without -o, --picture and --zoom-obstacles nothing is written.";

constexpr const char* kMapExample =
    "Example:\n"
    "  tramline map field.geojson --width 4 --headlands 2 --ab \"9.1871,48.7120 9.1893,48.7131\" -o "
    "map.gpkg\n"
    "  tramline map field.geojson --width 4 --headlands 2 --curved auto --end-rule cover --picture map.png\n"
    "  tramline map field.geojson --width 6 --guide lines.gpkg --guide-where \"name='AB 1'\" --json\n"
    "Takes the options of 'tramline plan', which makes the same of them.";

/// The verbs `plan` and `map`: the second is the first in the words of those who ask for the map of a field.
class PlanCommand : public Command {
 public:
  PlanCommand(const char* word, const char* about, const char* example)
      : word_(word), about_(about), example_(example) {}

  CLI::App* setup(CLI::App& app) override {
    CLI::App* verb = app.add_subcommand(word_, about_);
    verb->footer(example_);
    add_field_options(*verb, field_options_);
    add_plan_options(*verb, plan_options_);
    verb->add_option("-o,--output", output_, "write the plan to this GeoPackage (.gpkg)");
    verb->add_option("--picture", picture_, "draw the plan to this .png, .svg or .pdf");
    verb->add_option("--zoom-obstacles", zoom_,
                     "draw a close-up of every obstacle into this folder, which is made if missing");
    verb->add_flag(
        "--explain", explain_,
        "also say why this plan: what causes its cost, and how much more the next best would cost");
    verb->add_flag(
        "--front", front_,
        "look for other plans worth a choice too (see 'tramline compare'), and keep their numbers in "
        "the plan file and in --json");
    verb->add_option("--threads", threads_, "threads to use (default: all cores)")
        ->check(CLI::Range(0, 1024));
    verb->add_flag("--json", json_, "print one JSON object per field");
    verb->add_flag("--quiet", quiet_, "no progress, no table");
    return verb;
  }

  int run() override {
    machine_ = machine_of(plan_options_);
    objective_ = objective_of(plan_options_);
    settings_ = settings_of(plan_options_);
    validate_request(machine_, objective_, settings_);
    const std::vector<std::string> inputs{field_options_.file, field_options_.obstacles_file,
                                          field_options_.passable_file, plan_options_.machine_file,
                                          plan_options_.guide_file};
    require_writable(output_, "--output", {".gpkg"}, inputs);
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, inputs);
    require_folder(zoom_, "--zoom-obstacles");
    const FieldInput input = load_fields(field_options_);
    if (!input.fields.empty()) guide_ = guide_of(plan_options_, input.fields.front().source.input_crs);
    const bool single = !field_options_.all && input.fields.size() == 1;
    return single ? plan_single(input.fields.front(), input.skipped) : plan_many(input);
  }

 private:
  int plan_single(const Field& field, const std::vector<Skipped>& skipped) {
    const Planned planned = plan_one(field);
    Outputs outputs{{output_, false}, {picture_, false}, CloseUps(zoom_)};
    write(planned.plan, outputs);
    if (json_)
      fmt::print("{}\n", json_line(json_of(planned, skipped)));
    else if (!quiet_)
      fmt::print("{}{}", plan_table(planned.plan, skipped, planned.seconds), explanation_of(planned));
    return 0;
  }

  /// Several features, or the parts of one.
  int plan_many(const FieldInput& input) const {
    Outputs outputs{{output_, true}, {picture_, true}, CloseUps(zoom_)};
    return work_on_many_fields(input, {json_, quiet_, "planned"}, [&](const Field& field) {
      const Planned planned = plan_one(field);
      write(planned.plan, outputs);
      report_one_of_many(planned);
    });
  }

  struct Planned {
    Plan plan;
    std::optional<Explanation> why;
    double seconds = 0;
  };

  Planned plan_one(const Field& field) const {
    ProgressLine progress(quiet_);
    const PlanSettings settings = settings_for(settings_, guide_, field, machine_);
    if ((explain_ || front_) && settings.tracks == TrackConstruction::kPaper)
      throw bad_input(
          "--explain and --front know nothing of tracks as in the paper; leave --tracks paper out");
    if ((explain_ || front_) && settings.shape != TrackShape::kStraight)
      throw bad_input(
          "--explain and --front are about straight tracks; leave --curved out, or give a line without "
          "bends");
    const auto start = std::chrono::steady_clock::now();
    Planned out;
    if (explain_) {
      ExplainedPlan explained =
          plan_and_explain(field, machine_, objective_, settings, threads_, shown(field, progress));
      out.plan = std::move(explained.plan);
      out.why = std::move(explained.why);
    }
    if (front_)
      out.plan = plan_with_front(field, settings, progress);
    else if (!explain_)
      out.plan = plan_field(field, machine_, objective_, settings, threads_, shown(field, progress));
    out.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    return out;
  }

  static nlohmann::ordered_json json_of(const Planned& planned, const std::vector<Skipped>& skipped) {
    nlohmann::ordered_json out = plan_json(planned.plan, skipped, planned.seconds);
    if (planned.why) out["explain"] = explain_json(*planned.why);
    return out;
  }

  static std::string explanation_of(const Planned& planned) {
    return planned.why ? explain_rows(*planned.why, planned.plan.cost) : "";
  }

  static Progress shown(const Field& field, ProgressLine& progress) {
    return [&](int done, int total) { progress.show("planning " + field.id, done, total); };
  }

  Plan plan_with_front(const Field& field, const PlanSettings& settings, ProgressLine& progress) const {
    TradeOff found = trade_off(field, machine_, objective_, settings, threads_, [&](int done, int total) {
      progress.show("comparing " + field.id, done, total, "searches");
    });
    Plan plan = given_plan(found);
    plan.front = std::move(found.front);
    return plan;
  }

  struct Outputs {
    OutputNames plans;
    OutputNames pictures;
    CloseUps close_ups;
  };

  void write(const Plan& plan, Outputs& outputs) const {
    if (!output_.empty()) io::write_plan(plan, outputs.plans.next(plan.field.id));
    if (!picture_.empty()) render::draw_plan(plan, outputs.pictures.next(plan.field.id));
    outputs.close_ups.write(plan);
  }

  void report_one_of_many(const Planned& planned) const {
    if (json_)
      fmt::print("{}\n", json_line(json_of(planned, {})));
    else if (!quiet_)
      fmt::print("{}{}", plan_line(planned.plan, planned.seconds), explanation_of(planned));
  }

  const char* word_;
  const char* about_;
  const char* example_;
  FieldOptions field_options_;
  PlanOptions plan_options_;
  std::optional<GuideLine> guide_;
  std::string output_, picture_, zoom_;
  int threads_ = 0;
  bool explain_ = false, front_ = false, json_ = false, quiet_ = false;
  Machine machine_;
  Objective objective_;
  PlanSettings settings_;
};

}  // namespace

std::unique_ptr<Command> make_plan_command() {
  return std::make_unique<PlanCommand>("plan", "Plan every pass over a field", kExample);
}
std::unique_ptr<Command> make_map_command() {
  return std::make_unique<PlanCommand>(
      "map", "Map a field: headlands, body, tracks along a line or a curve, swaths and their overlap",
      kMapExample);
}

}  // namespace tramline::app
