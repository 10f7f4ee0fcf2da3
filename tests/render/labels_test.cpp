#include "tramline/render/page/labels.h"

#include <gtest/gtest.h>

#include <set>

#include "sample_plan.h"

namespace tramline::render {
namespace {

Plan dense_plan(int tracks, double length_m) {
  Plan plan;
  for (int i = 0; i < tracks; ++i)
    plan.pieces.push_back(i % 2 == 0 ? TrackPiece{{3.0 * i, 0}, {3.0 * i, length_m}, 0, i}
                                     : TrackPiece{{3.0 * i, length_m}, {3.0 * i, 0}, 0, i});
  return plan;
}

void expect_apart(const std::vector<TrackLabel>& labels) {
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_FALSE(intersects(labels[i].box, labels[j].box)) << labels[i].text << " on " << labels[j].text;
}

TEST(TrackLabels, EveryTrackWhereThereIsRoom) {
  const auto labels = place_track_labels(dense_plan(20, 100), {{0, 0}, {0, 0}, 10}, 1, {});
  EXPECT_EQ(labels.size(), 20u);
  EXPECT_EQ(labels.front().text, "1");
  expect_apart(labels);
}

TEST(TrackLabels, ThinnedToARoundStrideWhereTracksAreDense) {
  for (const double px_per_m : {4.0, 2.0, 0.5, 0.1}) {
    const auto labels =
        place_track_labels(dense_plan(400, 100 / px_per_m), {{0, 0}, {0, 0}, px_per_m}, 1, {});
    expect_apart(labels);
    ASSERT_GE(labels.size(), 2u);
    const int stride = std::stoi(labels[1].text);
    EXPECT_TRUE((std::set<int>{2, 5, 10, 20, 50, 100, 200}.count(stride))) << stride;
    for (std::size_t i = 1; i < labels.size(); ++i) EXPECT_EQ(std::stoi(labels[i].text) % stride, 0);
  }
}

TEST(TrackLabels, KeepOffWhatIsTaken) {
  const Box everything{-1e6, -1e6, 1e6, 1e6};
  EXPECT_TRUE(place_track_labels(dense_plan(50, 100), {{0, 0}, {0, 0}, 10}, 1, {everything}).empty());
  EXPECT_TRUE(place_track_labels(Plan{}, {{0, 0}, {0, 0}, 10}, 1, {}).empty());
}

TEST(Badges, StandInsideTheirSubfield) {
  Plan plan = sample_plan();
  // A U: the middle of its box is outside it.
  const Ring u{{0, 0}, {60, 0}, {60, 60}, {50, 60}, {50, 10}, {10, 10}, {10, 60}, {0, 60}};
  plan.subfields = {{{u, {}}, Direction::clockwise_from_north(Angle::degrees(0))},
                    {{box(70, 0, 70.5, 40), {}}, Direction::clockwise_from_north(Angle::degrees(0))}};
  const MapView view{{0, 0}, {0, 0}, 8};
  const auto badges = place_badges(plan, view, 1);
  ASSERT_EQ(badges.size(), 1u) << "half a metre at 8 px/m has no room for a number";
  EXPECT_EQ(badges[0].subfield, 0U);
  EXPECT_TRUE(contains(u, Point{badges[0].centre.x / 8, -badges[0].centre.y / 8}));
}

}  // namespace
}  // namespace tramline::render
