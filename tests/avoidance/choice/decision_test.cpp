// How ways past gaps are told apart, priced and joined: by hand.

#include "tramline/avoidance/choice/decision.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

WayRound way_past_gaps(std::size_t first, std::size_t last, double from, double to,
                       Passing side = Passing::kLeft) {
  WayRound out;
  out.first_gap = first;
  out.last_gap = last;
  out.detour.from = from;
  out.detour.to = to;
  out.detour.side = side;
  out.detour.length_m = to - from + 1;
  out.detour.path = straight_path({0, from}, {0, to});
  return out;
}

std::vector<std::pair<std::size_t, std::size_t>> rows_of(const std::vector<WayRound>& alone) {
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (const GapRow& row : rows_to_join(alone)) out.emplace_back(row.first, row.last);
  return out;
}

TEST(RowsToJoin, AreNoneWhereDetoursFollowOneAnother) {
  EXPECT_TRUE(rows_of({way_past_gaps(1, 1, 0, 10), way_past_gaps(2, 2, 10, 20)}).empty());
  EXPECT_TRUE(rows_of({}).empty());
}

// Five detours, of which the first four run into the next: from each of them round two, three, and the rest.
TEST(RowsToJoin, AreTwoThreeOrAllThatRunIntoOneAnother) {
  std::vector<WayRound> alone;
  for (std::size_t gap = 1; gap <= 5; ++gap) {
    const double from = 10.0 * static_cast<double>(gap);
    alone.push_back(way_past_gaps(gap, gap, from, from + 12));
  }
  alone.push_back(way_past_gaps(7, 7, 90, 95));
  const std::vector<std::pair<std::size_t, std::size_t>> expected{{1, 2}, {1, 3}, {1, 5}, {2, 3}, {2, 4},
                                                                  {2, 5}, {3, 4}, {3, 5}, {4, 5}};
  EXPECT_EQ(rows_of(alone), expected);
}

TEST(Decision, DrivesAreTheSameUpToRounding) {
  const WayRound way = way_past_gaps(1, 2, 10, 20);
  WayRound other = way;
  other.detour.from += 1e-12;
  EXPECT_TRUE(same_drive(way, other));
  BlockedTrack track;
  EXPECT_FALSE(has_option(track, way));
  track.options.emplace_back().way = other;
  EXPECT_TRUE(has_option(track, way));
  for (const WayRound& different :
       {way_past_gaps(1, 1, 10, 20), way_past_gaps(2, 2, 10, 20), way_past_gaps(1, 2, 10, 20.001),
        way_past_gaps(1, 2, 9.999, 20), way_past_gaps(1, 2, 10, 20, Passing::kRight)}) {
    EXPECT_FALSE(same_drive(way, different));
    EXPECT_FALSE(has_option(track, different));
  }
  other = way;
  other.detour.length_m += 0.001;
  EXPECT_FALSE(same_drive(way, other));
}

TEST(Decision, DetoursAreTheSameWherePathsAre) {
  const TrackDetour a = way_past_gaps(1, 1, 10, 20).detour, b = way_past_gaps(2, 2, 30, 40).detour;
  EXPECT_TRUE(same_detours({}, {}));
  EXPECT_TRUE(same_detours({a, b}, {a, b}));
  EXPECT_FALSE(same_detours({a, b}, {a}));
  EXPECT_FALSE(same_detours({a, b}, {b, a}));
}

TEST(Decision, AWayIsPricedAboveACutOrHasItsReason) {
  BlockedTrack track;
  track.refused = {{Construction::kOwn, 1, Passing::kLeft, Refusal::kLeavesField},
                   {Construction::kPaper, 1, Passing::kLeft, Refusal::kTooTight},
                   {Construction::kOwn, 2, Passing::kLeft, Refusal::kNoSide}};
  const WayPast driven = way_past(track, {1, Passing::kLeft}, TrackChoice{{}, 7}, 10, WaysPast::kOwn);
  EXPECT_TRUE(driven.possible);
  EXPECT_EQ(driven.cost, -3);
  EXPECT_EQ(driven.why_not, "");
  const auto why = [&track](std::size_t gap, Passing side, WaysPast ways) {
    const WayPast past = way_past(track, {gap, side}, std::nullopt, 10, ways);
    EXPECT_FALSE(past.possible);
    return past.why_not;
  };
  EXPECT_EQ(why(1, Passing::kLeft, WaysPast::kOwn), "it would leave the field");
  EXPECT_EQ(why(1, Passing::kLeft, WaysPast::kBoth), "it would leave the field");
  EXPECT_EQ(why(1, Passing::kLeft, WaysPast::kPaper), "it is too tight in the middle");
  EXPECT_EQ(why(2, Passing::kLeft, WaysPast::kOwn), "the obstacle has no side to pass on");
  // Not refused for its own sake: what is beside it was in the way, or Versleijen decided for the other side.
  EXPECT_EQ(why(1, Passing::kRight, WaysPast::kOwn), "detours beside it are in the way");
  EXPECT_EQ(why(1, Passing::kRight, WaysPast::kPaper), "the paper's rule passes on the other side");
}

}  // namespace
}  // namespace tramline
