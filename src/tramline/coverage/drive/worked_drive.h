#pragma once
// The evaluation of a drive from fixes to areas and regions, common to batches and live streams.

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

/// A repaired log in order of time, with the values that follow only from the whole log.
struct PreparedLog {
  WorkLog log;
  DriveSettings drive;  ///< with unknown_work determined
  double width_m = 0;   ///< the largest width of the machine at any fix, NaN where nothing is known
  std::vector<std::string> warnings;
};

/// Precondition: local positions. O(n log n).
PreparedLog prepared(WorkLog log, const DriveSettings& drive);

/// The largest width of the machine at any fix, or DriveSettings::width_m; NaN where nothing is known.
/// O(fixes).
double widest_m(const WorkLog& log, const DriveSettings& drive);

/// The note that this number of fixes was out of order of time.
std::string note_on_disorder(std::size_t fixes);

/// The largest number of sections of any boom; 1 without booms.
std::size_t most_sections(const std::vector<Boom>& booms);
/// The distance between the outermost ends of a boom's sections, m; 0 for one without sections.
double span_m(const Boom& boom);

/// A drive under evaluation. EvaluateSettings::shapes and repeat have the meaning of evaluate(). Fixes have
/// to be prepared.
class WorkedDrive {
 public:
  /// `drive`: that of the prepared log. `width_m`, `sections`: approximate width and number of sections of
  /// the machine, used only for the size of tiles.
  WorkedDrive(const Region& field, const EvaluateSettings& settings, const DriveSettings& drive,
              double width_m, std::size_t sections);

  /// The step that ends at the fix; nullopt where nothing was worked. O(quads).
  std::optional<WorkedStep> add(const Fix& fix, const std::vector<Boom>& booms);
  /// Adds work that follows all fixes, in runs of its own. Its duration is not known, and so the time at work
  /// is unknown afterwards. O(quads).
  void add(const FurtherWork& further);
  CoverageAreas areas() const { return engine_->areas(); }
  const Engine& engine() const { return *engine_; }
  /// The middle of the working sections at the last fix, and the machine's heading there; nullopt: not known.
  Point position() const { return steps_.position(); }
  std::optional<Heading> heading() const { return steps_.heading(); }
  double worked_s() const { return steps_.worked_s(); }  ///< time at work in the log; 0 without times
  /// The driven lines so far. O(fixes).
  std::vector<DrivenLine> lines() const { return lines_.lines(); }
  /// The motion at the last fix; nullopt: not known.
  std::optional<Motion> motion() const { return motion_.motion(); }

  /// Adds runs, time at work, lines, areas and warnings to `out`. `clock`: that of the log.
  void add_figures(Coverage& out, Clock clock) const;
  /// Adds missed land, gaps and, where asked for, shapes. O(regions).
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

/// The areas of an engine with repeated land counted by the rule. By kStrict slivers are repeated land and
/// nothing else: every square metre is in one of the two figures at most.
CoverageAreas reported(CoverageAreas areas, RepeatRule repeat);
/// Adds the regions of the engine to `out`, whatever its steps came from. O(regions).
void add_regions(Coverage& out, const Engine& engine, const EvaluateSettings& settings);

}  // namespace tramline::coverage
