#pragma once
// What the sides of the land ask of ways between lines: facts of the rule about the bound of a route.

#include <limits>
#include <optional>
#include <vector>

#include "tramline/check/rules/route/route_facts.h"
#include "tramline/geometry/path/steered_path.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// The time of a way that there is not.
inline constexpr double kNever_s = std::numeric_limits<double>::infinity();

/// A side of the convex hull of the land that is too near to where a line ends to turn forward from there.
struct SideAhead {
  Point inwards;      ///< unit vector
  double back_m = 0;  ///< along the line, until it is far enough
};

/// A side that a machine comes parallel to with one of its two headings only: for the other there is no room.
struct SideBeside {
  Point inwards;      ///< unit vector
  Point parallel;     ///< unit vector, that heading
  double back_m = 0;  ///< along the line, until there is room for the other
};

/// Where a way leaves a line or enters it, and the axle's line from there on, along which a machine may back
/// out or in: until it has a kink, is sharper than the machine turns, or is turned by more than 30°.
struct WayEnd {
  Pose at;
  Point off;  ///< unit vector, off the line
  std::optional<WorkedCourse> course{};
  double from_m = 0;  ///< the position of `at` along the course
  double sense = 0;   ///< of backing along it: -1 or +1
  double follows_m = 0;
  double turns = 0;  ///< the greatest sine of the angle between the line and `off`
  std::vector<SideAhead> sides{};
  std::vector<SideBeside> beside{};  ///< of a straight line

  Pose backed(double by_m) const;
};

/// Bounds of ways on the land of a plan, for machines that turn forward only and back along the lines they
/// work.
///
/// A machine that heads for a side at an angle φ to it, and later does not, comes nearer by r (1 − cos φ) at
/// least until it is parallel to it, and has half its outline between it and the side there; parallel the
/// other way, r (1 + cos φ). On land in a band narrower than 2 (r + half the outline) it cannot turn round,
/// because half a turn takes 2 r across; nor does it come back to where it was along the band, since that
/// takes half a turn and another back.
class LandSides {
 public:
  /// nullopt: where land beyond the boundary has no limits, where a machine reverses in turns or tows, and
  /// where a route leaves the land.
  static std::optional<LandSides> of(const Plan& plan);

  WayEnd leaving(const WorkedCourse& course) const;
  WayEnd entering(const WorkedCourse& course) const;

  /// No way from one to the other takes less, s; at least `known_s`, of which that is known. Found to a
  /// thousandth by splitting the distances backed, the most promising first; where it is `enough_s` or more,
  /// to that.
  double least_s(const WayEnd& from, const WayEnd& to, double known_s, double enough_s) const;

 private:
  explicit LandSides(const Plan& plan, double beyond_m);
  struct HullSide {
    Point on;
    Point inwards;
  };
  enum class InBand { kFree, kOnward, kNever };
  WayEnd end_of_line(const WorkedCourse& course, double from_m, double sense, double straight_on_m) const;
  enum class Comes { kEitherWay, kTheFarWay };
  double missing_m(const HullSide& side, const Pose& at, Point off, Comes comes) const;
  double far_enough_m(const HullSide& side, const WayEnd& end, Comes comes) const;
  InBand in_band(const WayEnd& from, const WayEnd& to) const;
  double farther_s(const WayEnd& from, const WayEnd& to) const;
  double along_lines_s(const WayEnd& from, const WayEnd& to, double known_s) const;
  double loops_s(const WayEnd& from, const WayEnd& to, double enough_s) const;

  Turning turning_;
  double radius_m_;
  double half_m_;   ///< of the outline, to the side where it is narrower
  double reach_m_;  ///< of the outline ahead or behind
  std::vector<HullSide> sides_;
  Point band_;         ///< along the narrowest band
  double band_m_ = 0;  ///< how wide that is
};

}  // namespace tramline::check
