// How far machines have to back, against ways tried at random.

#include "tramline/route/backing/least_backing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <iostream>
#include <numbers>
#include <optional>

#include "properties/draws.h"
#include "properties/seeds.h"
#include "route/backing/backing_scenes.h"
#include "tramline/route/axle/axle_path.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {
namespace {

using testing::for_each_seed;
using testing::Line;
using testing::north_to;
using testing::random_field_of_sides;
using testing::random_line;
using testing::random_machine_that_backs;
using testing::rectangle_of;
using testing::six_metres;
using testing::south_from;
using testing::towards_deg;

double between(const LeastBacking& backing, const SteeredPath& left, const SteeredPath& entered,
               const Machine& machine) {
  const double least_s = LeastSeconds(machine).forward(end_of(left), entered.front().start);
  return backing.between(backing.left(left), backing.entered(entered), least_s);
}

// At the edge straight ahead a machine has to be r + w/2 = 9 m from it to turn aside, less the 5 cm to which
// room is known; so much it backs out of the one track and into the other, changes gear four times, and goes
// by half a circle of 6 m between.
TEST(LeastBacking, AtTheEdgeIsFarEnoughToTurn) {
  const Machine machine = six_metres();
  const LeastBacking backing(rectangle_of(100, 200), 0, machine);
  const double found_s = between(backing, north_to({40, 200}, 150), south_from({52, 200}, 150), machine);
  const double least_s = 2 * 8.95 / 1 + 4 * 2 + 6 * std::numbers::pi / 1.5;
  EXPECT_LE(found_s, least_s);
  EXPECT_GE(found_s, least_s - 0.3);
  // Land beyond the boundary leaves room; by 9 m all of it.
  const LeastBacking beyond(rectangle_of(100, 200), 4, machine),
      far_beyond(rectangle_of(100, 200), 9, machine);
  EXPECT_NEAR(between(beyond, north_to({40, 200}, 150), south_from({52, 200}, 150), machine), found_s - 8,
              0.2);
  EXPECT_DOUBLE_EQ(between(far_beyond, north_to({40, 200}, 150), south_from({52, 200}, 150), machine),
                   6 * std::numbers::pi / 1.5);
}

// Where the edge is at 60° to the track, r (1 − cos 60°) + w/2 = 6 m from it are enough, which is 6.93 m
// along the track.
TEST(LeastBacking, AtAnObliqueEdgeIsLess) {
  const Machine machine = six_metres();
  const double slope = std::tan(30 * std::numbers::pi / 180);
  const Ring field{{0, 0}, {100, 0}, {100, 200 + 100 * slope}, {0, 200}};
  const LeastBacking backing(field, 0, machine);
  const double at_edge_m = 200 + 40 * slope;
  const LineExit exit = backing.left(north_to({40, at_edge_m}, 150)).whole;
  ASSERT_EQ(exit.near.size(), 1U);
  EXPECT_NEAR(exit.near.front().back_m, (6 - 0.05) / std::cos(30 * std::numbers::pi / 180), 2e-3);
}

// From a track that ends at the edge to a line along it, 3 m farther off: rounding that turns this line by
// less than any machine could makes no difference.
TEST(LeastBacking, DoesNotHangOnHowALineAlongASideIsRounded) {
  const Machine machine = six_metres();
  const LeastBacking backing(rectangle_of(100, 200), 0, machine);
  const auto to_heading = [&](double degrees) {
    const SteeredPath along{arc_from({{60, 197}, towards_deg(degrees)}, 30, 0, Gear::kForward)};
    return between(backing, north_to({40, 200}, 150), along, machine);
  };
  const double exactly_s = to_heading(90);
  EXPECT_GT(exactly_s, 8.95);
  for (const double degrees : {90 - 1e-8, 90 + 1e-8}) EXPECT_NEAR(to_heading(degrees), exactly_s, 1e-3);
}

// Between edges 15 m apart no machine turns round that takes up 6 m and turns by 12 m: it backs all along the
// one track, or drives on to its end and backs into the other.
TEST(LeastBacking, OnAStripIsAllAlongIt) {
  const Machine machine = six_metres();
  const SteeredPath left = north_to({3, 300}, 300), entered = south_from({12, 300}, 300);
  const double strip_s = between(LeastBacking(rectangle_of(15, 300), 0, machine), left, entered, machine);
  EXPECT_GE(strip_s, 300);
  const double wide_s = between(LeastBacking(rectangle_of(18.2, 300), 0, machine), left, entered, machine);
  EXPECT_LT(wide_s, 60);
  // The other way along it goes back to where the second track begins.
  const SteeredPath north = north_to({12, 300}, 300);
  EXPECT_GE(between(LeastBacking(rectangle_of(15, 300), 0, machine), left, north, machine), 300);
}

// A pass goes 285 m along such a strip and then round a corner. The track beside it is to be worked the same
// way: from the pass the machine backs round the corner and all along, or it comes round into line with the
// track and backs all along that. The corner is driven forward only on the latter way: it takes 6.3 s off.
TEST(LeastBacking, OnAStripIsAllAlongItRoundCornersToo) {
  const Machine machine = six_metres();
  SteeredPath pass = north_to({3, 285}, 285);
  pass.push_back(arc_from(end_of(pass.back()), 3 * std::numbers::pi, -1.0 / 6, Gear::kForward));
  ASSERT_NEAR(end_of(pass).at.y, 291, 1e-9);
  const SteeredPath track = north_to({12, 300}, 300), back = south_from({12, 300}, 300);
  const double stops_s = 2 * 2, corner_s = 3 * std::numbers::pi / 1.5;
  const LeastBacking strip(rectangle_of(15, 300), 0, machine);
  EXPECT_GE(between(strip, pass, track, machine), stops_s + 285 - corner_s);
  EXPECT_LE(between(strip, pass, track, machine), stops_s + 285 + 6 * std::numbers::pi);
  EXPECT_NEAR(between(strip, back, turned_round(pass), machine), between(strip, pass, track, machine), 0.2);
  // Where the corner is sharper than the machine turns it never drove round it.
  SteeredPath sharp = north_to({3, 285}, 285);
  sharp.push_back(arc_from(end_of(sharp.back()), 2.5 * std::numbers::pi, -1.0 / 5, Gear::kForward));
  EXPECT_LT(between(strip, sharp, track, machine), 250);
}

// Tracks at 45° to an edge 9 m ahead: to come parallel to it by the obtuse side takes 3 + 6 (1 − cos 45°) =
// 4.8 m, by the acute side 13.2 m. So the machine turns to the right by 45° out of the one track and into the
// other, and half round between: 270° in all at 6 m. Turned by 225° to the right and 45° to the left, or the
// other way round, it is 12 m farther off the edge, or nearer to it, and has the 8.49 m to the other track
// and these 12 m left to drive.
TEST(LeastBacking, WhereBothEndsTurnOneWayIsALoop) {
  Machine machine = six_metres();
  machine.turning.gear_change_s = 10;  // or it would back
  const LeastBacking backing(rectangle_of(400, 200), 0, machine);
  const double apart_m = 6 * std::numbers::sqrt2;
  const auto track = [](Point at, double clockwise_deg) {
    const Heading heading = towards_deg(clockwise_deg);
    return SteeredPath{arc_from({at, heading}, 60, 0, Gear::kForward)};
  };
  const double along_m = 60 / std::numbers::sqrt2;
  const SteeredPath left = track({200 - along_m, 191 - along_m}, 45),
                    entered = track({200 - apart_m, 191}, 225);
  const double loop_m = 1.5 * std::numbers::pi * 6 + std::hypot(apart_m, 12);
  const double found_s = between(backing, left, entered, machine);
  EXPECT_LE(found_s, loop_m / 1.5);
  EXPECT_GE(found_s, loop_m / 1.5 - 0.3);
  // Farther off the edge it may turn the other way.
  const LeastBacking far_off(rectangle_of(400, 205), 0, machine);
  EXPECT_LT(between(far_off, left, entered, machine), loop_m / 1.5 - 3);
}

// A track at 45° to an edge 11 m ahead, and a pass along the edge that leads the other way than the machine
// can turn there (it would take 13.2 m). So it turns by 45° and by half a circle to the pass, which is 40 m
// back and 8 m nearer to the edge. Half round towards the edge, these turns lead to 4.24 m on and 13.76 m
// nearer; half round away from it, to farther off. With land enough it turns by 135°.
TEST(LeastBacking, TurnsRoundToALineAlongTheSide) {
  Machine machine = six_metres();
  machine.turning.gear_change_s = 10;  // or it would back
  const SteeredPath left{arc_from({{100, 150}, towards_deg(45)}, 60, 0, Gear::kForward)};
  const Point end = end_of(left).at;
  const SteeredPath pass{arc_from({end + Point{-40, 8}, towards_deg(270)}, 100, 0, Gear::kForward)};
  const double turns_m = 3 * std::numbers::sqrt2;
  const double loop_m = 1.25 * std::numbers::pi * 6 + std::hypot(40 + turns_m, 18 - turns_m - 8);
  const Ring near = rectangle_of(400, end.y + 11), far = rectangle_of(400, end.y + 14);
  const double found_s = between(LeastBacking(near, 0, machine), left, pass, machine);
  EXPECT_LE(found_s, loop_m / 1.5);
  EXPECT_GE(found_s, loop_m / 1.5 - 0.3);
  // A pass that bends away from the edge after 60 m, by 24°, is along it up to there.
  SteeredPath bends{arc_from(pass.front().start, 60, 0, Gear::kForward)};
  bends.push_back(arc_from(end_of(bends), 5, 1.0 / 12, Gear::kForward));
  EXPECT_DOUBLE_EQ(between(LeastBacking(near, 0, machine), left, bends, machine), found_s);
  EXPECT_EQ(between(LeastBacking(far, 0, machine), left, pass, machine),
            LeastSeconds(machine).forward(end_of(left), pass.front().start));
}

// Where the land asks for two stops they count twice.
TEST(LeastBacking, EachStopCounts) {
  const Machine machine = six_metres();
  const SteeredPath left = north_to({40, 200}, 150), entered = south_from({52, 200}, 150);
  const double found_s = between(LeastBacking(rectangle_of(100, 200), 0, machine), left, entered, machine);
  const double priced_s =
      between(LeastBacking(rectangle_of(100, 200), 0, machine, 5), left, entered, machine);
  EXPECT_NEAR(priced_s, found_s + 10, 0.1);
}

// On a field 24 m wide two tracks run 12 m apart from edge to edge, and the second is to be worked the same
// way as the first. Having backed all along the first the machine stands at the edge, where it can neither
// turn round nor get aside: it stops again to back into the second.
TEST(LeastBacking, FromOneEndToABeginningBesideTheOtherTakesTwoStops) {
  const Machine machine = six_metres();
  constexpr double kStop_s = 100;
  const LeastBacking backing(rectangle_of(24, 60), 0, machine, kStop_s);
  EXPECT_GE(between(backing, north_to({6, 60}, 60), north_to({18, 60}, 60), machine), 2 * kStop_s + 60);
}

// On a strip on which it cannot turn round the machine gets 11.9 m aside by two arcs of 6 m that lead it
// √(11.9 · (4 · 6 − 11.9)) = 12 m on. If the second track begins 13 m farther on than the first it backs 59 m
// of the 60 and stops once; where it begins 2 m farther on, it stops twice.
TEST(LeastBacking, GetsAsideOnlyByGoingOn) {
  Machine machine = six_metres();
  machine.turning.reverse_speed_mps = machine.turning.turning_speed_mps = 3;
  constexpr double kStop_s = 100;
  const LeastBacking backing(rectangle_of(17.9, 60), 0, machine, kStop_s);
  const auto begun_s = [&](double farther_on_m) {
    return between(backing, north_to({3, 60}, 60), north_to({14.9, 60}, 60 - farther_on_m), machine);
  };
  const double turned = std::acos(1 - 11.9 / 12);
  const double aside_s = kStop_s + 2 * 2 + 59.0 / 3 + 2 * 6 * turned / 3;
  EXPECT_LE(begun_s(13), aside_s);
  EXPECT_GE(begun_s(13), aside_s - 0.5);
  EXPECT_GE(begun_s(2), 2 * kStop_s);
}

// On a strip of 16 m a track ends 6 m before where one 10 m beside it begins, driven the same way: arcs of 6
// m take it there √(10 · (4 · 6 − 10)) = 11.8 m on. No side is near, but no way leads forward either, for it
// cannot turn round: it backs 5.8 m, stops, and goes on, be it out of the one or into the other.
TEST(LeastBacking, BacksUntilAWayLeadsForward) {
  Machine machine = six_metres();
  machine.turning.reverse_speed_mps = machine.turning.turning_speed_mps = 3;
  constexpr double kStop_s = 100;
  const SteeredPath left = north_to({3, 100}, 60), entered = north_to({13, 166}, 60);
  const double aside_s = 2 * 6 * std::acos(1 - 10.0 / 12) / 3, backed_s = (std::sqrt(140) - 6) / 3;
  const auto found_s = [&](LeastBacking::Places places) {
    return between(LeastBacking(rectangle_of(16, 200), 0, machine, kStop_s, places), left, entered, machine);
  };
  EXPECT_LE(found_s(LeastBacking::Places::kFollowed), kStop_s + 2 * 2 + backed_s + aside_s);
  EXPECT_GE(found_s(LeastBacking::Places::kFollowed), kStop_s + 2 * 2 + backed_s + aside_s - 0.5);
  EXPECT_LT(found_s(LeastBacking::Places::kNotFollowed), kStop_s);
}

/// On from its end in the same gear, by an arc that the machine can turn, or not.
SteeredPath driven_on(SteeredPath path, const Machine& machine, std::mt19937_64& random) {
  if (any_of(random, 0, 1) == 0) return path;
  const double curvature = uniform(random, -1, 1) / machine.radius_m;
  path.push_back(arc_from(end_of(path.back()), uniform(random, 0, 12), curvature, path.back().gear));
  return path;
}

/// The cheapest of ways tried at random, if one has room, each stop counted besides its time: out of the one
/// line and into the other from any distance along them, or all along and on, by words of Dubins, straight or
/// over another pose.
std::optional<double> cheapest_tried_s(const SteeredPath& left, const SteeredPath& entered, const Ring& field,
                                       const AllowedLand& land, const Machine& machine, double stop_s,
                                       std::mt19937_64& random) {
  const Outline outline = outline_of(machine);
  const Turning& turning = machine.turning;
  const Box box = bounds(field);
  std::optional<double> out_s;
  for (int i = 0; i < 400; ++i) {
    const bool all_out = any_of(random, 0, 5) == 0, all_in = any_of(random, 0, 5) == 0;
    const double out_m =
        all_out ? length(left) : any_of(random, 0, 2) * uniform(random, 0, 0.5 * length(left));
    const double in_m =
        all_in ? length(entered) : any_of(random, 0, 2) * uniform(random, 0, 0.5 * length(entered));
    SteeredPath begin = out_m > 0 ? retraced(part_of(left, length(left) - out_m, length(left)))
                                  : SteeredPath{arc_from(end_of(left), turning.lift_m, 0, Gear::kForward)};
    if (all_out) begin = driven_on(begin, machine, random);
    const Pose before = moved_on(entered.front().start, -turning.lower_m);
    SteeredPath end = in_m > 0 ? retraced(part_of(entered, 0, in_m))
                               : SteeredPath{arc_from(before, turning.lower_m, 0, Gear::kForward)};
    if (all_in) end = retraced(driven_on(retraced(end), machine, random));
    const double stops_s = stop_s * ((out_m > 0 ? 1 : 0) + (in_m > 0 ? 1 : 0));
    const Pose from = end_of(begin), to = end.front().start;
    const Pose over{{uniform(random, box.min_x, box.max_x), uniform(random, box.min_y, box.max_y)},
                    towards_deg(uniform(random, 0, 360))};
    const bool straight = any_of(random, 0, 2) == 0;
    for (const Manoeuvre& first : dubins_words(from, straight ? to : over, machine.radius_m)) {
      SteeredPath path = begin;
      path.insert(path.end(), first.path.begin(), first.path.end());
      if (!straight) {
        if (!land.fits(path, outline)) continue;
        const Manoeuvre second = shortest_dubins(over, to, machine.radius_m);
        path.insert(path.end(), second.path.begin(), second.path.end());
      }
      path.insert(path.end(), end.begin(), end.end());
      if (land.fits(path, outline))
        out_s = std::min(out_s.value_or(1e9), stops_s + idle_seconds(path, turning));
    }
  }
  return out_s;
}

TEST(LeastBacking, IsNoMoreThanAnyWayTried) {
  int compared = 0, bounded = 0, bent = 0, behind_bends = 0, near = 0, more = 0;
  for_each_seed(500, [&](std::mt19937_64& random, int) {
    const Machine machine = random_machine_that_backs(random);
    const Ring field = random_field_of_sides(random);
    const AllowedLand land({{field, {}}});
    const auto left = random_line(field, land, machine, random),
               entered = random_line(field, land, machine, random);
    if (!left || !entered) return;
    // A line that is entered is one that is left, driven from its end.
    const SteeredPath back = turned_round(entered->driven);
    const double stop_s = any_of(random, 0, 2) * uniform(random, 0, 60);
    const LeastBacking backing(field, 0, machine, stop_s),
        following(field, 0, machine, stop_s, LeastBacking::Places::kFollowed);
    const double least_s = LeastSeconds(machine, stop_s).between(end_of(left->driven), back.front().start);
    const auto bound_s = [&](const LeastBacking& by) {
      return by.between(by.left(left->driven), by.entered(back), least_s);
    };
    const double found_s = bound_s(following);
    EXPECT_GE(bound_s(backing), least_s);
    const double divided_s = kDivided_s + kDividedShare * found_s;  // what either may be found less
    EXPECT_GE(found_s, bound_s(backing) - divided_s);
    if (found_s > bound_s(backing) + divided_s) ++more;
    if (found_s > least_s) ++bounded;
    if (found_s == least_s) return;
    const auto tried_s = cheapest_tried_s(left->driven, back, field, land, machine, stop_s, random);
    if (!tried_s) return;
    ++compared;
    if (left->bent || entered->bent) ++bent;
    if (backing.left(left->driven).behind_bend || backing.entered(back).behind_bend) ++behind_bends;
    EXPECT_LE(found_s, *tried_s);
    if (*tried_s < 1.1 * found_s) ++near;
  });
  std::cout << bounded << " bounded by the sides (" << more << " of them more where places are followed), "
            << compared << " compared (" << bent << " bent, " << behind_bends << " far), " << near
            << " ways within a tenth of their bound\n";
  if (testing::case_count(500) < 500) return;
  EXPECT_GT(compared, 30);
  EXPECT_GT(bent, 15);
  EXPECT_GT(behind_bends, 5);
  EXPECT_GT(near, 2);
  EXPECT_GT(more, 30);
}

}  // namespace
}  // namespace tramline
