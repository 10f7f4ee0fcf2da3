// tramline compare: the plans of a field that are worth a choice, and what each gives up.

#include <fmt/format.h>

#include <charconv>
#include <chrono>
#include <span>
#include <utility>

#include "commands/command.h"
#include "commands/many_fields.h"
#include "options/common_options.h"
#include "options/compare_options.h"
#include "options/search_seconds.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/search_end.h"
#include "report/front_report.h"
#include "request/output_names.h"
#include "tables/job_cost_run.h"
#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/planner/pareto/trade_off.h"
#include "tramline/render/trade_off/draw_trade_off.h"

namespace tramline::app {
namespace {

constexpr const char* kCompareAbout =
    "Compare the plans of a field that are worth a choice. Of any two of them, each is better than the other "
    "in overlap, uncovered land, turns or stops.";

constexpr const char* kCompareExample =
    "Examples:\n"
    "  tramline compare field.geojson --width 3 --radius 6 --picture front.png\n"
    "  tramline compare field.geojson --width 3 --for 0.02,0.10,0.5,5 --for 0.04,0.10,2\n"
    "  tramline compare field.geojson --width 3 --csv front.csv -o knee.gpkg --point knee\n"
    "  tramline compare field.geojson --widths 3,6,12 --operation seeding\n"
    "With --widths or --machines whole plans of several machines are compared by hours and euros instead.\n"
    "The plans come from up to 16 searches: one for the given prices, one each for overlap, uncovered land "
    "and\n"
    "turns before all else, and some with one of the given prices times 1/8, 1/2, 2 and 8. The ends of a "
    "plan's\n"
    "swaths and its ways past obstacles are those chosen for the prices of its search.\n"
    "Papers: Versleijen 2019, Path planning on agricultural fields with obstacles, MSc thesis, Wageningen\n"
    "University. Zhou et al. 2020, Agronomy 10:83.";

/// "knee", "7": a point of a front, as typed.
class PointChoice {
 public:
  /// Throws kBadInput where the word is neither a number from 1 nor the name of a mark.
  explicit PointChoice(const std::string& word) : word_(word) {
    if (is_mark()) return;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number_);
    if (error != std::errc{} || end != word.data() + word.size() || number_ == 0)
      throw bad_input(fmt::format(
          "--point takes given, knee, overlap, uncovered, turns or a number from 1, not '{}'", word));
  }

  /// Throws kBadInput where the front has no such point.
  std::size_t in(const Front& front) const {
    const FrontMarks& marks = front.marks;
    if (word_ == "given") return marks.given_prices;
    if (word_ == "knee") return marks.knee;
    if (word_ == "overlap") return marks.least_overlap;
    if (word_ == "uncovered") return marks.least_uncovered;
    if (word_ == "turns") return marks.fewest_turns;
    if (number_ > front.points.size())
      throw bad_input(
          fmt::format("--point {}: there is no such plan, the front has {}", word_, front.points.size()));
    return number_ - 1;
  }

 private:
  bool is_mark() const {
    return word_ == "given" || word_ == "knee" || word_ == "overlap" || word_ == "uncovered" ||
           word_ == "turns";
  }
  std::string word_;
  std::size_t number_ = 0;
};

class CompareCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "compare", kCompareAbout);
    command.footer(kCompareExample);
    add_compare_options(command, options_);
    command.begin_group("Output");
    command.add_option("--csv", csv_, "Write a table of the plans to this .csv.")
        .takes("FILE")
        .shows_default("not written");
    add_picture_option(command, picture_,
                       "Draw the trade-off and the plans that stand out to this .png, .svg or .pdf.");
    add_output_option(command, output_, "Write one of the plans to this GeoPackage (.gpkg).");
    command
        .add_option(
            "--point", point_,
            "The plan that --output writes: 'given' (cheapest at the given prices), 'knee', 'overlap', "
            "'uncovered', 'turns', or its number in the table.")
        .takes("WORD")
        .shows_default("given");
    add_report_options(command, json_, "Print one JSON object per field.", quiet_);
    command.begin_group("Run");
    add_seconds_option(command, seconds_);
    add_threads_option(command, threads_);
    command_.emplace(command);
    return command;
  }

  int run() override {
    if (options_.machines.asked()) return compare_machines();
    asked_ = asked_comparison(*command_, options_);
    const PointChoice choice(point_);
    const std::vector<std::string> inputs{options_.field.file, options_.field.obstacles_file,
                                          options_.field.passable_file, options_.plan.machine_file};
    require_writable(csv_, "--csv", {".csv"}, inputs);
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, inputs);
    require_writable(output_, "--output", {".gpkg"}, inputs);
    const FieldInput input = load_fields(options_.field);
    const bool single = !options_.field.all && input.fields.size() == 1;
    const Naming naming = single ? Naming::kAsGiven : Naming::kWithId;
    Outputs outputs{{csv_, naming}, {picture_, naming}, {output_, naming}, choice};
    const ManyFieldsReport report{json_, quiet_, "compared the plans of"};
    if (single) {
      const Field& field = input.fields.front();
      const InterruptEndsSearches interruptible;
      return show_single(field, compare(field, input.skipped, outputs), report);
    }
    return work_on_many_fields(input, report,
                               [&](const Field& field) { return compare(field, {}, outputs); });
  }

 private:
  /// What the whole job would cost with other machines.
  int compare_machines() {
    if (!options_.prices.empty() || !picture_.empty() || !output_.empty() || command_->is_given("--point"))
      throw bad_input(
          "several machines are compared by their whole routes: with --widths or --machines leave out --for, "
          "--picture, --output and --point");
    const AskedMachines asked = asked_machines(*command_, options_);
    JobCostRun run;
    run.settings = asked.settings;
    run.objective = asked.objective;
    run.machines = asked.machines;
    run.csv_file = csv_;
    run.seconds = seconds_;
    run.threads = threads_;
    run.json = json_;
    run.quiet = quiet_;
    return run_job_costs(run, options_.field, options_.plan);
  }

  struct Outputs {
    OutputNames tables, pictures, plans;
    PointChoice choice;
  };

  FieldResult compare(const Field& field, const std::vector<Skipped>& skipped, Outputs& outputs) const {
    const auto start = std::chrono::steady_clock::now();
    const TradeOff found = compared(field);
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
    write(found, field, outputs);
    const PlanSettings settings = asked_.plans.settings_on(field);
    const Comparison comparison{field,         asked_.plans.machine(), settings,       found.front,
                                asked_.prices, elapsed.count(),        found.cut_short};
    return {compare_json(comparison, skipped), compare_table(comparison, skipped), {}};
  }

  TradeOff compared(const Field& field) const {
    ProgressLine progress(quiet_);
    return trade_off(field, asked_.plans.machine(), asked_.plans.objective(), asked_.plans.settings_on(field),
                     threads_, [&field, &progress, end = SearchEnd(seconds_)](int done, int total) {
                       progress.show("comparing " + field.id, done, total, "searches");
                       return end.demand();
                     });
  }

  /// What may be refused comes before anything is written.
  void write(const TradeOff& found, const Field& field, Outputs& outputs) const {
    const std::size_t chosen = outputs.choice.in(found.front);
    if (!csv_.empty()) {
      const std::string table = front_csv(found.front);
      io::write_whole(outputs.tables.next(field.id), std::as_bytes(std::span(table)));
    }
    if (!picture_.empty()) draw(found, outputs.pictures.next(field.id));
    if (!output_.empty()) io::write_plan(plan_of(found, chosen), outputs.plans.next(field.id));
  }

  static void draw(const TradeOff& found, const std::filesystem::path& path) {
    std::vector<Plan> plans;
    for (const std::size_t point : marked_points(found.front)) plans.push_back(plan_of(found, point));
    render::draw_trade_off(found.front, plans, path);
  }

  CompareOptions options_;
  std::optional<CommandOptions> command_;
  AskedComparison asked_;
  std::string csv_, picture_, output_, point_ = "given";
  int threads_ = 0;
  std::optional<double> seconds_;
  bool json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_compare_command() { return std::make_unique<CompareCommand>(); }

}  // namespace tramline::app
