#include "tramline/coverage/drive/worked_drive.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

#include "tramline/coverage/drive/log_sanity.h"
#include "tramline/coverage/drive/time_order.h"
#include "tramline/coverage/gaps.h"

namespace tramline::coverage {
namespace {

/// "1 hole", "2 holes".
std::string counted(std::size_t number, const char* what) {
  return fmt::format("{} {}{}", number, what, number == 1 ? "" : "s");
}

std::vector<std::string> notes_on(const Breaks& breaks, const DriveSettings& drive) {
  std::vector<std::string> out;
  if (breaks.gaps > 0)
    out.push_back(fmt::format("no land counts as worked in {} of more than {:g} s in the log",
                              counted(breaks.gaps, "interruption"), drive.max_gap_s));
  if (breaks.jumps > 0)
    out.push_back(fmt::format("no land counts as worked over {} of more than {:g} m in the log",
                              counted(breaks.jumps, "jump"), drive.max_step_m));
  if (breaks.holes > 0)
    out.push_back(fmt::format(
        "the log has {} with the machine at work before and after: land on the straight way between "
        "that nothing else covers counts as not recorded",
        counted(breaks.holes, "hole")));
  if (breaks.without_width > 0)
    out.push_back(
        fmt::format("{} fixes do not say how wide the machine is: nothing is worked there without --width",
                    breaks.without_width));
  return out;
}

void add_shapes(Coverage& coverage, const Engine& engine, RepeatRule repeat) {
  coverage.covered = engine.region(LandClass::kCovered);
  coverage.repeated = engine.region(repeat == RepeatRule::kStrict ? LandClass::kAgain : LandClass::kRepeated);
  coverage.worked_times = {Region{}, engine.region(LandClass::kOnce), engine.region(LandClass::kTwice),
                           engine.region(LandClass::kOften)};
}

}  // namespace

double widest_m(const WorkLog& log, const DriveSettings& drive) {
  double width_m = drive.width_m;
  for (const Fix& fix : log.fixes)
    if (fix.boom >= 0) width_m = std::fmax(width_m, span_m(log.booms[static_cast<std::size_t>(fix.boom)]));
  return width_m;
}

double span_m(const Boom& boom) {
  double left_m = -std::numeric_limits<double>::infinity();
  double right_m = std::numeric_limits<double>::infinity();
  for (const Section& section : boom) {
    left_m = std::max(left_m, section.left_m);
    right_m = std::min(right_m, section.right_m);
  }
  return std::max(0.0, left_m - right_m);
}

std::size_t most_sections(const std::vector<Boom>& booms) {
  std::size_t most = 1;
  for (const Boom& boom : booms) most = std::max(most, boom.size());
  return most;
}

std::string note_on_disorder(std::size_t fixes) {
  return fmt::format("{} of the fixes are earlier than the one before: all were put in order of time", fixes);
}

PreparedLog prepared(WorkLog log, const DriveSettings& drive) {
  PreparedLog out{log_without_faults(std::move(log)), drive, 0, {}};
  out.warnings = out.log.notes;
  if (const std::size_t disorder = out_of_order(out.log); disorder > 0) {
    out.log = in_time_order(std::move(out.log));
    out.warnings.push_back(note_on_disorder(disorder));
  }
  out.drive.unknown_work = says_work(out.log) ? WorkState::kOff : WorkState::kOn;
  out.width_m = widest_m(out.log, drive);
  return out;
}

CoverageAreas reported(CoverageAreas areas, RepeatRule repeat) {
  if (repeat == RepeatRule::kRun) return areas;
  areas.repeated_m2 = areas.worked_twice_m2();
  areas.sliver_m2 = 0;
  return areas;
}

void add_regions(Coverage& out, const Engine& engine, const EvaluateSettings& settings) {
  out.missed = engine.region(LandClass::kMissed);
  out.not_recorded = engine.region(LandClass::kUnrecorded);
  out.gaps = gaps_of(out.missed);
  if (settings.covered && !settings.shapes) out.covered = engine.region(LandClass::kCovered);
  if (settings.shapes) add_shapes(out, engine, settings.repeat);
}

WorkedDrive::WorkedDrive(const Region& field, const EvaluateSettings& settings, const DriveSettings& drive,
                         double width_m, std::size_t sections)
    : settings_(settings),
      drive_(drive),
      engine_(make_engine(settings.engine, field, width_m, sections, settings.mesh_m)),
      steps_(drive) {}

std::optional<WorkedStep> WorkedDrive::add(const Fix& fix, const std::vector<Boom>& booms) {
  std::optional<WorkedStep> step = steps_.add(fix, booms);
  if (step) engine_->add(*step);
  engine_->add_unrecorded(steps_.unrecorded());
  lines_.add(fix, steps_.position(), steps_.continuity(), step);
  motion_.add(fix, steps_.position(), steps_.heading(), steps_.continuity());
  return step;
}

void WorkedDrive::add(const FurtherWork& further) {
  const int first = steps_.runs() + further_runs_;
  for (WorkedStep step : further.steps) {
    further_runs_ = std::max(further_runs_, first - steps_.runs() + step.run + 1);
    step.run += first;
    engine_->add(step);
  }
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < further.lines.size(); ++i)
    further_lines_.push_back({first + static_cast<int>(i), further.lines[i], kNever, kNever});
}

void WorkedDrive::add_figures(Coverage& out, Clock clock) const {
  out.runs = steps_.runs() + further_runs_;
  const bool timed = clock != Clock::kNone && further_runs_ == 0;
  out.worked_s = timed ? steps_.worked_s() : std::numeric_limits<double>::quiet_NaN();
  out.areas = reported(engine_->areas(), settings_.repeat);
  out.meshes = engine_->meshes();
  for (std::string& note : notes_on(steps_.breaks(), drive_)) out.warnings.push_back(std::move(note));
  out.headings = steps_.heading_check().contradiction(drive_.headings);
  if (out.headings) out.warnings.push_back(warning_on(*out.headings, clock));
}

void WorkedDrive::add_regions(Coverage& out) const {
  out.lines = lines_.lines();
  out.lines.insert(out.lines.end(), further_lines_.begin(), further_lines_.end());
  coverage::add_regions(out, *engine_, settings_);
}

}  // namespace tramline::coverage
