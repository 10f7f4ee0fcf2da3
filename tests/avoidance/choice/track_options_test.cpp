// Which ways a track may choose from, and what they are worth: by hand, and against polygon booleans.

#include "tramline/avoidance/choice/track_options.h"

#include <gtest/gtest.h>

#include "avoidance/pole_field.h"
#include "properties/seeds.h"
#include "tramline/avoidance/choice/detour_pruning.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline::track_options_test {

using testing_poles::PoleField;
using testing_poles::regular;
using testing_support::box;

TrackOption named(std::size_t found, std::size_t first_gap, Construction by) {
  TrackOption out;
  out.found = found;
  out.way.first_gap = out.way.last_gap = first_gap;
  out.by = by;
  out.stale = false;
  return out;
}

std::vector<std::size_t> names(const std::vector<TrackOption>& options) {
  std::vector<std::size_t> out;
  for (const TrackOption& option : options) out.push_back(option.found);
  return out;
}

using Names = std::vector<std::size_t>;

// 0 and 1 are ours, 1 far too expensive; 2 is the paper's; 3 and 4 are twins, ours far too expensive.
class AllowedOptions : public ::testing::Test {
 protected:
  AllowedOptions() {
    track_.stale = false;
    track_.options = {named(4, 2, Construction::kPaper), named(0, 2, Construction::kOwn),
                      named(2, 1, Construction::kPaper), named(1, 1, Construction::kOwn),
                      named(3, 2, Construction::kOwn)};
    track_.options[3].far_too_expensive = track_.options[4].far_too_expensive = true;
    track_.options[0].has_twin = track_.options[4].has_twin = true;
  }
  BlockedTrack track_;
};

TEST_F(AllowedOptions, AreOursThatAreNotFarTooExpensive) {
  allow(track_, WaysPast::kOwn);
  EXPECT_EQ(names(track_.options), (Names{0}));
  EXPECT_EQ(names(track_.not_allowed), (Names{1, 2, 3, 4}));
}

TEST_F(AllowedOptions, AreThePapersWhereThoseAreAskedFor) {
  allow(track_, WaysPast::kPaper);
  EXPECT_EQ(names(track_.options), (Names{2, 4}));
}

// Of twins ours, however expensive, for the paper's plan has to be there to compare with.
TEST_F(AllowedOptions, AreOneOfTwinsWhereBothAreAskedFor) {
  allow(track_, WaysPast::kBoth);
  EXPECT_EQ(names(track_.options), (Names{2, 0, 3}));
}

TEST_F(AllowedOptions, AreSortedAgainFromAllThatThereAre) {
  allow(track_, WaysPast::kPaper);
  allow(track_, WaysPast::kOwn);
  EXPECT_EQ(names(track_.options), (Names{0}));
  EXPECT_FALSE(track_.stale) << "what is allowed again has been valued";
  track_.not_allowed[1].stale = true;  // option 2
  allow(track_, WaysPast::kOwn);
  EXPECT_FALSE(track_.stale);
  allow(track_, WaysPast::kPaper);
  EXPECT_TRUE(track_.stale);
}

TEST(TrackOptions, HardGapsAreThoseThatHardLandMakes) {
  Track track;
  track.stretches = {{0, 10}, {12, 20}, {25, 30}, {31, 40}};
  track.hard_stretches = {{10.5, 11}, {29.9, 31}};
  EXPECT_EQ(hard_gaps(track), (Names{1, 3}));
  track.hard_stretches = {{12, 25}};
  EXPECT_EQ(hard_gaps(track), (Names{2}));
  track.hard_stretches = {};
  EXPECT_TRUE(hard_gaps(track).empty());
}

/// Seven strips of 3 m with a pole in the fourth.
class ValuedOptions : public ::testing::Test {
 protected:
  ValuedOptions()
      : field_(box(0, 0, 21, 160), {regular(16, 1, {10.4, 80})}, testing_poles::machine(3, 6), {}),
        ground_(field_.task().families) {
    for (const Ring& ring : rings_of(field_.ground().body)) body_.push_back(ring);
    blocked_.place = 3;
    blocked_.gaps = hard_gaps(track());
    for (const Passing side : {Passing::kLeft, Passing::kRight})
      blocked_.options.push_back(option_of(field_.way(track(), 1, side), field_.family().grid, track()));
  }
  const Track& track() const { return field_.family().tracks[3]; }
  Region straight(std::size_t strip) const {
    Region out;
    const double left = field_.family().grid.line(static_cast<int>(strip));
    for (const Interval& one : field_.family().tracks[strip].stretches)
      out.push_back({box(left, one.from, left + 3, one.to), {}});
    return out;
  }
  void drive(std::size_t strip) { ground_.set(0, strip, {field_.family().tracks[strip].stretches, {}}); }

  PoleField field_;
  WorkedGround ground_;
  std::vector<Ring> body_;
  BlockedTrack blocked_;
};

// Beside driven neighbours a detour is worth its land that they leave; it replaces what the strip works
// itself.
TEST_F(ValuedOptions, AreWorthTheLandThatNobodyElseWorks) {
  for (const bool driven : {false, true}) {
    SCOPED_TRACE(driven);
    if (driven)
      for (const std::size_t strip : {2U, 4U}) drive(strip);
    mark_all_stale(blocked_);
    value_options(blocked_, field_.family(), body_, ground_, 0);
    EXPECT_FALSE(blocked_.stale);
    for (const TrackOption& option : blocked_.options) {
      const Region swath{{band(option.way.detour.path, 3, 1e-6), {}}};
      Region useful = intersection(swath, field_.ground().body);
      if (driven)
        for (const std::size_t strip : {2U, 4U}) useful = difference(useful, straight(strip));
      EXPECT_NEAR(option.useful_m2, area(useful), 1e-3);
      double kept = 0;
      for (const Interval& one : common(track().stretches, {option.replaced})) kept += 3 * one.length();
      // Strips before and behind the pole are whole, up to the tolerance of widths.
      EXPECT_NEAR(option.replaced_m2, kept, 1e-3);
      EXPECT_NEAR(option.profile_m2, kept, 1e-3);
      EXPECT_NEAR(option.gain_m2(), area(useful) - kept, 2e-3);
    }
  }
}

TEST_F(ValuedOptions, ShortStretchesAreCorrectedForWhatOthersWork) {
  TrackWork beside;
  TrackDetour detour;  // 1 m into the fourth strip from y = 10 to y = 40
  detour.path = straight_path({8.5, 10}, {8.5, 40});
  beside.detours = {detour};
  ground_.set(0, 2, beside);
  value_options(blocked_, field_.family(), body_, ground_, 20);
  EXPECT_EQ(blocked_.correction_m2, (std::vector<double>{0, 0})) << "long ones need none";
  mark_all_stale(blocked_);
  value_options(blocked_, field_.family(), body_, ground_, 60);
  EXPECT_NEAR(blocked_.correction_m2.at(0), -30, 1e-6);
  EXPECT_NEAR(blocked_.correction_m2.at(1), 0, 1e-6);
}

TEST_F(ValuedOptions, AreStaleWhereSomethingChangesNearby) {
  value_options(blocked_, field_.family(), body_, ground_, 0);
  const TrackOption& left = blocked_.options[0];
  const TrackOption& right = blocked_.options[1];
  mark_stale(blocked_, field_.family(), {0, 0, 2, 160});
  EXPECT_FALSE(blocked_.stale) << "far off";
  mark_stale(blocked_, field_.family(), {7.5, 79, 7.6, 81});
  EXPECT_TRUE(left.stale);
  EXPECT_FALSE(right.stale) << "beyond the detour to the left";
  EXPECT_TRUE(blocked_.stale);
  value_options(blocked_, field_.family(), body_, ground_, 0);
  mark_stale(blocked_, field_.family(), {9.5, 5, 9.6, 6});
  EXPECT_TRUE(blocked_.stale) << "on a stretch of the track";
  EXPECT_FALSE(left.stale || right.stale);
  mark_all_stale(blocked_);
  EXPECT_TRUE(left.stale && right.stale);
}

// Three times what the cuts cost: 11 € for a turn and two stops here. An option of 20 m that gains nothing
// and is longer by x costs 0.02·3·x, so 550 m more are as much as that.
TEST_F(ValuedOptions, AreFarTooExpensiveFromThreeTimesTheCutsOn) {
  const Objective prices{0.02, 0.1, 1, 5, 5};
  const TrackTerms terms{0, track(), prices, 3, 0};
  TrackOption option = blocked_.options[0];
  const double kept = option.replaced.length() - (track().stretches[1].from - track().stretches[0].to);
  option.useful_m2 = option.replaced_m2 = 40;
  option.way.detour.length_m = kept + 549;
  EXPECT_FALSE(far_too_expensive(option, terms));
  option.way.detour.length_m = kept + 551;
  EXPECT_TRUE(far_too_expensive(option, terms));
  option.useful_m2 += 1;  // worth 0.12 €, 2 m
  EXPECT_FALSE(far_too_expensive(option, terms));
  EXPECT_FALSE(can_be_pruned(blocked_.options[0], terms, field_.task().families, ground_));
}

}  // namespace tramline::track_options_test
