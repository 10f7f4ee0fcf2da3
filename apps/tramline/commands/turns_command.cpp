// tramline turns: how a machine gets from a track to its neighbours, and how deep a headland that takes.

#include <fmt/format.h>

#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "commands/command.h"
#include "options/common_options.h"
#include "options/plan_options.h"
#include "output/output_target.h"
#include "output/result_output.h"
#include "report/turning/turns_report.h"
#include "request/turns_request.h"
#include "tramline/io/geopackage/whole_file.h"
#include "tramline/render/turns/draw_turns.h"
#include "tramline/turns/outline/swept_outline.h"

namespace tramline::app {
namespace {

constexpr const char* kTurnsAbout =
    "Show how a machine turns from a track to its neighbours: the manoeuvres it has, how deep a headland "
    "each "
    "needs, how long it is and how long it takes. No field is needed.";

constexpr const char* kTurnsExample =
    "Examples:\n"
    "  tramline turns --width 3 --radius 6\n"
    "  tramline turns --machine sprayer.toml --angle 60 --picture turns.png\n"
    "  tramline turns --width 3 --radius 6 --reverse --spacing 3 --all\n"
    "Depths are measured square to the border: 'depth' to the farthest land that machine or implement "
    "passes\n"
    "over, 'axle' to the farthest place of the middle of the rear axle. 'passes' is the number of headland\n"
    "passes that is deep enough.";

class TurnsCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "turns", kTurnsAbout);
    command.footer(kTurnsExample);
    add_machine_options(command, options_, "");
    command.remove_option("--min-length");
    add_turning_options(command, options_.turning);
    command.begin_group("Tracks");
    command.add_option("--spacing", spacing_m_, "Distance between the two tracks, in metres.")
        .takes("M")
        .shows_default("1 to 8 working widths");
    command
        .add_option(
            "--angle", border_deg_,
            "Angle between the first track and the border on its right, in degrees: at less than 90 the next "
            "track reaches farther than the first, at more than 90 it ends earlier.")
        .takes("DEG")
        .shows_default("90");
    command.begin_group("Output");
    command.add_flag("--all", all_, "List all manoeuvres rather than the quickest to each track.");
    command.add_option("--csv", csv_, "Write all manoeuvres to this .csv.")
        .takes("FILE")
        .shows_default("not written");
    add_picture_option(command, picture_, "Draw the manoeuvres listed to this .png, .svg or .pdf.");
    command.add_flag("--json", json_, "Print one JSON object with all manoeuvres.");
    command.begin_group("Run");
    add_unused_threads_option(command, threads_);
    return command;
  }

  int run() override {
    TurnsReport report;
    report.machine = machine_of(options_);
    report.settings = turns_asked(report.machine, spacing_m_, border_deg_);
    require_writable(csv_, "--csv", {".csv"}, {options_.machine_file});
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, {options_.machine_file});
    report.rows = turn_table(report.machine, report.settings);
    write(report);
    if (json_)
      print_json(turns_json(report));
    else
      print_result(turns_table(report, all_ ? ShownTurns::kAll : ShownTurns::kQuickest));
    return 0;
  }

 private:
  void write(const TurnsReport& report) const {
    if (!csv_.empty()) {
      const std::string table = turns_csv(report);
      io::write_whole(csv_, std::as_bytes(std::span(table)));
    }
    const std::vector<TurnRow> shown = all_ ? report.rows : quickest_of_each(report.rows);
    if (!picture_.empty() && !shown.empty()) draw(report, shown);
  }

  void draw(const TurnsReport& report, const std::vector<TurnRow>& rows) const {
    constexpr double kSagitta_m = 0.01;
    const Machine& machine = report.machine;
    const Outline outline = outline_of(machine);
    const Angle border = report.settings.border;
    std::vector<render::DrawnTurn> turns;
    for (const TurnRow& row : rows) {
      render::DrawnTurn turn;
      turn.heading = fmt::format("{:g} m apart: {}", row.spacing_m, kind_text(row.manoeuvre.kind));
      turn.caption = fmt::format("{:.1f} m deep, {}, {:.1f} m long, {:.1f} s", row.depth_m,
                                 passes_text(row.passes), row.length_m, row.time_s);
      turn.path = row.manoeuvre.path;
      turn.swept = swept_outline(turn.path, outline, kSagitta_m);
      turn.spacing_m = row.spacing_m;
      turn.width_m = machine.width_m;
      turn.depth_m = row.depth_m;
      turn.border = {std::sin(border.radians()), std::cos(border.radians())};
      turns.push_back(std::move(turn));
    }
    const std::string subtitle =
        fmt::format("working width {:g} m, turning radius {:g} m, border at {:g}° to the tracks",
                    machine.width_m, machine.radius_m, border.degrees());
    render::draw_turns(machine.name.empty() ? "Turns" : machine.name, subtitle, turns, picture_);
  }

  PlanOptions options_;
  std::optional<double> spacing_m_;
  double border_deg_ = 90;
  std::string csv_, picture_;
  bool all_ = false, json_ = false;
  int threads_ = 0;
};

}  // namespace

std::unique_ptr<Command> make_turns_command() { return std::make_unique<TurnsCommand>(); }

}  // namespace tramline::app
