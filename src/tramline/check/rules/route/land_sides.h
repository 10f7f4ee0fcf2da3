#pragma once
// What the sides of the land ask of ways between lines: facts of the rule about the bound of a route.

#include <functional>
#include <list>
#include <optional>
#include <vector>

#include "tramline/check/rules/route/backed_ways.h"
#include "tramline/check/rules/route/followed_line.h"
#include "tramline/check/rules/route/way_ends.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// Bounds of ways on the land of a plan, for machines that turn forward only and back along the lines they
/// work.
///
/// A machine that heads for a side at an angle φ to it, and later does not, comes nearer by r (1 − cos φ) at
/// least until it is parallel to it, and has half its outline between it and the side there; parallel the
/// other way, r (1 + cos φ). On land in a band narrower than 2 (r + half the outline) it cannot turn round,
/// because half a turn takes 2 r across; nor does it come back to where it was along the band, since that
/// takes half a turn and another back. Having backed all along a line, and on, it may be unable to come
/// parallel to the side behind it. Then it goes forward to the beginning of another line only where that lies
/// no farther along the side than it gets aslant to it, backing and going forward, and not where it would
/// have to turn away from a side too near to that beginning; else it stops once more. Where that is not
/// enough, the places are followed that it gets to without a stop from either line (ConvexLand): where they
/// are not common, it stops once more, too; and so it stops
/// on its way to a closed pass on which none of them lies. Each stop to back counts besides its time as the
/// plan says.
class LandSides {
 public:
  /// nullopt: where land beyond the boundary has no limits, where a machine reverses in turns or tows, and
  /// where a route leaves the land.
  static std::optional<LandSides> of(const Plan& plan);

  LineEnd leaving(const WorkedCourse& course) const;
  LineEnd entering(const WorkedCourse& course) const;

  /// All round a closed pass.
  std::vector<LineStep> round(const WorkedCourse& pass) const;
  /// Where no way between an end of a line and places of a closed pass does without a stop, what ways take at
  /// least that back along the line, s; else 0. `on_s`: what they take at least from a pose of the line on.
  double with_stop_s(const LineEnd& end, const std::vector<LineStep>& pass,
                     const std::function<double(const Pose&)>& on_s) const;

  /// No way from one to the other takes less, s; at least `known_s`, of which that is known. Found to a
  /// thousandth by splitting the distances backed, the most promising first; where it is `enough_s` or more,
  /// to that.
  double least_s(const LineEnd& from, const LineEnd& to, double known_s, double enough_s) const;

 private:
  explicit LandSides(const Plan& plan, double beyond_m);
  struct HullSide {
    Point on;
    Point inwards;
  };
  enum class InBand { kFree, kOnward, kNever };
  LineEnd end_of_line(const WorkedCourse& course, double from_m, double sense, double straight_on_m) const;
  WayEnd way_end(const WorkedCourse& course, double from_m, double sense, double straight_on_m,
                 Followed followed, double behind_m = 0) const;
  std::vector<WayEnd> behind_bends(const WayEnd& all) const;
  enum class Comes { kEitherWay, kTheFarWay };
  double missing_m(const HullSide& side, const Pose& at, Point off, Comes comes) const;
  double far_enough_m(const HullSide& side, const WayEnd& end, Comes comes) const;
  InBand in_band(const WayEnd& from, const WayEnd& to) const;
  struct MovesOn {
    double flattest = 0;    ///< rad to the side; 0 if it may come parallel to it
    double sideways_m = 0;  ///< along it, at most
  };
  MovesOn moves_on(const HullSide& side, const Pose& at, double works) const;
  bool reached_by_one_stop(const WayEnd& all_along, const WayEnd& other) const;
  /// What a single stop may do: to back out of the one line or into the other, or all along it and on.
  struct SingleStop {
    bool out = true, out_and_on = true, in = true, in_and_on = true;
    int stops = 0;  ///< at least: none from the end of the one line straight to the beginning of the other
  };
  const DrivenPlaces& places_from(const Pose& at, double sense) const;
  SingleStop single_stop(const LineEnd& from, const LineEnd& to) const;
  double farther_s(const WayEnd& from, const WayEnd& to, const SingleStop& may) const;
  double along_lines_s(const WayEnd& from, const WayEnd& to, const SingleStop& may, double known_s) const;
  double way_s(const WayEnd& from, const WayEnd& to, const SingleStop& may, double known_s,
               double enough_s) const;
  double behind_bends_s(const LineEnd& from, const LineEnd& to, int stops, double known_s,
                        double enough_s) const;
  double both_s(const LineEnd& from, const LineEnd& to, const SingleStop& may, double known_s,
                double enough_s) const;

  WayCosts costs_;
  double half_m_;       ///< of the outline, to the side where it is narrower
  double reach_m_ = 0;  ///< of the outline ahead or behind
  double front_m_ = 0;  ///< the corners of its widest part, from the axle
  double rear_m_ = 0;   ///< those behind the axle
  std::vector<HullSide> sides_;
  Point band_;                        ///< along the narrowest band
  double band_m_ = 0;                 ///< how wide that is
  std::optional<ConvexLand> land_{};  ///< of a route with stops
  struct Driven {
    Pose from;
    double sense = 0;
    DrivenPlaces places;
  };
  mutable std::list<Driven> driven_{};  ///< so far
};

}  // namespace tramline::check
