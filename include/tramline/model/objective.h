#pragma once
// The cost of a plan: S = λo·o + λu·u + λt·t + λs·stops + λd·(subfields − 1). With the last two prices at 0
// it is the cost of Versleijen (2019), eq. 1.

namespace tramline {

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

}  // namespace tramline
