// Passes that are driven straight on into corners.

#include "tramline/headland/corners/worked_corners.h"

#include "headland/drawn_headlands.h"
#include "tramline/headland/path_stretch.h"

namespace tramline::testing {
namespace {

constexpr double kWidth_m = 12;
constexpr double kMissed = 10, kDoubled = 1, kPerMetre = 0.5;  // per m² and m

Field field() { return field_of(box(0, 0, 200, 100)); }

CornerPrices prices(double per_stop) { return {kMissed, kDoubled, kPerMetre, per_stop}; }

/// With corners worked out, and with everything that has to hold for any headland.
WorkedCorners worked(const Field& field, const HeadlandTerms& terms, const CornerPrices& prices) {
  const HeadlandAndBody before = made(field, terms);
  WorkedCorners out = with_worked_corners(field, terms, before, prices);
  for (const std::string& fault : faults_of(field, terms, {out.headland, before.body}))
    ADD_FAILURE() << fault;
  return out;
}

double spent(const Headland& headland) {
  return kMissed * headland.uncovered_m2 + kDoubled * headland.overlap_m2;
}

// Twice the radius is the width: straight on the swath works a square of 12 m in each corner, and the next
// part begins behind it.
TEST(WorkedCorners, LeaveAndDoubleNothingWhereTheTurnIsAsWideAsTheSwath) {
  const HeadlandTerms terms = terms_of(field(), kWidth_m, 6, 1);
  const WorkedCorners out = worked(field(), terms, prices(0));
  ASSERT_EQ(out.headland.passes.size(), 4U);
  EXPECT_NEAR(out.headland.worked_m2, 200 * 100 - 176 * 76, kArea);
  EXPECT_NEAR(out.headland.uncovered_m2, 0, kArea);
  EXPECT_NEAR(out.headland.overlap_m2, 0, kArea);
  // Outside an arc of 12 m about the inner corner.
  const double gap_m2 = 12 * 12 * (1 - kPi / 4);
  EXPECT_NEAR(out.saved, 4 * (kMissed * gap_m2 - kPerMetre * 12), kArea);
  for (const HeadlandPass& pass : out.headland.passes) {
    EXPECT_EQ(pass.number, 1);
    EXPECT_TRUE(pass.around_field);
  }
}

TEST(WorkedCorners, AreNotWorkedOutWhereAStopCostsMore) {
  const HeadlandTerms terms = terms_of(field(), kWidth_m, 6, 1);
  const double worth = kMissed * 12 * 12 * (1 - kPi / 4) - kPerMetre * 12;
  EXPECT_EQ(worked(field(), terms, prices(worth - 0.01)).headland.passes.size(), 4U);
  const WorkedCorners none = worked(field(), terms, prices(worth + 0.01));
  EXPECT_EQ(none.saved, 0);
  EXPECT_EQ(none.headland.passes, made(field(), terms).passes);
}

// Each pass keeps to its own frame of the field.
TEST(WorkedCorners, OfInnerPassesEndAtThePassesFartherOut) {
  const HeadlandTerms terms = terms_of(field(), kWidth_m, 6, 2);
  const WorkedCorners out = worked(field(), terms, prices(0));
  ASSERT_EQ(out.headland.passes.size(), 8U);
  EXPECT_NEAR(out.headland.worked_m2, 200 * 100 - 152 * 52, kArea);
  EXPECT_NEAR(out.headland.uncovered_m2, 0, kArea);
  EXPECT_NEAR(out.headland.overlap_m2, 0, kArea);
}

// A machine that turns on 9 m leaves 15²·(1 − π/4) in a corner. Straight on it works 15 m by 12 m, and on the
// arc behind that most of a strip 3 m wide, which is worth working again what lies beside it.
TEST(WorkedCorners, KeepTheArcWhereItWorksLandBesideTheStraightPass) {
  const HeadlandTerms terms = terms_of(field(), kWidth_m, 9, 1);
  const WorkedCorners out = worked(field(), terms, prices(0));
  ASSERT_EQ(out.headland.passes.size(), 4U);
  // ∫ from 0 to 3 of √(225 − t²): the disc of 15 m beyond the straight pass.
  const double beyond_m2 = 1.5 * std::sqrt(216) + 112.5 * std::asin(0.2);
  EXPECT_NEAR(out.headland.uncovered_m2, 4 * (3 * 15 - beyond_m2), kArea);
  const double fresh_m2 = 15 * 12 - (kPi / 4 * 15 * 15 - beyond_m2);
  EXPECT_NEAR(out.saved, 4 * (kMissed * fresh_m2 - kDoubled * (15 * 12 - fresh_m2) - kPerMetre * 15), kArea);
  EXPECT_NEAR(length(out.headland.passes.front().path) + length(out.headland.passes[1].path),
              200 + 100 - 4 * 15 + 2 * (9 * kPi / 2 + 15), kLength)
      << "a long and a short side, each with an arc before and a corner behind";
}

// Only the corner of 41° is worth 400: the pass is cut once, ends where it begins, and goes straight on
// there.
TEST(WorkedCorners, OpenAPassAtOneCornerAlone) {
  const Field kite = field_of({{0, 0}, {200, 0}, {60, 120}, {0, 120}});
  const HeadlandTerms terms = terms_of(kite, kWidth_m, 6, 1);
  ASSERT_EQ(made(kite, terms).passes.size(), 1U);
  EXPECT_EQ(worked(kite, terms, prices(0)).headland.passes.size(), 3U) << "the turn by 41° leaves 2 m²";
  const WorkedCorners one = worked(kite, terms, prices(400));
  ASSERT_EQ(one.headland.passes.size(), 1U);
  const Path& path = one.headland.passes.front().path;
  EXPECT_FALSE(is_closed(one.headland.passes.front()));
  EXPECT_NEAR(path.back().to.y, 6, kLength) << "beside the lower edge";
  // The upper left corner of the swath meets the edge from (200, 0) to (60, 120).
  EXPECT_NEAR(path.back().to.x, 200 - 12 * 140.0 / 120, 1e-3);
}

// Beyond the arc in a tip of 20° lie two short passes, one along each edge: what the pass along the lower
// edge works the long pass works on its way straight on.
TEST(WorkedCorners, SpareAShortPassInATip) {
  const Field wedge = field_of({{0, 0}, {300, 0}, {300, 300 * std::tan(kPi / 9)}});
  const HeadlandTerms terms = terms_of(wedge, kWidth_m, 6, 1);
  const auto short_ones = [](const Headland& headland) {
    return std::ranges::count_if(headland.passes,
                                 [](const HeadlandPass& pass) { return length(pass.path) < 36; });
  };
  EXPECT_EQ(short_ones(made(wedge, terms)), 2);
  const WorkedCorners out = worked(wedge, terms, prices(500));
  EXPECT_EQ(short_ones(out.headland), 1);
  EXPECT_EQ(out.headland.passes.size(), 2U);
}

// An edge as a receiver records it, 2 cm to and fro every 4 m: straight on from the beginning of the arc the
// swath meets the edge at the next point that stands in, from farther back it gets past.
TEST(WorkedCorners, AreReachedAlongRecordedEdges) {
  Ring ring{{0, 0}, {200, 0}};
  for (int i = 1; i < 25; ++i) ring.push_back({200 + (i % 2 == 0 ? 0.02 : -0.02), 4.0 * i});
  ring.insert(ring.end(), {{200, 100}, {0, 100}});
  const Field recorded = field_of(ring);
  const HeadlandTerms terms = terms_of(recorded, kWidth_m, 6, 1);
  const WorkedCorners out = worked(recorded, terms, prices(0));
  EXPECT_EQ(out.headland.passes.size(), 4U);
  EXPECT_LT(out.headland.uncovered_m2, 10) << "strips of some centimetres beside the edge";
}

// Driven the other way round, from the middle of the lower edge: cut there too, and straight on at the other
// side of each corner.
TEST(WorkedCorners, AreWorkedOutEitherWayRound) {
  const HeadlandTerms terms = terms_of(field(), kWidth_m, 6, 1);
  const HeadlandAndBody before = made(field(), terms);
  const Path& pass = before.passes.front().path;
  const double begin_m = nearest_along_m(pass, {100, 0});
  const Path driven = reversed(stretch_of(pass, begin_m, begin_m + length(pass)));
  const WorkedCorners out = with_worked_corners(field(), terms, before, prices(0), {{driven, true}});
  ASSERT_EQ(out.headland.passes.size(), 5U);
  EXPECT_NEAR(out.headland.worked_m2, 200 * 100 - 176 * 76, kArea);
  EXPECT_NEAR(out.headland.uncovered_m2, 0, kArea);
  const Path& first = out.headland.passes.front().path;
  EXPECT_NEAR(distance(first.front().from, {100, 6}), 0, kLength);
  EXPECT_NEAR(distance(first.back().to, {0, 6}), 0, 1e-3);
  EXPECT_NEAR(distance(out.headland.passes.back().path.back().to, {100, 6}), 0, kLength);
}

TEST(NearestAlong, IsFoundOnLinesAndArcs) {
  const Path path{{{0, 0}, {10, 0}, 0}, {{10, 0}, {15, 5}, 1.0 / 5}, {{15, 5}, {15, 20}, 0}};
  EXPECT_NEAR(nearest_along_m(path, {4, 3}), 4, 1e-12);
  EXPECT_NEAR(nearest_along_m(path, {-4, 3}), 0, 1e-12);
  EXPECT_NEAR(nearest_along_m(path, {14, 1}), 10 + 5 * kPi / 4, 1e-12) << "on the ray from (10, 5)";
  EXPECT_NEAR(nearest_along_m(path, {30, 12}), 10 + 5 * kPi / 2 + 7, 1e-12);
  EXPECT_NEAR(nearest_along_m(reversed(path), {14, 1}), 15 + 5 * kPi / 4, 1e-12);
}

// Of two corners 24 m apart, arcs of 12 m between them, one is worked out: nothing of the side is left
// between the two.
TEST(WorkedCorners, LeaveNoPartShorterThanAWidth) {
  const Field narrow = field_of(box(0, 0, 200, 30));
  const HeadlandTerms terms = terms_of(narrow, kWidth_m, 6, 1);
  const WorkedCorners out = worked(narrow, terms, prices(0));
  ASSERT_EQ(out.headland.passes.size(), 2U);
  for (const HeadlandPass& pass : out.headland.passes) EXPECT_GE(length(pass.path), 200 - 24);
}

// The corner of a bay turns to the right and leaves nothing; those beside it are as any.
TEST(WorkedCorners, StraightOnDoesNotEnterObstacles) {
  const Field blocked = field_of(box(0, 0, 200, 100), {box(190, 40, 196, 46)});
  const HeadlandTerms terms = terms_of(blocked, kWidth_m, 6, 1);
  const HeadlandAndBody before = made(blocked, terms);
  const WorkedCorners out = worked(blocked, terms, prices(0));
  EXPECT_GT(out.saved, 0);
  EXPECT_LE(spent(out.headland), spent(before) - out.saved + 1e-6);
}

}  // namespace
}  // namespace tramline::testing
