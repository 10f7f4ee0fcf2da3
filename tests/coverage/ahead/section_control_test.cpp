// Sections switched by looking ahead, against a driver who switches the whole boom.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coverage/ahead/sprayer.h"

namespace tramline::testing {
namespace {

// Half a boom over each of ten ends, w² / (8 tan 45°) doubled and as much missed; or twice as far, all
// doubled.
TEST(Sprayer, ByHandAsTheTrianglesSay) {
  const Sprayer sprayer;
  const double triangle_m2 = 24 * 24 / 8.0;
  const Sprayed middle = sprayed_by_hand(sprayer, Driver::kAtTheMiddle);
  EXPECT_NEAR(middle.doubled_m2, 10 * triangle_m2, 1e-3);
  EXPECT_NEAR(middle.missed_m2, 10 * triangle_m2, 1e-3);
  const Sprayed safe = sprayed_by_hand(sprayer, Driver::kMissesNothing);
  EXPECT_NEAR(safe.doubled_m2, 10 * 4 * triangle_m2, 1e-3);
  EXPECT_NEAR(safe.missed_m2, 0, 1e-3);
}

// One section, half of it: the driver's middle, but for half a tick at each end.
TEST(Sprayer, OneSectionIsTheDriverAtTheMiddle) {
  const Sprayer sprayer;
  const Sprayed hand = sprayed_by_hand(sprayer, Driver::kAtTheMiddle);
  const double half_tick_m2 = sprayer.width_m * sprayer.speed_mps * sprayer.tick_s / 2;
  EXPECT_NEAR(sprayed_looking_ahead(sprayer, 1).sum_m2(), hand.sum_m2(), 10 * half_tick_m2);
}

// n sections leave an n-th of the triangles, and what a tick lets pass.
TEST(Sprayer, SectionsHalveWhatTheBestDriverDoublesAndMisses) {
  for (const double slant_deg : {30.0, 45.0}) {
    Sprayer sprayer;
    sprayer.slant_deg = slant_deg;
    const double hand_m2 = std::min(sprayed_by_hand(sprayer, Driver::kAtTheMiddle).sum_m2(),
                                    sprayed_by_hand(sprayer, Driver::kMissesNothing).sum_m2());
    const double ticks_m2 = 10 * sprayer.width_m * sprayer.speed_mps * (sprayer.tick_s / 2 + 0.02);
    for (const int sections : {1, 7, 30}) {
      const Sprayed found = sprayed_looking_ahead(sprayer, sections);
      fmt::print("slant {:.0f}°, by hand {:.0f} m²; {:2} sections: doubled {:6.1f} m², missed {:6.1f} m²\n",
                 slant_deg, hand_m2, sections, found.doubled_m2, found.missed_m2);
      EXPECT_LE(found.sum_m2(), hand_m2 / sections + ticks_m2) << sections;
      if (sections > 1) {
        EXPECT_LE(found.sum_m2(), hand_m2 / 2) << sections;
      }
    }
  }
}

// Where the rule does not know of the valves, each of five beginnings is missed for 0.6 s and each of five
// ends doubled for 0.4 s, at 24 m and 3 m/s: 216 and 144 m² more, but for a quarter of a tick.
TEST(Sprayer, LatenciesMatter) {
  const Sprayer knowing;
  Sprayer unknowing;
  unknowing.rule.on_latency_s = unknowing.rule.off_latency_s = 0;
  const Sprayed allowed = sprayed_looking_ahead(knowing, 30), late = sprayed_looking_ahead(unknowing, 30);
  EXPECT_NEAR(late.missed_m2 - allowed.missed_m2, 5 * 24 * 3 * 0.6, 50);
  EXPECT_NEAR(late.doubled_m2 - allowed.doubled_m2, 5 * 24 * 3 * 0.4, 50);
}

// To leave nothing out, a section goes on as soon as any of it has work to do: nothing is missed but for
// ticks.
TEST(Sprayer, ThresholdsTradeDoublesForMisses) {
  Sprayer safe, sparing;
  safe.rule.on_from = safe.rule.off_below = 0.02;
  sparing.rule.on_from = sparing.rule.off_below = 0.98;
  const Sprayed all = sprayed_looking_ahead(safe, 7), none = sprayed_looking_ahead(sparing, 7);
  EXPECT_LT(all.missed_m2, 0.2 * all.doubled_m2);
  EXPECT_LT(none.doubled_m2, 0.2 * none.missed_m2);
}

}  // namespace
}  // namespace tramline::testing
