#pragma once
// What was worked of a field, as areas and regions.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/work_log.h"

namespace tramline {

/// How often ground was worked is counted up to here: 0, 1, 2, 3 and more.
inline constexpr int kMostCounted = 3;

/// Areas of what was worked so far, m². Without a field everything lies outside, and nothing is missed.
///
/// repeated: ground worked again that had been worked before and that no quad of the same run within the
/// last w of travel covers. sliver: ground worked at least twice, but never repeated so: the inside of
/// curves. repeated + sliver = worked at least twice, what S3 counts as repeated (S3.8).
struct CoverageAreas {
  double gross_m2 = 0;           ///< Σ areas of the quads
  double covered_m2 = 0;         ///< worked once or more
  double covered_inside_m2 = 0;  ///< of that, within the field
  double outside_m2 = 0;         ///< of that, outside it
  double repeated_m2 = 0;
  double sliver_m2 = 0;
  double missed_m2 = 0;  ///< field − covered − not recorded
  /// Ground that was not covered, but that the machine may have worked while the log has no fixes: of the
  /// field, or anywhere where there is none. covered inside + missed + not recorded = field.
  double not_recorded_m2 = 0;
  /// Ground worked exactly 1, 2 times, 3 times or more; [0]: the field less what was covered, that is missed
  /// and not recorded. Exact in every engine that counts; NaN where it was not asked for.
  std::array<double, kMostCounted + 1> worked_times_m2{};

  double worked_twice_m2() const { return repeated_m2 + sliver_m2; }
};

/// What a place may be.
enum class Ground {
  kCovered,
  kRepeated,
  kSliver,
  kMissed,
  kUnrecorded,  ///< not covered, but the machine may have worked it while the log has no fixes
  kOutside,     ///< covered outside the field
  kOnce,        ///< worked exactly once
  kTwice,       ///< exactly twice
  kOften,       ///< three times or more
  kAgain,       ///< twice or more: repeated ground and slivers
};

/// A stretch of the drive: the places of the working implement, in order.
struct DrivenLine {
  int run = -1;  ///< of the work; -1: driven without working
  std::vector<Point> line;
  double from_s = 0;  ///< clock of the log; NaN without times
  double to_s = 0;
};

/// One piece of missed ground.
struct Gap {
  int number = 0;  ///< from 1, the largest first
  Polygon shape;
  double area_m2 = 0;
  Point centre;         ///< within the shape
  double widest_m = 0;  ///< diameter of the largest disc within it; NaN: not measured
};

/// How far the work was after so many fixes (S3's tables 2 and 3).
struct CoverageSlice {
  std::size_t fixes = 0;
  CoverageAreas areas;
  std::size_t covered_rings = 0;   ///< boundaries of the covered region
  std::size_t missed_regions = 0;  ///< polygons of the missed one
  double seconds = 0;              ///< spent on areas and regions up to here
};

/// The outcome of an evaluation. Frame: local metres.
struct Coverage {
  std::string log;  ///< where the drive is from
  std::string field_id;
  Region field;  ///< less its obstacles; empty: evaluated without a field
  LocalFrame frame;
  double width_m = 0;  ///< given for it, or the widest that worked
  std::string engine;

  CoverageAreas areas;
  Region covered;
  Region repeated;
  Region missed;
  Region not_recorded;
  std::array<Region, kMostCounted + 1> worked_times{};  ///< as worked_times_m2; [0] is empty
  std::vector<Gap> gaps;                                ///< the missed region's parts, slivers left out
  std::vector<DrivenLine> lines;
  std::vector<CoverageSlice> slices;

  std::size_t fixes = 0;
  std::size_t fixes_used = 0;
  int runs = 0;
  double worked_s = 0;  ///< NaN without times
  MachineCounters counters;
  SkippedRecords skipped;
  std::vector<std::string> warnings;
};

}  // namespace tramline
