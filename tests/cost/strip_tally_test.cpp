#include "tramline/cost/strip_tally.h"

#include <gtest/gtest.h>

#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline::strip_tally_test {

constexpr double kWidth = 3;

Polygon box(double x0, double y0, double x1, double y1) {
  return {{{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, {}};
}

LaidTracks tracks_in(const Subfield& subfield, EndRule rule) {
  const StripGrid grid = strip_grids(subfield, kWidth).front();
  const Polygon turned = grid.frame.to_track(Region{subfield.shape}).front();
  return cut_pieces(straight_tracks(grid, turned, {}, end_criterion(rule, Objective{}, kWidth)), 0);
}

// Two trapezia share a 45° border from (30, 0) to (60, 30); both are driven north. With the rule
// `cover` the left rows (strips x in [30, 60], which start at the border) run down by up to 3 m into
// the right field, and the right rows up into the left one: ten strips, wedge 4.5 m² each way, all of
// it on land the other covers as well.
TEST(Tally, CountsOverlapAcrossABorderOnce) {
  const Direction north = Direction::clockwise_from_north(Angle::degrees(0));
  const std::vector<Subfield> subfields{{{{{0, 0}, {30, 0}, {60, 30}, {60, 90}, {0, 90}}, {}}, north},
                                        {{{{30, 0}, {60, 0}, {60, 30}}, {}}, north}};
  std::vector<LaidTracks> tracks;
  for (const Subfield& subfield : subfields) tracks.push_back(tracks_in(subfield, EndRule::kCover));
  const double body = 60 * 90;
  const Tally tally = tally_of(subfields, tracks, body);
  EXPECT_EQ(tally.pieces, 30);
  EXPECT_EQ(tally.turns, 29);
  EXPECT_NEAR(tally.uncovered_m2, 0, 1e-6);
  EXPECT_NEAR(tally.overlap_m2, 10 * 4.5 * 2, 1e-3);
  EXPECT_NEAR(tally.worked_m2, body - tally.uncovered_m2 + tally.overlap_m2, 1e-9);

  // With `inside` both leave their wedges bare, and nothing overlaps.
  for (std::size_t i = 0; i < 2; ++i) tracks[i] = tracks_in(subfields[i], EndRule::kInside);
  const Tally bare = tally_of(subfields, tracks, body);
  EXPECT_NEAR(bare.overlap_m2, 0, 1e-3);
  EXPECT_NEAR(bare.uncovered_m2, 90, 1e-2);

  // With `centre` each covers a quarter of its wedge beyond the border: what the one leaves bare at
  // its end the other runs into, so the two halves of a strip fit together exactly.
  for (std::size_t i = 0; i < 2; ++i) tracks[i] = tracks_in(subfields[i], EndRule::kCentre);
  const Tally half = tally_of(subfields, tracks, body);
  EXPECT_NEAR(half.overlap_m2, 0, 1e-6);
  EXPECT_NEAR(half.uncovered_m2, 0, 1e-6);
}

TEST(Tally, OfOneRectangleIsExact) {
  const std::vector<Subfield> subfields{
      {box(0, 0, 31, 100), Direction::clockwise_from_north(Angle::degrees(0))}};
  const std::vector<LaidTracks> tracks{tracks_in(subfields[0], EndRule::kCentre)};
  // 31 = 10·3 + 1: the eleventh strip's centre lies outside, 1 × 100 m stay uncovered.
  const Tally tally = tally_of(subfields, tracks, 3100);
  EXPECT_EQ(tally.pieces, 10);
  EXPECT_NEAR(tally.overlap_m2, 0, 1e-9);
  EXPECT_NEAR(tally.uncovered_m2, 100, 1e-9);
  EXPECT_NEAR(tally.track_length_m, 1000, 1e-9);

  const std::vector<LaidTracks> covering{tracks_in(subfields[0], EndRule::kCover)};
  const Tally full = tally_of(subfields, covering, 3100);
  EXPECT_EQ(full.pieces, 11);
  EXPECT_NEAR(full.overlap_m2, 200, 1e-9);
  EXPECT_NEAR(full.uncovered_m2, 0, 1e-9);
}

TEST(WorkedRegions, AreWhatIsDoubledOrOutsideAndWhatIsBare) {
  const WorkedRegions regions = worked_regions({box(0, 0, 10, 10)}, {box(0, 0, 6, 10), box(5, 0, 9, 11)});
  EXPECT_NEAR(area(regions.overlap), 10 + 4, 1e-6);  // doubled [5,6] × [0,10], outside [5,9] × [10,11]
  EXPECT_NEAR(area(regions.uncovered), 10, 1e-6);    // [9,10] × [0,10]
}

// A line driven there and, but for a tenth of a millimetre, back: corners of the two rectangles coincide but
// for rounding, those of the intersection may come in another order, and an overlay of a ring that crosses
// itself drops land silently.
TEST(CommonToTwo, NeverCrossesItself) {
  const Region pair{{{{-11.339874857993314, -22.185953612371925},
                      {36.200580305407662, -67.049415897965233},
                      {39.765000186903926, -63.272307870031696},
                      {-7.7754549764970573, -18.408845584438389}},
                     {}},
                    {{{39.765072915595773, -63.27237650338644},
                      {-7.7754549764970573, -18.408845584438389},
                      {-11.339874857993314, -22.185953612371925},
                      {36.20065303409951, -67.049484531319976}},
                     {}}};
  const Region both = common_to_two(pair);
  ASSERT_EQ(both.size(), 1u);
  EXPECT_FALSE(find_invalidity(both.front()).has_value());
  EXPECT_NEAR(area(both), area(pair.front()), 1e-6);
}

TEST(Cost, IsTheWeightedSum) {
  Tally tally;
  tally.overlap_m2 = 100;
  tally.uncovered_m2 = 50;
  tally.turns = 10;
  tally.stops = 2;
  tally.subfields = 3;
  EXPECT_NEAR(cost(Objective{}, tally), 2 + 5 + 10 + 10 + 2 * 5, 1e-12);
  tally.subfields = 0;  // nothing is worked
  EXPECT_NEAR(cost(Objective{}, tally), 2 + 5 + 10 + 10, 1e-12);
  EXPECT_NEAR(cost(Objective{99999, 1, 1, 0}, tally), 99999 * 100 + 50 + 10, 1e-6);
}

}  // namespace tramline::strip_tally_test
