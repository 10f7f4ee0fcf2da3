// tramline price: lines that somebody else drew or planned in, the figures of that plan out.

#include <chrono>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "commands/many_fields.h"
#include "options/common_options.h"
#include "options/plan_options.h"
#include "options/price_options.h"
#include "options/search_seconds.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/search_end.h"
#include "report/price_report.h"
#include "request/price_input.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/price/price_lines.h"
#include "tramline/planner/validate_request.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::app {
namespace {

constexpr const char* kPriceAbout =
    "Price lines that somebody else drew or planned: overlap, uncovered land, turns, stops and cost by the "
    "definitions of 'tramline plan'. With --compare the same field is planned, too.";

constexpr const char* kPriceExample =
    "Examples:\n"
    "  tramline price lines.shp --field field.geojson --width 6\n"
    "  tramline price lines.gpkg --lines-layer ab_lines --field field.geojson --width 6 --picture lines.png\n"
    "  tramline price lines.kml --field parcels.gpkg --id 17 --width 3 --minimise overlap --compare\n"
    "  tramline price plan.gpkg --prices 0.05,0.10,2\n"
    "  tramline price lines.geojson --field field.geojson --width 6 -o lines-plan.gpkg\n"
    "Each line is driven with the work on over its whole length, in the order of the file, or of its column\n"
    "'order'. Options of the search, of swaths, headlands and tracks are those of the plan of --compare.\n"
    "Paper: Versleijen 2019, Path planning on agricultural fields with obstacles, MSc thesis, Wageningen\n"
    "University, tables 12 to 14.";

class PriceCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "price", kPriceAbout);
    command.footer(kPriceExample);
    add_price_options(command, options_);
    command.begin_group("Output");
    add_output_option(command, output_, "Write the lines as a plan to this GeoPackage (.gpkg).");
    add_picture_option(command, picture_, "Draw the lines as a plan to this .png, .svg or .pdf.");
    add_report_options(command, json_, "Print one JSON object.", quiet_);
    command.begin_group("Run");
    add_seconds_option(command, seconds_);
    command.option("--seconds").needs(command.option("--compare"));
    add_threads_option(command, threads_);
    command_.emplace(command);
    return command;
  }

  int run() override {
    take_conventions(*command_, options_.plan);
    const std::vector<std::string> inputs{options_.lines.file,           options_.field.file,
                                          options_.field.obstacles_file, options_.field.passable_file,
                                          options_.plan.machine_file,    options_.plan.guide_file};
    require_writable(output_, "--output", {".gpkg"}, inputs);
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, inputs);
    PriceInput input = price_input(options_.lines, options_.field, options_.plan);
    validate_request(input.machine, input.objective, input.settings);
    const auto start = std::chrono::steady_clock::now();
    PricedLines priced =
        price_lines(input.field, input.machine, input.objective, input.lines, input.settings.clearance_m);
    std::optional<Plan> planned;
    if (options_.compare) planned = plan_of(input);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    for (Skipped& line : priced.skipped) input.skipped.push_back(std::move(line));
    if (!output_.empty()) io::write_plan(priced.plan, output_);
    if (!picture_.empty()) render::draw_plan(priced.plan, picture_);
    const PricedPlans both{priced.plan, planned ? &*planned : nullptr, input.skipped, elapsed.count()};
    return show_single(input.field, {price_json(both), price_table(both), {}}, {json_, quiet_, "priced"});
  }

 private:
  Plan plan_of(const PriceInput& input) const {
    const InterruptEndsSearches interruptible;
    ProgressLine progress(quiet_);
    const PlanSettings settings = settings_for(
        input.settings, guide_of(options_.plan, input.field.source.input_crs), input.field, input.machine);
    return plan_field(input.field, input.machine, input.objective, settings, threads_,
                      [&, end = SearchEnd(seconds_)](int done, int total) {
                        progress.show("planning " + input.field.id, done, total);
                        return end.demand();
                      });
  }

  PriceOptions options_;
  std::optional<CommandOptions> command_;
  std::string output_, picture_;
  int threads_ = 0;
  std::optional<double> seconds_;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_price_command() { return std::make_unique<PriceCommand>(); }

}  // namespace tramline::app
