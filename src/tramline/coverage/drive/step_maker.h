#pragma once
// Makes steps of work from the fixes of a log (Zhang §2.1).

#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/course.h"
#include "tramline/coverage/drive/heading_check.h"
#include "tramline/coverage/drive/log_hole.h"
#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/model/work_log.h"

namespace tramline::coverage {

/// How often fixes, at least one of them at work, were not joined, by reason.
struct Breaks {
  std::size_t gaps = 0;           ///< longer than max_gap_s
  std::size_t jumps = 0;          ///< longer than max_step_m
  std::size_t backwards = 0;      ///< backwards in time
  std::size_t without_width = 0;  ///< at work, and no width known
  std::size_t holes = 0;          ///< those of the gaps and jumps over which the machine may have worked
};

/// Joins fixes to steps, one after the other, as a live stream requires. O(sections) a fix.
/// Headings are read as DriveSettings::headings says; a fix without one gets that of its course (course.h).
/// Fixes are not joined if they belong to different units, lie too far apart in time or position, or go
/// backwards in time. The work of a unit is one run until it stops, or until two fixes are not joined. Where
/// a step is too short to have a direction, its beginning is kept for the next one, so that slow work is not
/// lost. Between fixes at work that lie too far apart in time or position, land counts as not recorded where
/// the machine may have driven straight (log_hole.h).
class StepMaker {
 public:
  explicit StepMaker(const DriveSettings& settings) : settings_(settings) {}

  /// The step that ends at this fix; nullopt where nothing was worked. `booms`: those of the fix's log.
  /// Precondition: position local and finite.
  std::optional<WorkedStep> add(const Fix& fix, const std::vector<Boom>& booms);

  /// The land found by the last fix to be not recorded: the strips of holes in the log, usually none. A hole
  /// may lie before an earlier fix, if the heading at its end has become known only now.
  const std::vector<Quad>& unrecorded() const { return unrecorded_; }

  /// Whether the last fix is joined to the previous one of its unit.
  Continuity continuity() const { return continuity_; }
  /// The middle of the working sections at the last fix; the antenna as long as no heading is known.
  Point position() const { return position_; }
  /// The machine's heading at the last fix; nullopt: not known.
  std::optional<Heading> heading() const { return heading_; }
  const Breaks& breaks() const { return breaks_; }
  const HeadingCheck& heading_check() const { return heading_check_; }
  int runs() const { return runs_; }             ///< number of runs begun so far
  double worked_s() const { return worked_s_; }  ///< time of the steps that worked, of all units together
  double worked_m() const { return worked_m_; }  ///< and their length

 private:
  /// One end of a step.
  struct End {
    double time_s = 0;
    Point antenna;
    std::optional<Heading> heading;
    Boom working;
    double rate_per_ha = std::numeric_limits<double>::quiet_NaN();
    double stood_s = 0;  ///< time at work while standing there
  };
  /// Two fixes that were not joined and are both at work.
  struct Hole {
    End before;
    End after;
  };
  struct Unit {
    std::optional<End> last;
    std::optional<Hole> hole;  ///< a hole after which the heading is not known yet
    UsualSpeed usual;
    Course course;
    int run = -1;  ///< none
    double travel_m = 0;
  };

  Boom working_at(const Fix& fix, const std::vector<Boom>& booms);
  bool joins(const End& from, const End& to);
  void begin_anew(Unit& unit, const End& to);
  void close_hole(Unit& unit);
  Point middle(const End& end, Heading heading) const;
  /// The line across the machine at one end of a step.
  struct Bar {
    Point middle;
    Point left;  ///< unit vector

    Point at(double offset_m) const { return middle + offset_m * left; }
  };
  struct Bars {
    Bar rear;
    Bar front;
  };
  Bars bars(const End& from, const End& to) const;
  std::optional<WorkedStep> step(Unit& unit, const End& to);

  DriveSettings settings_;
  std::map<int, Unit> units_;
  Breaks breaks_;
  HeadingCheck heading_check_;
  std::size_t fixes_ = 0;
  Continuity continuity_ = Continuity::kBroken;
  std::vector<Quad> unrecorded_;
  Point position_;
  std::optional<Heading> heading_;
  int runs_ = 0;
  double worked_s_ = 0;
  double worked_until_s_ = -std::numeric_limits<double>::infinity();
  double worked_m_ = 0;
};

/// Whether any fix of the log says that it works or that it does not.
bool says_work(const WorkLog& log);

}  // namespace tramline::coverage
