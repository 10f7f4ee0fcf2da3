// What is decided about an isolated pole, against all combinations of ways past it, whose areas polygon
// booleans give and whose pieces and stops are counted.

#include <gtest/gtest.h>

#include "avoidance/pole_field.h"

namespace tramline::best_combination_test {

using namespace testing_poles;

std::vector<LaidPiece> joined(std::vector<LaidPiece> a, const std::vector<LaidPiece>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

/// Every combination of the strips' ways.
std::vector<std::vector<LaidPiece>> combinations(const PoleField& field) {
  std::vector<std::vector<LaidPiece>> out{{}};
  for (const Track& strip : field.family().tracks) {
    std::vector<std::vector<LaidPiece>> longer;
    const StripWays ways = rolling_circle_paths(field, strip);
    for (const auto& begun : out)
      for (const auto& way : ways.ways) longer.push_back(joined(begun, way));
    out = std::move(longer);
  }
  return out;
}

double cost_by_booleans(const PoleField& field, const std::vector<LaidPiece>& pieces) {
  return cost(field.objective(), field.by_booleans(pieces));
}

TEST(BestCombination, AnIsolatedPoleIsPassedAsCheaplyAsByTheBestCombination) {
  int with_detours = 0, cut = 0;
  for (const Pole& pole : poles()) {
    SCOPED_TRACE(description(pole));
    const PoleField field(field_ring(pole.width_m), {ring_of(pole)}, machine(pole.width_m, pole.radius_m),
                          {});
    const Avoided found = field.plan();
    expect_own_tally(field, found);
    expect_off_poles(field, found);
    with_detours += detours_in(found) > 0 ? 1 : 0;
    cut += found.tally.stops > 0 ? 1 : 0;
    for (const auto& pieces : combinations(field)) {
      const double other = cost_by_booleans(field, pieces);
      EXPECT_LE(found.cost, other + field.cost_tolerance(pieces));
    }
  }
  EXPECT_GT(with_detours, 20);
  EXPECT_GT(cut, 10);
}

// Everything else stays as in the plan: the other strips' pieces are those of the plan.
TEST(BestCombination, EncounterCostsAreDifferencesOfPlans) {
  int compared = 0;
  for (const Pole& pole : poles()) {
    SCOPED_TRACE(description(pole));
    const PoleField field(field_ring(pole.width_m), {ring_of(pole)}, machine(pole.width_m, pole.radius_m),
                          {});
    const Avoided found = field.plan();
    for (const PlacedEncounter& encounter : encounters_in(field.task(), found)) {
      std::vector<LaidPiece> others;
      for (const LaidPiece& other : found.tracks.front().pieces)
        if (other.track != encounter.track) others.push_back(other);
      const Track& strip = field.family().tracks[static_cast<std::size_t>(encounter.track)];
      ASSERT_EQ(strip.index, encounter.track);
      const StripWays ways = rolling_circle_paths(field, strip);
      const double cost_of_cut = cost_by_booleans(field, joined(others, ways.ways[0]));
      for (std::size_t i = 1; i < ways.ways.size(); ++i) {
        const WayPast& way = ways.names[i] == Passing::kLeft ? encounter.left : encounter.right;
        const std::vector<LaidPiece> pieces = joined(others, ways.ways[i]);
        const double more = cost_by_booleans(field, pieces) - cost_of_cut;
        // What is left out as far too expensive is more expensive than a cut.
        if (!way.possible) {
          EXPECT_GT(more, 0) << way.why_not;
          continue;
        }
        EXPECT_NEAR(way.cost, more, 2 * field.cost_tolerance(pieces)) << name(ways.names[i]);
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 200);
}

// The field is its own mirror image about the middle of strip 3, and so is the pole.

}  // namespace tramline::best_combination_test
