// tramline dose: how much was applied where.

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <vector>

#include "commands/command.h"
#include "options/common_options.h"
#include "options/drive_options.h"
#include "options/field_options.h"
#include "output/output_target.h"
#include "output/progress.h"
#include "output/result_output.h"
#include "report/dose_report.h"
#include "report/report_parts.h"
#include "request/evaluate_input.h"
#include "tramline/coverage/dose/dose.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/log/read_log.h"
#include "tramline/io/pattern/read_pattern.h"
#include "tramline/io/raster/write_raster.h"
#include "tramline/render/dose/draw_dose.h"

namespace tramline::app {
namespace {

constexpr const char* kDoseHelp =
    "Map how much a recorded drive applied where: the amount in every cell, its mean and spread.";
constexpr const char* kDoseExample =
    "Examples:\n"
    "  tramline dose spraying.csv --width 24 --nominal-rate 200 -o dose.tif --picture dose.png\n"
    "  tramline dose spraying.csv --width 24 --nominal-rate 200 --wind 4,270 --pattern boom.csv --cell 0.5\n"
    "  tramline dose spraying.csv --field fields.gpkg --where \"id='mill-field'\" --nominal-rate 200\n"
    "  tramline dose coverage.gpkg --nominal-rate 200 --json\n"
    "Rates of the log take precedence over --nominal-rate. docs/dose.md describes the figures.";

constexpr double kKmh = 1 / 3.6;

/// "4,270": m/s, and the degrees it blows from.
coverage::WindSettings wind_of(const std::string& text, coverage::WindSettings out) {
  char* end = nullptr;
  const double speed_mps = std::strtod(text.c_str(), &end);
  const bool has_comma = end != text.c_str() && *end == ',';
  const char* second = has_comma ? end + 1 : end;
  const double from_deg = has_comma ? std::strtod(second, &end) : 0;
  const bool understood = has_comma && end != second && *end == '\0' && std::isfinite(speed_mps) &&
                          std::isfinite(from_deg) && speed_mps >= 0 && speed_mps <= 50;
  if (!understood)
    throw bad_input(fmt::format(
        "--wind {}: give its speed, from 0 to 50 m/s, and the degrees it blows from, such as 4,270", text));
  out.speed_mps = speed_mps;
  out.from = Heading::clockwise_from_north(Angle::degrees(from_deg));
  return out;
}

class DoseCommand : public Command {
 public:
  CommandOptions setup(CLI::App& program) override {
    CommandOptions command(program, "dose", kDoseHelp);
    command.add_option(
        "INPUT", input_,
        "A log in any format that 'tramline evaluate' reads, or a coverage file of 'tramline evaluate -o'.");
    add_field_choice(command, field_);
    command.begin_group("Log");
    command.add_option("--log", drive_.log.log, "Read this log of an ISOXML task set, such as TLG00001.")
        .takes("NAME")
        .shows_default("all logs");
    add_drive_options(command, drive_);
    for (const char* option : {"--repeat", "--engine", "--mesh"})
      command.remove_option(option);  // amounts do not depend on these
    add_rate_options(command);
    add_wind_options(command);
    command.begin_group("Output");
    add_output_option(command, output_, "Write the map to this GeoTIFF (.tif).");
    add_picture_option(command, picture_, "Draw the map to this .png, .svg or .pdf.");
    command.add_option("--cell", settings_.cell_m, "Side of a cell of the map, in metres.")
        .takes("M")
        .in_range(0.01, 1000.0)
        .shows_default();
    add_report_options(command, json_, "Print one JSON object instead of the table.", quiet_);
    command.begin_group("Run");
    add_threads_option(command, settings_.evaluate.threads);
    command.footer(kDoseExample);
    return command;
  }

  int run() override {
    if (input_.empty()) throw bad_input("name a log, or a coverage file of tramline evaluate -o");
    const std::vector<std::string> inputs{input_, field_.file, pattern_file_};
    require_writable(output_, "--output", {".tif", ".tiff"}, inputs);
    require_writable(picture_, "--picture", {".png", ".svg", ".pdf"}, inputs);
    const auto start = std::chrono::steady_clock::now();
    const DoseMap map = io::is_coverage_file(input_) ? of_coverage() : of_log();
    if (!output_.empty()) io::write_raster(map, output_);
    if (!picture_.empty()) render::draw_dose(map, picture_);
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    if (json_)
      print_json_line(dose_json(map, seconds));
    else if (!quiet_)
      print_result(dose_table(map, seconds));
    return 0;
  }

 private:
  void add_rate_options(CommandOptions& command) {
    command.begin_group("Rates");
    command
        .add_option("--nominal-rate", settings_.rates.nominal_per_ha,
                    "Amount per hectare where the log has no rate.")
        .takes("RATE")
        .in_range(1e-6, 1e9)
        .shows_default("none: the log needs rates");
    command
        .add_option("--unit", unit_, "Unit of the amounts where the log does not say: l, kg, t, m3 or seeds.")
        .takes("UNIT")
        .one_of({"l", "kg", "t", "m3", "seeds"})
        .shows_default("l");
    command.add_flag("--no-logged-rate", no_logged_,
                     "Use the nominal rate everywhere, whatever the log says.");
    command
        .add_option("--nominal-speed", nominal_kmh_,
                    "For a machine without rate control: the speed in km/h at which it applies the nominal "
                    "rate; more "
                    "is applied when it drives slower.")
        .takes("KMH")
        .in_range(0.1, 100.0)
        .shows_default("none: the rate does not depend on the speed");
    command
        .add_option("--pattern", pattern_file_,
                    "A table of offsets (metres to the left of the machine's middle) and relative rates.")
        .takes("FILE")
        .shows_default("even over the width");
  }

  void add_wind_options(CommandOptions& command) {
    command.begin_group("Drift");
    command
        .add_option(
            "--wind", wind_text_,
            "SPEED,FROM: wind speed in m/s and the direction it blows from in degrees, such as 4,270.")
        .takes("WIND")
        .shows_default("no wind");
    command.add_option("--drift-share", wind_.share, "Share of the spray that drifts.")
        .takes("SHARE")
        .in_range(0.0, 1.0)
        .shows_default();
    command
        .add_option("--nozzle-height", wind_.height_m, "Height from which drifting droplets fall, in metres.")
        .takes("M")
        .in_range(0.01, 20.0)
        .shows_default();
    command.add_option("--fall-speed", wind_.fall_mps, "Speed at which drifting droplets fall, in m/s.")
        .takes("MPS")
        .in_range(0.01, 20.0)
        .shows_default();
    command
        .add_option("--drift-spread", wind_.spread,
                    "Standard deviation of where the drifting droplets land, as a share of the distance that "
                    "the wind carries them.")
        .takes("SHARE")
        .in_range(0.0, 2.0)
        .shows_default();
  }

  coverage::DoseSettings settings() const {
    coverage::DoseSettings out = settings_;
    apply(drive_, out.evaluate);
    out.rates.use_logged = !no_logged_;
    if (!std::isnan(nominal_kmh_)) {
      if (std::isnan(out.rates.nominal_per_ha)) throw bad_input("--nominal-speed needs --nominal-rate");
      out.rates.nominal_speed_mps = nominal_kmh_ * kKmh;
    }
    if (!wind_text_.empty()) out.wind = wind_of(wind_text_, wind_);
    if (!pattern_file_.empty()) {
      out.pattern = io::read_pattern(pattern_file_);
      out.pattern_place = fmt::format("pattern '{}'", pattern_file_);
    }
    return out;
  }

  DoseMap of_coverage() const {
    if (!field_.file.empty())
      throw bad_input("--field goes with a log; a coverage file holds its field already");
    if (!pattern_file_.empty() || !std::isnan(nominal_kmh_))
      throw bad_input(
          "--pattern and --nominal-speed go with a log; a coverage file does not say how it was driven");
    DoseMap out = coverage::dose(io::read_coverage(input_), settings());
    out.unit = unit_.empty() ? "l" : unit_;
    out.warnings.emplace_back(
        "computed from regions: the nominal rate is applied as often as land was worked; speed and pattern "
        "are unknown");
    return out;
  }

  /// A log that does not say what it counts is not taken to count litres.
  void tell_unknown_unit(DoseMap& map) const {
    if (unit_.empty()) map.unit = "units";
    map.warnings.push_back(unit_.empty()
                               ? "the log does not say what its rates count: name it with --unit"
                               : fmt::format("the logged rates have no unit: taken as {} a hectare", unit_));
  }

  DoseMap of_log() const {
    const coverage::DoseSettings chosen = settings();
    WorkLog log = io::read_log(input_, drive_.log);
    const std::string folder = input_.substr(0, input_.find_last_of('/') + 1);
    if (log.name.starts_with(folder)) log.name.erase(0, folder.size());
    const std::string logged_unit = name(log.rate_unit);
    if (!logged_unit.empty() && !unit_.empty() && unit_ != logged_unit)
      throw bad_input(fmt::format("--unit {}: the rates in {} are in {}", unit_, log.name, logged_unit));
    WorkGround ground;
    if (const std::optional<WorkGround> field = work_ground(field_)) ground = *field;
    ProgressLine progress(quiet_);
    const std::string what = "laying " + log.name;
    DoseMap out = coverage::dose(
        placed_on(std::move(log), ground), ground.ground, chosen, [&](std::size_t done, std::size_t total) {
          progress.show(what, static_cast<int>(done), static_cast<int>(total), "fixes");
        });
    out.field_id = ground.field_id;
    out.field = ground.ground;
    out.frame = ground.frame;
    out.unit = !logged_unit.empty() ? logged_unit : unit_.empty() ? "l" : unit_;
    if (logged_unit.empty() && out.logged_amount > 0) tell_unknown_unit(out);
    return out;
  }

  FieldOptions field_;
  DriveOptions drive_;
  coverage::DoseSettings settings_;
  coverage::WindSettings wind_;
  std::string input_, pattern_file_, output_, picture_, unit_, wind_text_;
  double nominal_kmh_ = std::numeric_limits<double>::quiet_NaN();
  bool no_logged_ = false, json_ = false, quiet_ = false;
};

}  // namespace

std::unique_ptr<Command> make_dose_command() { return std::make_unique<DoseCommand>(); }

}  // namespace tramline::app
