#pragma once
// What a plan costs. Of its tracks alone: S = λo·o + λu·u + λt·t + λs·stops + λd·(subfields − 1), which with
// the last two prices at 0 is the cost of Versleijen (2019), eq. 1. Of its whole route: hours, litres and
// euros.

#include "tramline/model/machine.h"

namespace tramline {

struct Plan;
struct Tally;

/// Prices per m² of overlap, per m² uncovered, per turn, per stop, and per subfield after the first. In euros
/// by default; docs/prices.md says what each stands for.
struct Objective {
  double overlap = 0.02;
  double uncovered = 0.10;
  double turn = 1.00;
  double stop = 5;
  double subfield = 5;

  friend bool operator==(const Objective& a, const Objective& b) = default;
};

/// The scenarios of Versleijen table 2: the named quantity weighs 99999, the other two 1; stops and subfields
/// weigh 0, because Versleijen has no price for them.
enum class Scenario { kOverlap, kUncovered, kTurns };
Objective weights_of(Scenario scenario);

/// Cost of a tally under an objective, in the objective's unit.
double cost(const Objective& objective, const Tally& tally);

/// The share of the working width at which running on past a soft edge stops paying:
/// λo/(λo+λu), ½ when both are 0 (glossary: end rule `cheapest`).
double cheapest_share(const Objective& objective);

/// What it takes to drive the whole route of a plan and what the plan does to the land, priced by the rates
/// of its machine (docs/prices.md).
struct WholeCost {
  // Seconds. Changes of gear count where they happen, backing out as turning.
  double working_s = 0;
  double headland_s = 0;
  double turning_s = 0;
  double transit_s = 0;
  double fuel_l = 0;
  // Euros.
  double hours = 0;        ///< of machine and driver
  double fuel = 0;         ///< all litres
  double overlap = 0;      ///< input on land worked twice
  double missed = 0;       ///< margin of land not worked
  double stops = 0;        ///< backing out of ends without a way off, besides its time
  double driven_over = 0;  ///< margin of standing crop under the wheels of ways with the work off
  /// Legs without room, which cannot be driven as they are planned: kPriceWithoutRoom each.
  double without_room = 0;
  /// Land worked per hour, of what the machine would work at working speed over its whole width without ever
  /// turning: the field efficiency of ASABE S495.
  double field_efficiency = 0;

  double time_s() const { return working_s + headland_s + turning_s + transit_s; }
  double not_working_s() const { return turning_s + transit_s; }
  /// Sums of two jobs. Their field efficiency follows from land, which is not known here: it stays.
  WholeCost& operator+=(const WholeCost& other);

  double euros() const { return hours + fuel + overlap + missed + stops + driven_over + without_room; }
};

/// What a leg without room counts in the whole cost, €: half an hour of a usual machine, for what the driver
/// has to think of there.
inline constexpr double kPriceWithoutRoom = 50;

/// The whole cost as a plan file states it, and the rates it was counted by, which are all given.
struct StatedCost {
  Rates rates;
  double hours_h = 0;
  double litres = 0;
  double euros = 0;
};

/// Of a plan that has a route. O(n) for n legs.
WholeCost whole_cost(const Plan& plan);

}  // namespace tramline
