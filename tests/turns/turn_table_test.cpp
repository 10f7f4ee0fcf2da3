#include "tramline/turns/turn_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

constexpr double kPi = std::numbers::pi;

Machine bar(double width_m, double radius_m) {
  Machine out;
  out.width_m = width_m;
  out.radius_m = radius_m;
  return out;
}

Machine reversing(Machine machine) {
  machine.turning.reverse = true;
  return machine;
}

const TurnRow* row_of_kind(const std::vector<TurnRow>& rows, ManoeuvreKind kind) {
  for (const TurnRow& row : rows)
    if (row.manoeuvre.kind == kind) return &row;
  return nullptr;
}

/// The farthest of the axle and of the ends of the bar that it carries, square to a border at `border`,
/// looked at in small steps.
std::pair<double, double> depths_seen(const SteeredPath& path, double width_m, Angle border) {
  const Point unit{-std::cos(border.radians()), std::sin(border.radians())};
  double axle = -1e9, bar_end = -1e9;
  for (const SteeredStretch& stretch : path)
    for (int i = 0; i <= 4000; ++i) {
      const Pose pose = pose_after(stretch, stretch.length_m * i / 4000);
      axle = std::max(axle, dot(pose.at, unit));
      for (const double side : {-width_m / 2, width_m / 2})
        bar_end = std::max(bar_end, dot(pose.at + side * left_of(pose.heading.unit()), unit));
    }
  return {axle, bar_end};
}

// r = 6, s = 3: the omega's third circle touches both others, whose centres are 2r + s apart, so its centre
// is sqrt(4r² − (r + s/2)²) beyond theirs and its far side another r: 6 + sqrt(144 − 56.25) = 15.3675 m. The
// bar lies along the radius there: half of 3 m more.
TEST(TurnTable, OmegaToTheNextTrack) {
  const auto rows = turn_table(bar(3, 6), {{3}});
  ASSERT_FALSE(rows.empty());
  const TurnRow& best = rows.front();
  EXPECT_EQ(best.manoeuvre.kind, ManoeuvreKind::kOmega);
  EXPECT_NEAR(best.axle_depth_m, 6 + std::sqrt(144 - 56.25), 1e-9);
  EXPECT_NEAR(best.depth_m, 7.5 + std::sqrt(144 - 56.25), 1e-9);
  EXPECT_EQ(best.passes, 6);
  EXPECT_EQ(best.gear_changes, 0);
  // Both outer arcs turn by acos((r + s/2)/2r), the middle one by a half circle and twice that.
  const double outer = std::acos(7.5 / 12);
  EXPECT_NEAR(best.length_m, 6 * (kPi + 4 * outer), 1e-9);
  EXPECT_NEAR(best.time_s, best.length_m / 1.5, 1e-9);
}

// s = 12 = 2r: half a circle of 6 m, and half of the bar.
TEST(TurnTable, HalfACircleOverFourWidths) {
  const auto rows = turn_table(bar(3, 6), {{12}});
  EXPECT_EQ(rows.front().manoeuvre.kind, ManoeuvreKind::kU);
  EXPECT_NEAR(rows.front().axle_depth_m, 6, 1e-9);
  EXPECT_NEAR(rows.front().depth_m, 7.5, 1e-9);
  EXPECT_EQ(rows.front().passes, 3);
  EXPECT_NEAR(rows.front().length_m, 6 * kPi, 1e-9);
}

// Two quarter circles with 2r − s = 9 m of reverse between them: as deep as the U.
TEST(TurnTable, FishtailToTheNextTrack) {
  const auto rows = turn_table(reversing(bar(3, 6)), {{3}});
  const TurnRow* fishtail = row_of_kind(rows, ManoeuvreKind::kFishtail);
  ASSERT_NE(fishtail, nullptr);
  EXPECT_NEAR(fishtail->depth_m, 7.5, 1e-9);
  EXPECT_EQ(fishtail->passes, 3);
  EXPECT_EQ(fishtail->gear_changes, 2);
  EXPECT_NEAR(fishtail->length_m, 6 * kPi + 9, 1e-9);
  EXPECT_NEAR(fishtail->time_s, 6 * kPi / 1.5 + 9 / 1.0 + 2 * 3, 1e-9);
  EXPECT_LE(rows[shallowest(rows)].depth_m, 7.5 + 1e-9);
}

TEST(TurnTable, EightNeighboursWithoutFurtherWord) {
  const auto best = quickest_of_each(turn_table(bar(3, 6), {}));
  ASSERT_EQ(best.size(), 8U);
  for (std::size_t k = 0; k < 8; ++k) {
    EXPECT_DOUBLE_EQ(best[k].spacing_m, 3.0 * static_cast<double>(k + 1));
    // Omegas get shallower up to 2r, Us need the same from there on.
    EXPECT_EQ(best[k].manoeuvre.kind, k < 3 ? ManoeuvreKind::kOmega : ManoeuvreKind::kU);
    if (k > 0) {
      EXPECT_LE(best[k].depth_m, best[k - 1].depth_m + 1e-9);
    }
  }
}

TEST(TurnTable, QuickestFirstAndNoneTwice) {
  const auto rows = turn_table(reversing(bar(3, 6)), {{3, 6, 12}});
  for (std::size_t i = 1; i < rows.size(); ++i)
    if (rows[i].spacing_m == rows[i - 1].spacing_m) {
      EXPECT_GE(rows[i].time_s, rows[i - 1].time_s - 1e-6);
    }
  EXPECT_EQ(rows_of(rows, 6).front().spacing_m, 6);
  EXPECT_TRUE(rows_of(rows, 7).empty());
}

// Lift and offset take the axle over the border before it turns, and the bar with the lift alone.
// A machine that reverses may turn on its tracks and needs no headland at all: such turns are listed, but are
// neither the quickest nor the shallowest where another stays beyond the border.
TEST(TurnTable, TurnsOverTheTracksAreNotTheBest) {
  const auto rows = turn_table(reversing(bar(3, 6)), {{3}});
  const auto back = [](const TurnRow& row) {
    double lowest = 0;
    for (const SteeredStretch& stretch : row.manoeuvre.path)
      for (int i = 0; i <= 4000; ++i)
        lowest = std::min(lowest, pose_after(stretch, stretch.length_m * i / 4000).at.y);
    return -lowest;
  };
  std::size_t over_tracks = 0;
  for (const TurnRow& row : rows) {
    EXPECT_NEAR(row.back_m, back(row), 1e-4) << row.manoeuvre.word;
    if (row.back_m > kStaysOffTracks_m) ++over_tracks;
  }
  EXPECT_GT(over_tracks, 0U);
  EXPECT_LT(over_tracks, rows.size());
  for (const std::size_t best : {quickest(rows), shallowest(rows)}) {
    EXPECT_LE(rows[best].back_m, kStaysOffTracks_m);
    EXPECT_GT(rows[best].depth_m, 3);
  }
  for (const TurnRow& row : rows) {
    if (row.back_m > kStaysOffTracks_m) continue;
    EXPECT_GE(row.time_s, rows[quickest(rows)].time_s - 1e-9);
    EXPECT_GE(row.depth_m, rows[shallowest(rows)].depth_m - 1e-8);
  }
}

TEST(TurnTable, LiftAndOffsetAreDrivenFirst) {
  Machine machine = bar(3, 6);
  machine.turning.lift_m = machine.turning.lower_m = 2;
  machine.turning.implement_offset_m = 1.5;
  const Pose begins = turn_begins(machine), ends = turn_ends(machine, 12, Angle::degrees(90));
  EXPECT_NEAR(begins.at.y, 3.5, 1e-12);
  EXPECT_NEAR(ends.at.y, 2 - 1.5, 1e-12);
  const TurnRow row = turn_table(machine, {{12}}).front();
  // 3.5 m out, then turns of 6 m: at least 9.5 m.
  EXPECT_GE(row.axle_depth_m, 9.5 - 1e-9);
  EXPECT_LT(row.axle_depth_m, 9.6);
}

// A rigid vehicle 4 m ahead of the axle and 2 m wide, r = 6, in a half circle: its front corners are
// sqrt(4² + 7²) = 8.062 m from the centre, farther than the bar's end at 7.5 m.
TEST(TurnTable, TheFrontOfTheVehicleSwingsOut) {
  Machine machine = bar(3, 6);
  machine.turning.front_overhang_m = 4;
  machine.turning.vehicle_width_m = 2;
  EXPECT_NEAR(turn_table(machine, {{12}}).front().depth_m, std::sqrt(16.0 + 49), 1e-9);
}

TEST(TurnTable, ObliqueBordersByLookingInSmallSteps) {
  for (const double degrees : {20.0, 45.0, 60.0, 75.0, 90.0, 110.0, 135.0, 150.0}) {
    const Angle border = Angle::degrees(degrees);
    for (const TurnRow& row : turn_table(reversing(bar(3, 6)), {{3, 9, 15}, border})) {
      SCOPED_TRACE(testing::Message() << degrees << "°, " << row.spacing_m << " m, "
                                      << name(row.manoeuvre.kind) << ' ' << row.manoeuvre.word);
      const auto [axle, bar_end] = depths_seen(row.manoeuvre.path, 3, border);
      EXPECT_NEAR(row.axle_depth_m, axle, 1e-4);
      EXPECT_NEAR(row.depth_m, std::max(0.0, bar_end), 1e-4);
      // Both tracks end on the border.
      const Pose ends = end_of(row.manoeuvre.path.back());
      EXPECT_NEAR(ends.at.x, row.spacing_m, 1e-9);
      EXPECT_NEAR(ends.at.y, row.spacing_m / std::tan(border.radians()), 1e-8);
    }
  }
}

// Where the next track ends earlier and where it reaches farther the turn is the same, driven the other way.
TEST(TurnTable, BordersThatLeanEitherWayNeedTheSame) {
  for (const double lean : {10.0, 30.0, 50.0}) {
    const auto left = quickest_of_each(turn_table(bar(3, 6), {{3, 12}, Angle::degrees(90 - lean)}));
    const auto right = quickest_of_each(turn_table(bar(3, 6), {{3, 12}, Angle::degrees(90 + lean)}));
    ASSERT_EQ(left.size(), right.size());
    for (std::size_t i = 0; i < left.size(); ++i) {
      EXPECT_NEAR(left[i].length_m, right[i].length_m, 1e-8);
      EXPECT_NEAR(left[i].depth_m, right[i].depth_m, 1e-8);
    }
  }
}

TEST(TurnTable, ATowedImplementIsNotReversedAndRunsIn) {
  Machine machine = reversing(bar(3, 6));
  machine.turning.implement = Coupling::kTowed;
  machine.turning.drawbar_m = 4;
  const auto rows = turn_table(machine, {{3, 12}});
  ASSERT_FALSE(rows.empty());
  for (const TurnRow& row : rows) {
    EXPECT_EQ(row.gear_changes, 0);
    ASSERT_TRUE(row.run_in_m.has_value());
    EXPECT_GT(*row.run_in_m, 0);
  }
  EXPECT_FALSE(turn_table(bar(3, 6), {{3}}).front().run_in_m.has_value());
}

TEST(TurnTable, WholePassesAreNotRoundedUp) {
  EXPECT_EQ(passes_for(7.5, 2.5), 3);
  EXPECT_EQ(passes_for(7.5 + 1e-10, 2.5), 3);
  EXPECT_EQ(passes_for(7.5 + 1e-6, 2.5), 4);
  EXPECT_EQ(passes_for(0, 3), 0);
}

}  // namespace
}  // namespace tramline
