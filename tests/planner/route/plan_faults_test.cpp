#include "tramline/planner/whole/plan_faults.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace tramline {
namespace {

enum class Step { kTrack, kPass, kTurn, kBackOut };

Plan driven(std::initializer_list<Step> steps) {
  Plan out;
  for (const Step step : steps) {
    RouteLeg leg;
    switch (step) {
      case Step::kTrack:
        leg.kind = LegKind::kWork;
        leg.piece = out.pieces.size();
        out.pieces.emplace_back();
        break;
      case Step::kPass:
        leg.kind = LegKind::kHeadland;
        leg.pass = out.headland.passes.size();
        out.headland.passes.emplace_back();
        break;
      case Step::kTurn:
        leg.kind = LegKind::kTurn;
        break;
      case Step::kBackOut:
        leg.kind = LegKind::kBackOut;
        break;
    }
    leg.work = leg.piece || leg.pass;
    out.route.legs.push_back(leg);
  }
  return out;
}

TEST(PlanFaults, BackingOutOfTracksOrIntoThem) {
  using enum Step;
  EXPECT_FALSE(backs_out_of_tracks(Plan{}));
  EXPECT_FALSE(backs_out_of_tracks(driven({kTrack, kTurn, kTrack})));
  EXPECT_TRUE(backs_out_of_tracks(driven({kTrack, kBackOut, kTurn, kTrack})));
  EXPECT_TRUE(backs_out_of_tracks(driven({kTrack, kTurn, kBackOut, kPass})));
  EXPECT_TRUE(backs_out_of_tracks(driven({kPass, kBackOut, kTurn, kTrack})));
  EXPECT_TRUE(backs_out_of_tracks(driven({kTrack, kBackOut}))) << "to where the route ends";
  EXPECT_TRUE(backs_out_of_tracks(driven({kBackOut, kTrack}))) << "from where it begins";
}

// Out of corners of passes machines back wherever it pays.
TEST(PlanFaults, CornersOfPassesSayNothingOfRoom) {
  using enum Step;
  const Plan corners = driven({kTrack, kTurn, kPass, kBackOut, kTurn, kPass, kBackOut, kTurn, kPass});
  EXPECT_FALSE(backs_out_of_tracks(corners));
  EXPECT_FALSE(lacks_room({corners, {}}));
}

TEST(PlanFaults, RoomIsLackingWhereMoreThanEveryFourthTrackIsBackedOutOf) {
  using enum Step;
  EXPECT_FALSE(lacks_room({driven({kTrack, kTurn, kTrack, kTurn, kTrack, kTurn, kTrack, kBackOut}), {}}));
  EXPECT_TRUE(lacks_room({driven({kTrack, kTurn, kTrack, kTurn, kTrack, kBackOut}), {}}));
}

}  // namespace
}  // namespace tramline
