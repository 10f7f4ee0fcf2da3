#include "tramline/coverage/evaluate.h"

#include <fmt/format.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "tramline/coverage/driven_lines.h"
#include "tramline/coverage/gaps.h"
#include "tramline/coverage/plausible.h"
#include "tramline/coverage/time_order.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

/// How often progress is told, in fixes.
constexpr std::size_t kProgressEvery = 1000;

double span_m(const Boom& boom) {
  double left_m = -std::numeric_limits<double>::infinity();
  double right_m = std::numeric_limits<double>::infinity();
  for (const Section& section : boom) {
    left_m = std::max(left_m, section.left_m);
    right_m = std::min(right_m, section.right_m);
  }
  return std::max(0.0, left_m - right_m);
}

/// The widest the machine was at any fix, NaN where nothing is known.
double width_of(const WorkLog& log, const DriveSettings& drive) {
  double width_m = drive.width_m;
  for (const Fix& fix : log.fixes)
    if (fix.boom >= 0) width_m = std::fmax(width_m, span_m(log.booms[static_cast<std::size_t>(fix.boom)]));
  return width_m;
}

double require_width(const WorkLog& log, const DriveSettings& drive) {
  const double width_m = width_of(log, drive);
  if (std::isnan(width_m) || width_m <= 0)
    throw bad_input(log.name + " does not say how wide the machine worked: give --width");
  return width_m;
}

std::size_t most_sections(const WorkLog& log) {
  std::size_t most = 1;
  for (const Boom& boom : log.booms) most = std::max(most, boom.size());
  return most;
}

std::vector<std::string> notes_on(const Breaks& breaks, const DriveSettings& drive) {
  std::vector<std::string> out;
  if (breaks.gaps > 0)
    out.push_back(
        fmt::format("nothing is worked over {} gaps of more than {:g} s", breaks.gaps, drive.max_gap_s));
  if (breaks.jumps > 0)
    out.push_back(
        fmt::format("nothing is worked over {} jumps of more than {:g} m", breaks.jumps, drive.max_step_m));
  if (breaks.without_width > 0)
    out.push_back(
        fmt::format("{} fixes do not say how wide the machine is: nothing is worked there without --width",
                    breaks.without_width));
  return out;
}

/// Keeps slices as they come due.
class Slices {
 public:
  Slices(std::size_t every, const Engine& engine) : every_(every), engine_(engine) {}

  void add(std::size_t fixes, bool last, double seconds) {
    if (every_ == 0 || (fixes % every_ != 0 && !last)) return;
    CoverageSlice slice;
    const auto start = std::chrono::steady_clock::now();
    for (const Polygon& polygon : engine_.region(Ground::kCovered))
      slice.covered_rings += 1 + polygon.holes.size();
    const Region missed = engine_.region(Ground::kMissed);
    slice.missed_regions = static_cast<std::size_t>(std::count_if(
        missed.begin(), missed.end(), [](const Polygon& p) { return area(p) >= kLeastGap_m2; }));
    regions_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slice.fixes = fixes;
    slice.areas = engine_.areas();
    slice.seconds = seconds + regions_s_;
    slices_.push_back(slice);
  }
  double regions_s() const { return regions_s_; }
  std::vector<CoverageSlice> slices() const { return slices_; }

 private:
  std::size_t every_;
  const Engine& engine_;
  double regions_s_ = 0;
  std::vector<CoverageSlice> slices_;
};

/// Slivers as repeated ground, as S3 has it.
void count_slivers(CoverageAreas& areas) { areas.repeated_m2 = areas.worked_twice_m2(); }

void add_further(const FurtherWork& further, Engine& engine, Coverage& out) {
  const int first = out.runs;
  for (WorkedStep step : further.steps) {
    step.run += first;
    out.runs = std::max(out.runs, step.run + 1);
    engine.add(step);
  }
  constexpr double kNever = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < further.lines.size(); ++i)
    out.lines.push_back({first + static_cast<int>(i), further.lines[i], kNever, kNever});
}

void add_shapes(Coverage& coverage, const Engine& engine, bool strict) {
  coverage.covered = engine.region(Ground::kCovered);
  coverage.repeated = engine.region(strict ? Ground::kAgain : Ground::kRepeated);
  coverage.worked_times = {Region{}, engine.region(Ground::kOnce), engine.region(Ground::kTwice),
                           engine.region(Ground::kOften)};
}

void add_ground(Coverage& coverage, const Engine& engine, const EvaluateSettings& settings) {
  coverage.areas = engine.areas();
  coverage.missed = engine.region(Ground::kMissed);
  coverage.gaps = gaps_of(coverage.missed);
  if (settings.shapes) add_shapes(coverage, engine, settings.strict);
  if (!settings.strict) return;
  count_slivers(coverage.areas);
  for (CoverageSlice& slice : coverage.slices) count_slivers(slice.areas);
}

/// Regions are put together by as many threads; 0: by all there are.
std::optional<tbb::global_control> thread_limit(int threads) {
  if (threads <= 0) return std::nullopt;
  return std::optional<tbb::global_control>(std::in_place, tbb::global_control::max_allowed_parallelism,
                                            static_cast<std::size_t>(threads));
}

}  // namespace

Coverage evaluate(WorkLog given, const Region& field, const EvaluateSettings& settings,
                  const FixProgress& progress, const FurtherWork& further) {
  if (given.fixes.size() < 2)
    throw bad_input(fmt::format("{} has {} with a position: no ground is worked without two", given.name,
                                given.fixes.empty() ? "no fix" : "one fix"));
  const auto limit = thread_limit(settings.threads);
  Coverage out;
  WorkLog log = plausible(std::move(given));
  out.warnings = log.notes;
  if (const std::size_t disorder = out_of_order(log); disorder > 0) {
    log = in_time_order(std::move(log));
    out.warnings.push_back(fmt::format(
        "{} of the fixes are earlier than the one before: all were put in order of time", disorder));
  }

  DriveSettings drive = settings.drive;
  drive.unknown_works = !says_work(log);
  out.width_m = require_width(log, drive);
  const std::unique_ptr<Engine> engine =
      make_engine(settings.engine, field, out.width_m, most_sections(log), settings.mesh_m);
  StepMaker steps(drive);
  DrivenLines lines;
  Slices slices(settings.slice, *engine);
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < log.fixes.size(); ++i) {
    const std::optional<WorkedStep> step = steps.add(log.fixes[i], log.booms);
    if (step) engine->add(*step);
    lines.add(log.fixes[i], steps.place(), steps.joined(), step);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    slices.add(i + 1, i + 1 == log.fixes.size(), spent.count() - slices.regions_s());
    if (progress && i % kProgressEvery == 0) progress(i, log.fixes.size());
  }

  out.log = log.name;
  out.engine = name(settings.engine);
  out.fixes_used = log.fixes.size();
  out.fixes = out.fixes_used + log.skipped.count;
  out.skipped = log.skipped;
  out.runs = steps.runs();
  out.worked_s = log.clock == Clock::kNone ? std::numeric_limits<double>::quiet_NaN() : steps.worked_s();
  out.lines = lines.lines();
  out.slices = slices.slices();
  add_further(further, *engine, out);
  log.fixes = std::vector<Fix>();  // regions need the memory
  add_ground(out, *engine, settings);
  for (std::string& note : notes_on(steps.breaks(), drive)) out.warnings.push_back(std::move(note));
  return out;
}

Coverage evaluate(const std::vector<WorkedStep>& steps, double width_m, const Region& field,
                  const EvaluateSettings& settings) {
  const auto limit = thread_limit(settings.threads);
  Coverage out;
  const std::unique_ptr<Engine> engine = make_engine(settings.engine, field, width_m, 1, settings.mesh_m);
  for (const WorkedStep& step : steps) {
    engine->add(step);
    out.runs = std::max(out.runs, step.run + 1);
  }
  out.width_m = width_m;
  out.engine = name(settings.engine);
  out.worked_s = std::numeric_limits<double>::quiet_NaN();
  add_ground(out, *engine, settings);
  return out;
}

}  // namespace tramline::coverage
