#pragma once
// What a plan costs: S = λo·o + λu·u + λt·t + λs·stops (S1 eq. 1 with stops added).

namespace tramline {

struct Tally;

/// Weights per m² of overlap, per m² uncovered, per turn and per stop. In euros by default.
struct Objective {
  double overlap = 0.04;
  double uncovered = 0.10;
  double turn = 0.45;
  double stop = 5;
};

/// S1.8: one of the three weighs 99999, the others 1, stops nothing: S1 has no price for them.
enum class Scenario { kOverlap, kUncovered, kTurns };
Objective weights_of(Scenario scenario);

/// Cost of a tally under an objective, in the objective's unit.
double cost(const Objective& objective, const Tally& tally);

/// The share of the working width at which running on past a soft edge stops to pay:
/// λo/(λo+λu), ½ when both are 0 (DESIGN: end rule `cheapest`; ALGORITHMS §0.1 f*).
double cheapest_share(const Objective& objective);

}  // namespace tramline
