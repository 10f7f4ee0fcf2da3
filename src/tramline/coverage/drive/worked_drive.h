#pragma once
// A drive as it is worked: fixes in, areas and regions out. What a batch and a live stream have in common.

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "tramline/coverage/drive/driven_lines.h"
#include "tramline/coverage/drive/motion.h"
#include "tramline/coverage/drive/step_maker.h"
#include "tramline/coverage/engine.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/model/coverage.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// A log as it is driven: mended, in order of time, with what only the whole of it tells.
struct PreparedLog {
  WorkLog log;
  DriveSettings drive;  ///< with unknown_work
  double width_m = 0;   ///< the widest the machine was anywhere, NaN where nothing is known
  std::vector<std::string> warnings;
};

/// Precondition: local positions. O(n log n).
PreparedLog prepared(WorkLog log, const DriveSettings& drive);

/// The widest the machine is at any fix, or DriveSettings::width_m; NaN where nothing is known. O(fixes).
double widest_m(const WorkLog& log, const DriveSettings& drive);

/// That so many fixes were late.
std::string note_on_disorder(std::size_t fixes);

/// Of the boom that has most; 1 without any.
std::size_t most_sections(const std::vector<Boom>& booms);
/// Widest of a boom's places, m; 0 for one without sections.
double span_m(const Boom& boom);

/// EvaluateSettings::shapes and repeat as in evaluate.h. Fixes come prepared.
class WorkedDrive {
 public:
  /// `drive`: of the prepared log. `sections`: as many as the machine has, about; both only for the size of
  /// tiles.
  WorkedDrive(const Region& field, const EvaluateSettings& settings, const DriveSettings& drive,
              double width_m, std::size_t sections);

  /// The step that ends at the fix; nullopt where nothing was worked. O(quads).
  std::optional<WorkedStep> add(const Fix& fix, const std::vector<Boom>& booms);
  /// Work that follows all fixes, in runs of its own. How long it takes is not known, nor is then the time at
  /// work. O(quads).
  void add(const FurtherWork& further);
  CoverageAreas areas() const { return engine_->areas(); }
  const Engine& engine() const { return *engine_; }
  /// Where the middle of what works was at the last fix, and the machine's heading there; nullopt: not known.
  Point place() const { return steps_.place(); }
  std::optional<Heading> heading() const { return steps_.heading(); }
  double worked_s() const { return steps_.worked_s(); }  ///< of the log; 0 without times
  /// The way so far. O(fixes).
  std::vector<DrivenLine> lines() const { return lines_.lines(); }
  /// At the last fix; nullopt: not known.
  std::optional<Motion> motion() const { return motion_.motion(); }

  /// Runs, time at work, lines, areas and warnings, added to `out`. `clock`: of the log.
  void add_figures(Coverage& out, Clock clock) const;
  /// Missed ground, gaps and, where asked for, shapes. O(regions).
  void add_regions(Coverage& out) const;

 private:
  EvaluateSettings settings_;
  DriveSettings drive_;
  std::unique_ptr<Engine> engine_;
  StepMaker steps_;
  DrivenLines lines_;
  MotionTrack motion_;
  int further_runs_ = 0;
  std::vector<DrivenLine> further_lines_;
};

/// Areas, with what counts as repeated by the rule.
CoverageAreas reported(CoverageAreas areas, RepeatRule repeat);
/// The regions of `out`, whatever steps the engine got. O(regions).
void add_regions(Coverage& out, const Engine& engine, const EvaluateSettings& settings);

}  // namespace tramline::coverage
