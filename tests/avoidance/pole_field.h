#pragma once
// A rectangle with poles, tracks running north, and what plans on it cost by polygon booleans.

#include <gtest/gtest.h>

#include <vector>

#include "support/box_ring.h"
#include "tramline/avoidance/choose_detours.h"

namespace tramline::testing_poles {

using testing_support::box;
/// Regular, with its corners on the circle, the first one due east.
Ring regular(int corners, double radius, Point centre);

/// Strips lie from x = 0 eastwards. Copies refer to themselves, so there are none.
class PoleField {
 public:
  PoleField(Ring outer, std::vector<Ring> poles, const Machine& machine, const Objective& objective,
            const PlanSettings& settings = {}, const std::vector<Ring>& passable = {});
  PoleField(const PoleField&) = delete;
  PoleField& operator=(const PoleField&) = delete;

  AvoidanceTask task(Avoidance avoid = Avoidance::kCheapest) const;
  Avoided plan(Avoidance avoid = Avoidance::kCheapest) const { return choose_detours(task(avoid)); }
  const TrackFamily& family() const { return families_.front(); }
  const ClassifiedGround& ground() const { return ground_; }
  double width_m() const { return machine_.width_m; }
  const Objective& objective() const { return objective_; }
  /// How the detour goes on one side of what makes the gap.
  WayRound way(const Track& strip, std::size_t gap, Passing side) const;

  /// What tracks amount to: swaths united and cut with the body, arcs as chords; pieces and their ends
  /// counted. An end that does not lie on the outer ring's southern or northern edge is a stop.
  Tally by_booleans(const std::vector<LaidPiece>& pieces) const;
  /// By how much such an area may be off, m²: chords lie up to the sagitta off either edge of a band, the
  /// precision grid moves every edge, and gaps begin where an obstacle is a width tolerance wide.
  double area_tolerance(const std::vector<LaidPiece>& pieces) const;
  /// The same of a cost.
  double cost_tolerance(const std::vector<LaidPiece>& pieces) const;

 private:
  Field field_;
  Machine machine_;
  Objective objective_;
  PlanSettings settings_[3];  ///< one for each way of avoiding
  ClassifiedGround ground_;
  std::vector<Subfield> subfields_;
  std::vector<TrackFamily> families_;
  Box reach_;
};

/// Without a least length: every stretch is driven.
Machine machine(double width_m, double radius_m);

/// All ways to drive one strip of a field whose strips are all as long.
struct StripWays {
  std::vector<std::vector<LaidPiece>> ways;
  std::vector<Passing> names;
};
/// Cut, left and right of the one pole in the strip, as far as they are possible.
StripWays rolling_circle_paths(const PoleField& field, const Track& strip);

/// The areas of a plan's tally against those of its own tracks by booleans, its counts against counting.
void expect_own_tally(const PoleField& field, const Avoided& avoided);
/// Detours follow one another and keep off everything hard.
void expect_off_poles(const PoleField& field, const Avoided& avoided);
int detours_in(const Avoided& avoided);

/// A pole in the middle of seven strips of 160 m: far from all edges.
struct Pole {
  double width_m, radius_m;  ///< the machine's
  double across_m;           ///< the pole's extent
  double off_m;              ///< of its centre from the middle of strip 3 of 7
  int corners;
};
Ring field_ring(double width_m);
Ring ring_of(const Pole& pole);
/// From 0.3 m² to twice the width: centred, off centre, on a strip line, and touching a swath's edge
/// from within; widths from 1.5 to 12 m, radii from 0 to 12 m.
std::vector<Pole> poles();
::testing::Message description(const Pole& pole);

}  // namespace tramline::testing_poles
