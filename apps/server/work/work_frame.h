#pragma once
// The changes of a drive since the last frame, for a reader that follows it.

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "tramline/coverage/live/work_changes.h"
#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"
#include "tramline/model/coverage.h"
#include "tramline/model/local_frame.h"

namespace tramline::server {

/// Points of a whole path that are closer together than this look like one, m.
inline constexpr double kEye_m = 0.25;
/// Frames are this far apart at least.
inline constexpr std::chrono::milliseconds kFrameEvery{100};

/// The progress of the work.
struct WorkFigures {
  CoverageAreas areas;
  bool has_field = false;
  double worked_s = 0;           ///< NaN: not known
  double present_m2_per_s = 0;   ///< ground gained by the time driven lately; NaN: not known
  std::optional<Meshes> meshes;  ///< only with an engine of meshes
};
/// As `tramline watch` has it; NaN: not known.
double remaining_s(const WorkFigures& figures);

/// Where a drive is after a fix, and what changed since the last frame.
struct WorkFrame {
  LocalFrame plane;         ///< of all places here
  double time_s = 0;        ///< of the fix; NaN: not known
  std::size_t fix = 0;      ///< so many fixes were driven
  std::size_t fixes = 0;    ///< of so many
  std::optional<Point> at;  ///< of what works; nullopt: not known yet
  std::optional<Heading> heading;
  bool working = false;
  std::string quality{};  ///< of the fix, in words (io::FixQuality); empty: not known
  WorkFigures figures;
  std::vector<Point> line;  ///< places after the last frame; with changes.all the whole way
  coverage::WorkChanges changes;
};

/// The state of a feed apart from its work.
struct FeedState {
  std::string message;
  bool connected = false;
};

struct WorkEnd {
  WorkFigures figures;
};

/// Nothing new yet, or one of these.
using WorkEvent = std::variant<std::monostate, WorkFrame, FeedState, WorkEnd>;

/// A path with fewer points: those closer than `apart_m` to the last one kept are left out, except the last.
/// O(n).
std::vector<Point> thinned(const std::vector<Point>& way, double apart_m);
/// All lines joined to one path, in their order.
std::vector<Point> way_of(const std::vector<DrivenLine>& lines);

}  // namespace tramline::server
