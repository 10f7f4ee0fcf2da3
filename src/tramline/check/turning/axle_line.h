#pragma once
// Where the axle of a machine is while its implement works along a path.

#include <vector>

#include "tramline/geometry/path/path.h"
#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/machine.h"

namespace tramline::check {

/// How far the axle is ahead of the line where the implement works, m; negative: behind it.
double ahead_of_work_m(const Machine& machine);

struct LinePlace {
  Point at;
  Point ahead;  ///< unit vector
};

inline Pose pose_of(const LinePlace& place) { return {place.at, Heading::from_to({0, 0}, place.ahead)}; }
/// The pose straight on from another, m; negative: straight back.
inline Pose moved_on(const Pose& pose, double by_m) {
  return {pose.at + by_m * pose.heading.unit(), pose.heading};
}

enum class PathEnds { kApart, kMeet };

/// A path that goes straight on beyond both ends, or round and round where they meet.
class AxleLine {
 public:
  AxleLine(const Path& path, PathEnds ends);

  double length_m() const { return length_m_; }
  const Path& path() const { return path_; }
  LinePlace place(double at_m) const;
  /// Positions along the path, one for each segment that comes this near to the point.
  std::vector<double> positions_near(Point p, double within_m) const;

 private:
  Path path_;
  std::vector<double> begins_m_;
  double length_m_ = 0;
  PathEnds ends_;
};

/// Places along a steered path, and how far along it they are.
struct CoursePlace {
  double along_m = 0;
  LinePlace place;
};
/// At most `step_m` apart, at the ends of all stretches among them. Stretches are driven from where they say
/// they begin.
std::vector<CoursePlace> course_of(const SteeredPath& path, double step_m);
/// Where the path ends, and its beginning.
LinePlace last_place(const SteeredPath& path);
LinePlace first_place(const SteeredPath& path);

}  // namespace tramline::check
