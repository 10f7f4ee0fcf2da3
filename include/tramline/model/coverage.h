#pragma once
// The result of an evaluation: what was worked of a field, as areas and regions.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/local_frame.h"
#include "tramline/model/work_log.h"

namespace tramline {

/// The highest count of how often land was worked: 0, 1, 2, 3 and more.
inline constexpr int kMostCounted = 3;

/// Areas worked so far, m². Without a field everything lies outside, and nothing is missed.
/// repeated: land worked again that had been worked before and that no quad of the same run within the last w
/// of travel covers. sliver: land worked at least twice without being repeated in this sense, such as the
/// inside of curves. repeated + sliver = land worked at least twice, which Zhang counts as repeated: by that
/// rule (RepeatRule::kStrict) all of it is repeated_m2, and sliver_m2 is 0. In either, land counts once
/// however often it was worked.
struct CoverageAreas {
  double gross_m2 = 0;           ///< Σ areas of the quads
  double covered_m2 = 0;         ///< worked once or more
  double covered_inside_m2 = 0;  ///< the part of covered_m2 within the field
  double outside_m2 = 0;         ///< the part of covered_m2 outside the field
  double repeated_m2 = 0;
  double sliver_m2 = 0;
  double missed_m2 = 0;  ///< field − covered − not recorded
  /// Land that was not covered, but that the machine may have worked while the log has no fixes: within the
  /// field or, without a field, anywhere. covered inside + missed + not recorded = field.
  double not_recorded_m2 = 0;
  /// Land worked exactly once [1], twice [2], three times or more [3]; [0]: the field less what was covered,
  /// that is missed and not recorded. Exact in every engine that counts; NaN where it was not asked for.
  std::array<double, kMostCounted + 1> worked_times_m2{};

  double worked_twice_m2() const { return repeated_m2 + sliver_m2; }
};

/// The classes of land that an evaluation tells apart.
enum class LandClass {
  kCovered,
  kRepeated,
  kSliver,
  kMissed,
  kUnrecorded,  ///< not covered, but the machine may have worked it while the log has no fixes
  kOutside,     ///< covered outside the field
  kOnce,        ///< worked exactly once
  kTwice,       ///< exactly twice
  kOften,       ///< three times or more
  kAgain,       ///< twice or more: repeated land and slivers
};

/// A stretch of the drive: the positions of the working implement, in order.
struct DrivenLine {
  int run = -1;  ///< number of the working run; -1: driven without working
  std::vector<Point> line;
  double from_s = 0;  ///< first time by the log's clock; NaN without times
  double to_s = 0;
};

/// One piece of missed land.
struct Gap {
  int number = 0;  ///< from 1, the largest first
  Polygon shape;
  double area_m2 = 0;
  Point centre;         ///< within the shape
  double widest_m = 0;  ///< diameter of the largest disc within it; NaN: not measured
};

/// The meshes that the boundaries of a region run through: outer ones and those of holes (Zhang table 2).
struct MeshCount {
  std::size_t now = 0;
  std::size_t most = 0;  ///< the largest number after any step so far, and before the first
};

/// What only an engine of meshes has.
struct Meshes {
  double side_m = 0;  ///< of a square mesh
  MeshCount covered;
  MeshCount missed;  ///< 0 without a field
};

/// Headings of a log that contradict the way driven. A step here is a stretch of the way long and fast enough
/// for its direction to be known; it is off where that is more than 45° from the heading at its end, and from
/// the opposite.
struct HeadingContradiction {
  std::string read_as;         ///< compass or math: how the headings were read
  std::size_t steps = 0;       ///< compared
  std::size_t off = 0;         ///< of these
  std::string better;          ///< math, compass or from-track: what fits the way driven
  std::size_t better_off = 0;  ///< steps that are off when headings are read so
  std::size_t record = 0;      ///< of the first fix whose heading is off: its position in the file, from 1
  double time_s = 0;           ///< by the log's clock; NaN without times
  Point at;                    ///< local metres

  double share() const { return static_cast<double>(off) / static_cast<double>(steps); }
};

/// The state of the work after a number of fixes (Zhang tables 2 and 3).
struct CoverageSlice {
  std::size_t fixes = 0;
  CoverageAreas areas;
  std::size_t covered_rings = 0;   ///< boundaries of the covered region
  std::size_t missed_regions = 0;  ///< polygons of the missed region
  std::optional<Meshes> meshes;    ///< only with an engine of meshes
  double seconds = 0;              ///< computing time for areas and regions up to here
};

/// The outcome of an evaluation. Frame: local metres.
struct Coverage {
  std::string log;  ///< name of the log
  std::string field_id;
  Region field;  ///< less its obstacles; empty: evaluated without a field
  LocalFrame frame;
  double width_m = 0;  ///< working width as given, or the widest that worked
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
  std::optional<Meshes> meshes;                  ///< only with an engine of meshes
  std::optional<HeadingContradiction> headings;  ///< only where they contradict the way driven
  SkippedRecords skipped;
  std::vector<std::string> warnings;
};

}  // namespace tramline
