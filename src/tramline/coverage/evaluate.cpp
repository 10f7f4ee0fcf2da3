#include "tramline/coverage/evaluate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "tramline/coverage/doubts.h"
#include "tramline/coverage/drive/shape_drive.h"
#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/gaps.h"
#include "tramline/coverage/thread_limit.h"
#include "tramline/geometry/error.h"

namespace tramline::coverage {
namespace {

/// The number of fixes between two reports of progress.
constexpr std::size_t kProgressEvery = 1000;

/// Keeps slices as they come due.
class Slices {
 public:
  Slices(std::size_t every, RepeatRule repeat, const Engine& engine)
      : every_(every), repeat_(repeat), engine_(engine) {}

  void add(std::size_t fixes, bool last, double seconds) {
    if (every_ == 0 || (fixes % every_ != 0 && !last)) return;
    CoverageSlice slice;
    const auto start = std::chrono::steady_clock::now();
    for (const Polygon& polygon : engine_.region(LandClass::kCovered))
      slice.covered_rings += 1 + polygon.holes.size();
    const Region missed = engine_.region(LandClass::kMissed);
    slice.missed_regions = static_cast<std::size_t>(std::count_if(
        missed.begin(), missed.end(), [](const Polygon& p) { return area(p) >= kLeastGap_m2; }));
    regions_s_ += std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    slice.fixes = fixes;
    slice.areas = reported(engine_.areas(), repeat_);
    slice.meshes = engine_.meshes();
    slice.seconds = seconds + regions_s_;
    slices_.push_back(slice);
  }
  double regions_s() const { return regions_s_; }
  std::vector<CoverageSlice> slices() const { return slices_; }

 private:
  std::size_t every_;
  RepeatRule repeat_;
  const Engine& engine_;
  double regions_s_ = 0;
  std::vector<CoverageSlice> slices_;
};

void require_ground(const WorkLog& log) {
  if (log.fixes.size() >= 2 || (!log.fixes.empty() && !log.shapes.empty())) return;
  throw bad_input(fmt::format("{} has {} with a position; at least two are needed", log.name,
                              log.fixes.empty() ? "no fix" : "one fix"));
}

/// What comes after the last fix. Takes the log's fixes: regions need the memory.
void finish(Coverage& out, WorkedDrive& drive, WorkLog& log, const EvaluateSettings& settings,
            const FurtherWork& further) {
  out.log = log.name;
  out.engine = name(settings.engine);
  out.fixes_used = log.fixes.size();
  out.fixes = out.fixes_used + log.skipped.count;
  out.skipped = log.skipped;
  out.counters = log.counters;
  const std::vector<std::string> doubts = doubts_on(drive.areas(), log.counters, out.width_m);
  drive.add(further);
  drive.add_figures(out, log.clock);
  out.warnings.insert(out.warnings.end(), doubts.begin(), doubts.end());
  log.fixes = std::vector<Fix>();
  drive.add_regions(out);
}

void require_few_slices(const WorkLog& log, std::size_t slice) {
  const std::size_t fixes = log.fixes.size();
  if (slice == 0 || fixes <= kMostSlices * slice) return;
  throw bad_input(
      fmt::format("{} has {} fixes: a slice after every {} would make {} slices, and the most are {}; "
                  "give --slice {} or more",
                  log.name, fixes, slice, (fixes + slice - 1) / slice, kMostSlices,
                  (fixes + kMostSlices - 1) / kMostSlices));
}

/// Of a log that has its ground as polygons.
Coverage evaluate_shapes(PreparedLog ready, const Region& field, const EvaluateSettings& settings,
                         const StepSink& sink, const FurtherWork& further) {
  const ShapeDrive shapes = shape_drive(ready.log, ready.drive);
  Coverage out;
  out.warnings = std::move(ready.warnings);
  if (settings.slice > 0)
    out.warnings.emplace_back("polygons are evaluated at once: there are no slices of them");
  out.width_m = shapes.width_m;
  WorkedDrive drive(field, settings, ready.drive, out.width_m, 1);
  drive.add(shapes.work);
  if (sink)
    for (const WorkedStep& step : shapes.work.steps) sink(step);
  finish(out, drive, ready.log, settings, further);
  if (further.steps.empty()) out.worked_s = shapes.worked_s;
  return out;
}

}  // namespace

double working_width_m(const WorkLog& log, const DriveSettings& drive) {
  const double width_m = widest_m(log, drive);
  if (!(width_m > 0)) throw bad_input(log.name + " does not say how wide the machine worked: give --width");
  return width_m;
}

Coverage evaluate(WorkLog given, const Region& field, const EvaluateSettings& settings,
                  const FixProgress& progress, const StepSink& sink, const FurtherWork& further) {
  require_ground(given);
  const ThreadLimit limit(settings.threads);
  PreparedLog ready = prepared(std::move(given), settings.drive);
  if (!ready.log.shapes.empty()) return evaluate_shapes(std::move(ready), field, settings, sink, further);
  require_few_slices(ready.log, settings.slice);
  Coverage out;
  WorkLog& log = ready.log;
  out.warnings = ready.warnings;
  out.width_m = working_width_m(log, settings.drive);
  WorkedDrive drive(field, settings, ready.drive, out.width_m, most_sections(log.booms));
  Slices slices(settings.slice, settings.repeat, drive.engine());
  const auto start = std::chrono::steady_clock::now();
  for (std::size_t i = 0; i < log.fixes.size(); ++i) {
    const std::optional<WorkedStep> step = drive.add(log.fixes[i], log.booms);
    if (step && sink) sink(*step);
    const std::chrono::duration<double> spent = std::chrono::steady_clock::now() - start;
    slices.add(i + 1, i + 1 == log.fixes.size(), spent.count() - slices.regions_s());
    if (progress && i % kProgressEvery == 0) progress(i, log.fixes.size());
  }
  out.slices = slices.slices();
  finish(out, drive, log, settings, further);
  return out;
}

Coverage evaluate(const std::vector<WorkedStep>& steps, double width_m, const Region& field,
                  const EvaluateSettings& settings) {
  const ThreadLimit limit(settings.threads);
  Coverage out;
  const std::unique_ptr<Engine> engine = make_engine(settings.engine, field, width_m, 1, settings.mesh_m);
  for (const WorkedStep& step : steps) {
    engine->add(step);
    out.runs = std::max(out.runs, step.run + 1);
  }
  out.width_m = width_m;
  out.engine = name(settings.engine);
  out.worked_s = std::numeric_limits<double>::quiet_NaN();
  out.areas = reported(engine->areas(), settings.repeat);
  out.meshes = engine->meshes();
  add_regions(out, *engine, settings);
  return out;
}

}  // namespace tramline::coverage
