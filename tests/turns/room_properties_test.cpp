// Room for turns against points of the outline looked at one by one, close together, on random land.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>
#include <numbers>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/turns/outline/swept_outline.h"
#include "tramline/turns/outline/swept_reach.h"
#include "tramline/turns/room/allowed_land.h"

namespace tramline {
namespace {

using testing::case_count;
using testing::for_each_seed;

enum class Steering { kLinesAndArcs, kClothoidsToo };

SteeredPath random_path(std::mt19937_64& random, Steering steering, bool towed) {
  SteeredPath out;
  Pose at{{uniform(random, -3, 3), uniform(random, -3, 3)},
          Heading::clockwise_from_north(Angle::degrees(uniform(random, 0, 360)))};
  double curvature = 0;
  const int stretches = any_of(random, 1, 4);
  for (int i = 0; i < stretches; ++i) {
    const int kind = any_of(random, 0, steering == Steering::kClothoidsToo ? 3 : 2);
    const Gear gear = !towed && any_of(random, 0, 3) == 0 ? Gear::kReverse : Gear::kForward;
    const double next = kind == 0 ? 0 : (any_of(random, 0, 1) == 0 ? -1 : 1) / uniform(random, 4, 12);
    const double from = kind == 3 ? curvature : next;
    const double length = any_of(random, 0, 4) == 0 ? uniform(random, 0, 35) : uniform(random, 0.5, 12);
    out.push_back({at, length, from, next, gear});
    curvature = next;
    at = end_of(out.back());
  }
  return out;
}

Machine random_machine(std::mt19937_64& random, bool towed) {
  Machine out;
  out.width_m = any_of(random, 0, 2) == 0 ? uniform(random, 12, 28) : uniform(random, 2, 9);
  const auto sometimes = [&](double most) { return any_of(random, 0, 1) * uniform(random, 0, most); };
  out.turning.implement_offset_m = any_of(random, 0, 4) == 0 ? -sometimes(2) : sometimes(3);
  out.turning.rear_overhang_m = sometimes(2);
  out.turning.front_overhang_m = sometimes(4);
  out.turning.vehicle_width_m = sometimes(3);
  if (towed) {
    out.turning.implement = Coupling::kTowed;
    out.turning.drawbar_m = uniform(random, 2, 7);
  }
  return out;
}

/// A star about the start, with a few obstacles: from pylons to ponds, some as sharp as needles.
Region random_land(std::mt19937_64& random) {
  const double size = uniform(random, 12, 45);
  Polygon out{
      testing::random_star(random, {0, 0}, uniform(random, 0.3, 1) * size, size, any_of(random, 4, 14)), {}};
  const int obstacles = any_of(random, 0, 3);
  for (int i = 0; i < obstacles; ++i) {
    const Point at{uniform(random, -30, 30), uniform(random, -30, 30)};
    const double radius = any_of(random, 0, 1) == 0 ? 0.14 : uniform(random, 0.3, 4);
    Polygon obstacle{testing::random_star(random, at, 0.4 * radius, radius, any_of(random, 4, 7)), {}};
    if (length(at) < 2 || !contains(out, at) || distance_to_ring({obstacle}, out.outer) < 0.2) continue;
    bool clear = true;
    for (const Ring& hole : out.holes) clear = clear && distance_between({obstacle}, {{hole, {}}}) > 0.2;
    if (clear) out.holes.push_back(reversed(obstacle.outer));
  }
  return {out};
}

/// Distances from land by looking at each of its edges.
class Distances {
 public:
  explicit Distances(const Region& land) {
    for (const Ring& ring : rings_of(land))
      for (std::size_t i = 0; i < ring.size(); ++i) edges_.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
  }
  /// Positive outside: even-odd.
  double of(Point p) const {
    double least = 1e9;
    bool inside = false;
    for (const auto& [a, b] : edges_) {
      least = std::min(least, distance_to_segment(p, a, b));
      if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
    }
    return inside ? -least : least;
  }

 private:
  std::vector<std::pair<Point, Point>> edges_;
};

/// Raises `best` to the greatest distance from the land of points a centimetre apart on a part's four sides,
/// but for points nearer to one looked at than half of what its distance is less than the best. Returns a
/// bound of the distances of all points of the sides, looked at or not.
double raise_by_sides(double& best, const Distances& land, Point at, Point ahead, double rear, double front,
                      double half) {
  constexpr double kStep_m = 0.01;
  const Point left = left_of(ahead);
  const Ring corners{at + rear * ahead - half * left, at + front * ahead - half * left,
                     at + front * ahead + half * left, at + rear * ahead + half * left};
  double out = -1e9;
  for (std::size_t i = 0; i < 4; ++i) {
    const Point from = corners[i], to = corners[(i + 1) % 4];
    const double end = distance(from, to);
    for (double s = 0;; s = std::min(s, end)) {
      const double off = land.of(end > 0 ? from + (s / end) * (to - from) : from);
      best = std::max(best, off);
      const double skipped = std::max(kStep_m, 0.5 * (best - off));
      out = std::max(out, off + skipped);
      if (s >= end) break;
      s += skipped;
    }
  }
  return out;
}

struct Seen {
  double distance_m = -1e9;
  int poses = 0;
};

/// The same over all poses, half a centimetre apart, but for those too near one that is far from the best.
/// The implement is pulled along by its hitch in small steps.
Seen seen_along(const Distances& land, const SteeredPath& path, const Machine& machine) {
  const Turning& turning = machine.turning;
  const bool towed = turning.implement == Coupling::kTowed;
  const double half = 0.5 * machine.width_m;
  // no point of the outline drives faster than this against the axle
  const double quickest = 1.5 + (half + 12) / 3;
  Seen out;
  Point implement = path.front().start.at -
                    (turning.implement_offset_m + turning.drawbar_m) * path.front().start.heading.unit();
  for (const SteeredStretch& stretch : path) {
    double look_again_at = 0;
    const double steps = std::ceil(stretch.length_m / 0.005) + 1;
    for (double i = 0; i <= steps; ++i) {
      const double s = i / steps * stretch.length_m;
      if (!towed && s < look_again_at && i < steps) continue;
      const Pose pose = pose_after(stretch, s);
      const Point ahead = pose.heading.unit();
      const Point hitch = pose.at - turning.implement_offset_m * ahead;
      Point drawbar = ahead;
      if (towed) {
        const Point pull = hitch - implement;
        // to the second order: along the mean of the drawbar before and after
        const double way = length(pull) - turning.drawbar_m;
        const Point first = implement + (way / length(pull)) * pull;
        const Point mean =
            midpoint((1 / length(pull)) * pull, (1 / distance(first, hitch)) * (hitch - first));
        implement =
            implement +
            (dot(pull, mean) -
             std::sqrt(std::max(
                 0.0, dot(pull, mean) * dot(pull, mean) -
                          dot(mean, mean) * (dot(pull, pull) - turning.drawbar_m * turning.drawbar_m)))) /
                dot(mean, mean) * mean;
        drawbar = (1 / distance(implement, hitch)) * (hitch - implement);
      }
      if (s < look_again_at && i < steps) continue;
      ++out.poses;
      const Point bar = towed ? implement : hitch;
      const auto raise = [&](Point from, Point heading, double rear, double front, double half_m) {
        return raise_by_sides(out.distance_m, land, from, heading, rear, front, half_m);
      };
      double here = raise(bar, drawbar, -turning.rear_overhang_m, 0, half);
      if (towed) here = std::max(here, raise(bar, drawbar, 0, turning.drawbar_m, 0));
      if (turning.front_overhang_m > 0 || turning.vehicle_width_m > 0)
        here =
            std::max(here, raise(pose.at, ahead, 0, turning.front_overhang_m, 0.5 * turning.vehicle_width_m));
      look_again_at = s + std::max(0.0, out.distance_m - here) / quickest;
    }
  }
  return out;
}

struct Count {
  int fits = 0;
  int leaves = 0;
  int too_close = 0;
};

void expect_as_seen(Count& count, std::mt19937_64& random, Steering steering, bool towed) {
  const SteeredPath path = random_path(random, steering, towed);
  const Machine machine = random_machine(random, towed);
  const Region land = random_land(random);
  const Outline outline = outline_of(machine);
  const AllowedLand allowed(land);
  const Seen seen = seen_along(Distances(land), path, machine);
  const bool fits = allowed.fits(path, outline);
  constexpr double kLook_m = 0.03;
  if (std::abs(seen.distance_m) < kLook_m) {
    ++count.too_close;
  } else {
    EXPECT_EQ(fits, seen.distance_m < 0) << "seen " << seen.distance_m;
    if (!towed) {
      EXPECT_EQ(fits, allowed.fits(retraced(path), outline)) << "driven back it sweeps the same land";
    }
    ++(fits ? count.fits : count.leaves);
  }
  if (seen.distance_m > 0) {
    const double missing_m = allowed.missing_m(path, outline);
    EXPECT_NEAR(missing_m, seen.distance_m, 0.04);
    for (const double share : {0.3, 1.5}) {  // enough is known before all is
      const double known_m = allowed.missing_m(path, outline, share * missing_m);
      EXPECT_GE(known_m, std::min(share, 1.0) * missing_m);
      EXPECT_LE(known_m, missing_m);
    }
    for (const double roughly : {0.01, 0.1, 0.5}) {
      const double roughly_m =
          allowed.missing_m(path, outline, std::numeric_limits<double>::infinity(), roughly);
      EXPECT_LE(roughly_m, missing_m + 0.02);
      EXPECT_LE(missing_m, roughly_m + std::max(0.02, roughly * roughly_m));
    }
  }
}

void expect_enough(const Count& count, const char* what) {
  std::cout << what << ": " << count.fits << " fit, " << count.leaves << " leave the land, "
            << count.too_close << " too close to tell by looking\n";
  const int all = count.fits + count.leaves + count.too_close;
  if (all < 40) return;
  EXPECT_GT(count.fits, all / 8);
  EXPECT_GT(count.leaves, all / 8);
  EXPECT_LT(count.too_close, all / 10);
}

TEST(RoomProperties, OnLinesAndArcsItIsAsSeen) {
  Count count;
  for_each_seed(80, [&](std::mt19937_64& random, int) {
    expect_as_seen(count, random, Steering::kLinesAndArcs, false);
  });
  expect_enough(count, "lines and arcs");
}

TEST(RoomProperties, OnClothoidsItIsAsSeen) {
  Count count;
  for_each_seed(60, [&](std::mt19937_64& random, int) {
    expect_as_seen(count, random, Steering::kClothoidsToo, false);
  });
  expect_enough(count, "clothoids too");
}

TEST(RoomProperties, OfTowedImplementsItIsAsSeen) {
  Count count;
  for_each_seed(40, [&](std::mt19937_64& random, int) {
    expect_as_seen(count, random, Steering::kClothoidsToo, true);
  });
  expect_enough(count, "towed");
}

/// Land whose only edge nearby is a line, somewhere near the reach of the outline.
TEST(RoomProperties, BeforeALineItIsTheReach) {
  for_each_seed(2000, [&](std::mt19937_64& random, int) {
    const int kind = any_of(random, 0, 3);
    const bool towed = kind == 0, clothoids = kind == 1;
    const SteeredPath path =
        random_path(random, clothoids ? Steering::kClothoidsToo : Steering::kLinesAndArcs, towed);
    const Outline outline = outline_of(random_machine(random, towed));
    const double angle = uniform(random, 0, 2 * std::numbers::pi);
    const Point to{std::cos(angle), std::sin(angle)}, side = left_of(to);
    const double reach = swept_reach_m(path, outline, {0, 0}, to);
    // the edge is divided somewhere, so that what lies between corners counts too
    const auto land_to = [&](double far) {
      const Point middle = far * to + uniform(random, -20, 20) * side;
      return AllowedLand({{{far * to - 400 * side, middle, far * to + 400 * side, -400 * to + 400 * side,
                            -400 * to - 400 * side},
                           {}}});
    };
    const bool bounded = towed || clothoids;
    EXPECT_TRUE(land_to(reach).fits(path, outline));
    EXPECT_FALSE(land_to(reach - (bounded ? 1.1e-3 : 1.1e-6)).fits(path, outline));
    const double less = uniform(random, 0.05, 4);
    EXPECT_NEAR(land_to(reach - less).missing_m(path, outline), less, 0.021);
  });
}

/// Land grown by the distance that is missing has room, and by less than that it has none.
TEST(RoomProperties, WithTheMissingRoomAddedItFits) {
  int looked_at = 0;
  for_each_seed(400, [&](std::mt19937_64& random, int) {
    const int kind = any_of(random, 0, 3);
    const bool towed = kind == 0;
    const SteeredPath path =
        random_path(random, kind == 1 ? Steering::kClothoidsToo : Steering::kLinesAndArcs, towed);
    const Outline outline = outline_of(random_machine(random, towed));
    const Region land = {{random_land(random).front().outer, {}}};  // GEOS drops what is left of small holes
    const double missing = AllowedLand(land).missing_m(path, outline);
    if (missing < 0.05 || missing > 6) return;
    ++looked_at;
    constexpr int kChords = 64;  // of a quarter circle
    const double of_buffer =
        0.015 * missing;  // GEOS leaves out what matters less than a hundredth of the distance
    const auto grown = [&](double by_m) {
      return AllowedLand(buffered(land, by_m, JoinStyle::kRound, kChords));
    };
    EXPECT_TRUE(grown(missing + of_buffer + 0.023).fits(path, outline)) << missing;
    EXPECT_FALSE(grown(missing - of_buffer - 0.003).fits(path, outline)) << missing;
  });
  if (case_count(400) >= 100) {
    EXPECT_GT(looked_at, case_count(400) / 20);
  }
}

TEST(RoomProperties, EdgesLieBetweenPointsOfWhichOneIsOnTheLand) {
  for_each_seed(300, [](std::mt19937_64& random, int) {
    const Region land = random_land(random);
    const Distances distances(land);
    const LandEdges edges(land);
    for (int i = 0; i < 50; ++i) {
      const Point a{uniform(random, -50, 50), uniform(random, -50, 50)};
      const double reach = any_of(random, 0, 1) == 0 ? 2 : 40;
      const Point b = a + Point{uniform(random, -reach, reach), uniform(random, -reach, reach)};
      EXPECT_EQ(edges.lie_between(a, b), (distances.of(a) < 0) != (distances.of(b) < 0));
      EXPECT_EQ(edges.contains(a), distances.of(a) < 0);
    }
  });
}

TEST(RoomProperties, EdgesLieBetweenPointsAlsoInLineWithThem) {
  const LandEdges edges({{{{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {}}});
  const std::vector<std::vector<Point>> ways{{{-1, 0}, {1, 0}, {1.5, -1}, {5, -5}},
                                             {{-1, -1}, {0, 0}, {1, -0.5}, {1, 0.5}},
                                             {{2, -1}, {2, 0.5}, {1, 0.5}, {2, 1}, {3, 1}},
                                             {{1, 0.5}, {1, 0.5}}};
  for (const std::vector<Point>& way : ways) {
    bool inside = edges.contains(way.front());
    for (std::size_t i = 1; i < way.size(); ++i) {
      inside = inside != edges.lie_between(way[i - 1], way[i]);
      EXPECT_EQ(inside, edges.contains(way[i])) << way[i].x << ", " << way[i].y;
    }
  }
}

TEST(RoomProperties, ThePolygonsOfTheOutlineReachAsFar) {
  for_each_seed(12, [&](std::mt19937_64& random, int) {
    const int kind = any_of(random, 0, 2);
    const bool towed = kind == 0;
    const SteeredPath path =
        random_path(random, kind == 1 ? Steering::kClothoidsToo : Steering::kLinesAndArcs, towed);
    Machine machine = random_machine(random, towed);
    // what has no width sweeps nothing along itself
    machine.turning.vehicle_width_m = std::max(1.0, machine.turning.vehicle_width_m);
    const Outline outline = outline_of(machine);
    const Box box = bounds(swept_outline(path, outline, 0.05));
    EXPECT_NEAR(box.max_x, swept_reach_m(path, outline, {0, 0}, {1, 0}), 0.051);
    EXPECT_NEAR(box.max_y, swept_reach_m(path, outline, {0, 0}, {0, 1}), 0.051);
    EXPECT_NEAR(-box.min_x, swept_reach_m(path, outline, {0, 0}, {-1, 0}), 0.051);
    EXPECT_NEAR(-box.min_y, swept_reach_m(path, outline, {0, 0}, {0, -1}), 0.051);
  });
}

}  // namespace
}  // namespace tramline
