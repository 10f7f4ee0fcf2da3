// The cheapest way along one track against all ways along it, each priced by hand: m² worked in vain, m²
// gained, turns and stops.

#include "tramline/avoidance/choice/track_choice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <optional>

#include "avoidance/pole_field.h"
#include "properties/seeds.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline::track_choice_test {

using testing_support::box;

constexpr double kSwath = 3;

/// One strip of 3 m from y = 0 to y = 300, blocked at full width between these coordinates.
Track blocked_strip(const Intervals& gaps) {
  Polygon land{box(0, 0, kSwath, 300), {}};
  Region hard;
  for (const Interval& gap : gaps) hard.push_back({box(-1, gap.from, kSwath + 1, gap.to), {}});
  return straight_tracks({TrackFrame(), 0, kSwath}, land, {hard, {}, {}}, {false, kSwath - kWidthTolerance})
      .tracks.front();
}

/// A way past some gaps. Its path tells it from others and is as long as it says.
TrackOption option_past(std::size_t first, std::size_t last, Interval replaced, double longer_m,
                        double gain_m2, Passing side) {
  TrackOption out;
  out.way.first_gap = first;
  out.way.last_gap = last;
  out.replaced = replaced;
  out.way.detour.from = replaced.from;
  out.way.detour.to = replaced.to;
  out.way.detour.side = side;
  out.way.detour.path =
      straight_path({side == Passing::kLeft ? 0.0 : 1.0, replaced.from}, {1, replaced.to + gain_m2});
  out.way.detour.length_m = replaced.length() + longer_m;
  out.useful_m2 = gain_m2 + 1;
  out.replaced_m2 = 1;
  return out;
}

/// A track with random gaps and ways past them.
struct RandomTrack {
  explicit RandomTrack(std::mt19937_64& random) {
    std::uniform_int_distribution<int> gap_count(1, 4), coin(0, 1), one_in_four(0, 3);
    std::uniform_real_distribution<double> step(4, 50), width(1, 6), reach(0.5, 14), longer(0, 4),
        gain(-30, 60);
    double at = 0;
    for (int i = gap_count(random); i > 0; --i) {
      at += step(random);
      gaps.push_back({at, at + width(random)});
      at = gaps.back().to;
    }
    track = blocked_strip(gaps);
    blocked.correction_m2.assign(track.stretches.size(), 0);
    for (std::size_t first = 1; first <= gaps.size(); ++first)
      for (std::size_t last = first; last <= std::min(gaps.size(), first + 1); ++last)
        for (const Passing side : {Passing::kLeft, Passing::kRight}) {
          if (coin(random) == 0) continue;
          const double before = track.stretches[first - 1].length(), behind = track.stretches[last].length();
          const Interval replaced{gaps[first - 1].from - std::min(reach(random), 0.99 * before),
                                  gaps[last - 1].to + std::min(reach(random), 0.99 * behind)};
          blocked.options.push_back(option_past(first, last, replaced, longer(random), gain(random), side));
          // The profile is what the track itself covers on its stretches.
          for (const Interval& kept : common(track.stretches, {replaced}))
            blocked.options.back().profile_m2 += kSwath * kept.length();
        }
    blocked.only_one_driven = coin(random) == 0;
    blocked.only_one_of_subfield = !blocked.only_one_driven && coin(random) == 0;
    if (one_in_four(random) == 0)
      blocked.correction_m2[0] = -2;  // a neighbour's detour covers 2 m² of the first stretch
    least_m = coin(random) == 0 ? 0 : 12;
    prices = {0.02, 0.1, one_in_four(random) == 0 ? 0 : 1.0, one_in_four(random) == 0 ? 0 : 5.0, 3};
  }

  Intervals gaps;
  Track track;
  BlockedTrack blocked;
  double least_m = 0;
  Objective prices;
};

/// Cost of a set of options, which follow one another.
double cost_by_hand(const RandomTrack& random, const std::vector<const TrackOption*>& chosen) {
  const Intervals& stretches = random.track.stretches;
  double sum = 0;
  int driven = 0;
  for (std::size_t i = 0; i < stretches.size();) {
    std::size_t last = i;
    double length_m = 0, gained_m2 = 0;
    for (const TrackOption* option : chosen)
      if (option->way.first_gap == last + 1) {
        last = option->way.last_gap;
        length_m += option->way.detour.length_m - option->replaced.length();
        gained_m2 += option->gain_m2();
      }
    length_m += stretches[last].to - stretches[i].from;
    double useful = gained_m2;
    for (std::size_t k = i; k <= last; ++k)
      useful += kSwath * stretches[k].length() + random.blocked.correction_m2[k];
    if (length_m >= random.least_m) {
      ++driven;
      const int stops = (i > 0 ? 1 : 0) + (last + 1 < stretches.size() ? 1 : 0);
      sum += random.prices.overlap * (kSwath * length_m - useful) - random.prices.uncovered * useful +
             random.prices.turn + random.prices.stop * stops;
    }
    i = last + 1;
  }
  if (driven > 0 && random.blocked.only_one_driven) sum -= random.prices.turn;
  if (driven > 0 && random.blocked.only_one_of_subfield) sum += random.prices.subfield;
  return sum;
}

bool fits(const std::vector<const TrackOption*>& chosen, std::optional<Forced> forced) {
  for (std::size_t i = 0; i + 1 < chosen.size(); ++i)
    if (chosen[i]->way.last_gap >= chosen[i + 1]->way.first_gap ||
        chosen[i]->way.detour.to > chosen[i + 1]->way.detour.from)
      return false;
  if (!forced) return true;
  const auto passes = std::find_if(chosen.begin(), chosen.end(), [&](const TrackOption* option) {
    return option->way.first_gap <= forced->gap && forced->gap <= option->way.last_gap;
  });
  return passes == chosen.end() ? forced->way == Passing::kCut : (*passes)->way.detour.side == forced->way;
}

/// All sets of options that can be driven together, in order along the track.
std::vector<std::vector<const TrackOption*>> all_ways(const RandomTrack& random,
                                                      std::optional<Forced> forced) {
  const std::size_t count = random.blocked.options.size();
  std::vector<std::vector<const TrackOption*>> out;
  for (std::size_t set = 0; set < (std::size_t{1} << count); ++set) {
    std::vector<const TrackOption*> chosen;
    for (std::size_t i = 0; i < count; ++i)
      if ((set >> i & 1U) != 0) chosen.push_back(&random.blocked.options[i]);
    if (fits(chosen, forced)) out.push_back(chosen);
  }
  return out;
}

void expect_cheapest(const RandomTrack& random, std::optional<Forced> forced) {
  double least = std::numeric_limits<double>::infinity();
  for (const auto& chosen : all_ways(random, forced)) least = std::min(least, cost_by_hand(random, chosen));
  const std::optional<TrackChoice> choice =
      cheapest_choice(random.blocked, random.track, kSwath, random.prices, random.least_m, forced);
  ASSERT_EQ(choice.has_value(), least < std::numeric_limits<double>::infinity());
  if (!choice) return;
  ASSERT_NEAR(choice->cost, least, 1e-3);
  ASSERT_NEAR(
      track_cost(random.blocked, random.track, kSwath, choice->detours, random.prices, random.least_m),
      choice->cost, 1e-9);
}

TEST(TrackChoice, IsTheCheapestOfAllWaysAlongATrack) {
  testing::for_each_seed(150, [](std::mt19937_64& seeded, int) {
    const RandomTrack random(seeded);
    expect_cheapest(random, std::nullopt);
    for (std::size_t gap = 1; gap <= random.gaps.size(); ++gap)
      for (const Passing way : {Passing::kCut, Passing::kLeft, Passing::kRight}) {
        SCOPED_TRACE(::testing::Message() << "gap " << gap << " way " << static_cast<int>(way));
        expect_cheapest(random, Forced{gap, way});
      }
  });
}

TEST(TrackChoice, CostsOfAllWaysAreThoseByHand) {
  testing::for_each_seed(60, [](std::mt19937_64& seeded, int) {
    const RandomTrack random(seeded);
    for (const auto& chosen : all_ways(random, std::nullopt)) {
      std::vector<TrackDetour> detours;
      for (const TrackOption* option : chosen) detours.push_back(option->way.detour);
      ASSERT_NEAR(track_cost(random.blocked, random.track, kSwath, detours, random.prices, random.least_m),
                  cost_by_hand(random, chosen), 1e-3);
    }
  });
}

// At equal costs the detour: 2 stops and a turn against land worth as much.
TEST(TrackChoice, AmongEqualsHasFewerCuts) {
  RandomTrack even = [] {
    std::mt19937_64 any(1);
    return RandomTrack(any);
  }();
  even.gaps = {{100, 104}};
  even.track = blocked_strip(even.gaps);
  even.blocked = {};
  even.blocked.correction_m2 = {0, 0};
  even.prices = {0, 0, 0, 0, 0};
  even.least_m = 0;
  even.blocked.options = {option_past(1, 1, {90, 114}, 0, 0, Passing::kLeft)};
  const auto choice = cheapest_choice(even.blocked, even.track, kSwath, even.prices, 0);
  ASSERT_TRUE(choice);
  EXPECT_EQ(choice->detours.size(), 1u);
}

}  // namespace tramline::track_choice_test
