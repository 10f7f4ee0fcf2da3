#include "tramline/avoidance/choice/detour_decisions.h"

#include <gtest/gtest.h>

#include "avoidance/pole_field.h"
#include "tramline/avoidance/least_cost_with_detours.h"

namespace tramline::detour_decisions_test {

using namespace testing_poles;

/// Poles in neighbouring strips and behind one another, so that tracks depend on one another.
PoleField near_by_poles(double width_m) {
  const auto pole = [width_m](double across, double along) {
    return regular(8, 0.1 * width_m, {across * width_m, along});
  };
  return PoleField(field_ring(width_m), {pole(3.3, 60), pole(4.6, 70), pole(3.6, 110)}, machine(width_m, 6),
                   {});
}

std::vector<Path> detours_of(const std::vector<LaidTracks>& tracks) {
  std::vector<Path> out;
  for (const LaidTracks& laid : tracks)
    for (const LaidPiece& piece : laid.pieces)
      for (const TrackDetour& detour : piece.detours) out.push_back(detour.path);
  return out;
}

// What was chosen and valued before leaves no trace: a state that has had the paper's ways and is cut again
// comes to what a new one does.
TEST(DetourDecisions, ForgetWhatWasChosenBefore) {
  for (const double width_m : {1.5, 3.0, 6.0}) {
    SCOPED_TRACE(width_m);
    const PoleField field = near_by_poles(width_m);
    const AvoidanceTask task = field.task();
    DetourDecisions fresh(task), used(task);
    used.allow(WaysPast::kPaper);
    ASSERT_TRUE(used.choose_paper_ways());
    ASSERT_FALSE(detours_of(used.tracks()).empty());
    used.improve();
    used.encounters();
    used.allow(WaysPast::kOwn);
    used.choose_from(all_cut(task).tracks);
    EXPECT_TRUE(detours_of(used.tracks()).empty());
    EXPECT_EQ(fresh.improve(), used.improve());
    ASSERT_FALSE(detours_of(fresh.tracks()).empty());
    EXPECT_EQ(detours_of(fresh.tracks()), detours_of(used.tracks()));
    const std::vector<PlacedEncounter> a = fresh.encounters(), b = used.encounters();
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].chosen, b[i].chosen);
      EXPECT_EQ(a[i].left.possible, b[i].left.possible);
      EXPECT_NEAR(a[i].left.cost, b[i].left.cost, 1e-9);
      EXPECT_NEAR(a[i].right.cost, b[i].right.cost, 1e-9);
    }
  }
}

}  // namespace tramline::detour_decisions_test
