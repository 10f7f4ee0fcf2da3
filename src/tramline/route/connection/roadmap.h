#pragma once
// Lines that a machine can follow from one part of a field to another.

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/steered_path.h"

namespace tramline {

/// A line to follow: a headland pass, a line beside a boundary that has none, or a track.
struct FollowedLine {
  SteeredPath axle;     ///< forward
  bool closed = false;  ///< ends in the pose in which it begins
  bool track = false;   ///< left at its ends only
};

/// A pose on a line, in one of its two senses.
struct RoadmapPose {
  Pose pose;
  Point ahead{};                      ///< the unit vector of its heading
  std::size_t line = 0;               ///< number of the line in this sense
  std::optional<std::size_t> next{};  ///< the pose that follows along the line
  SteeredPath to_next{};              ///< the way there
  bool track = false;
};

/// Poses `spacing_m` apart or less on every line, both ways; of tracks those at the ends. Built once, and
/// safe to read from any number of threads. O(n log n) for n poses. Precondition: spacing_m > 0; lines have a
/// length.
class Roadmap {
 public:
  Roadmap(const std::vector<FollowedLine>& lines, double spacing_m);

  const std::vector<RoadmapPose>& poses() const { return poses_; }

  /// Calls `visit(index)` for every pose within `reach_m` of a point in x and in y.
  template <class Visit>
  void each_near(Point p, double reach_m, Visit visit) const {
    grid_.each_meeting({p.x - reach_m, p.y - reach_m, p.x + reach_m, p.y + reach_m}, visit);
  }

 private:
  void add(const FollowedLine& line, const SteeredPath& axle, std::size_t number, double spacing_m);

  std::vector<RoadmapPose> poses_;
  BoxGrid grid_;
};

}  // namespace tramline
