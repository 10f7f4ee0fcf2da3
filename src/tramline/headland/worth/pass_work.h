#pragma once
// The land that passes work for the first time, and again.

#include <vector>

#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/headland/headland.h"

namespace tramline {

/// Ground that passes are there to work.
struct GroundToWork {
  const Region& ground;
  const Region& passable;  ///< land where the work is interrupted: driving there costs nothing
  double width_m = 0;
};

/// Whether the path ends where it begins.
bool is_closed(const Path& path);

/// The swaths of passes, by segment.
class Swaths {
 public:
  explicit Swaths(double width_m) : width_m_(width_m) {}

  void add(const Path& path);
  /// Those that reach into the window, as covered land. O(segments / 32 + those of sections near it).
  void append_near(const Box& window, RisingCurves& out) const;

 private:
  double width_m_;
  Path segments_;
  std::vector<Box> boxes_;
  std::vector<Box> sections_;  ///< each round the boxes of so many segments that follow one another
};

Swaths swaths_of(const std::vector<HeadlandPass>& passes, double width_m);

/// The area that a path works.
struct PassWork {
  double worked_m2 = 0;  ///< without passable land
  double fresh_m2 = 0;   ///< of the ground, for the first time

  double in_vain_m2() const { return worked_m2 - fresh_m2; }
};

/// What the path works where the swaths have worked already. O(m + n·log n) for m segments of swaths and n
/// corners of the ground.
PassWork work_of(const Path& path, const GroundToWork& to_work, const Swaths& covered);

}  // namespace tramline
