// Tracks parallel to random references: what they keep at every point, and polygon booleans as a second
// opinion on where they run.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>

#include "geometry/drivable.h"
#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/random_reference.h"
#include "properties/seeds.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/path/extended_line.h"
#include "tramline/geometry/path/smoothed_line.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::parallel_properties_test {

constexpr Box kWindow{-80, -80, 80, 80};

std::vector<Point> random_line(std::mt19937_64& random) {
  const double most = uniform(random, 0.3, 1.6);
  std::vector<Point> out{{uniform(random, -60, 60), uniform(random, -60, 60)}};
  double heading = uniform(random, -3.2, 3.2);
  for (int i = any_of(random, 1, 12); i > 0; --i) {
    out.push_back(out.back() + uniform(random, 1, 50) * Point{std::cos(heading), std::sin(heading)});
    heading += uniform(random, -most, most);
  }
  return out;
}

struct Scene {
  Path reference;
  TrackLimits limits;
};

/// nullopt where the machine cannot drive it, or where it crosses itself when extended.
std::optional<Scene> random_scene(std::mt19937_64& random, bool as_wide_as_it_turns, double margin) {
  Scene out;
  out.limits.width_m = uniform(random, 1, 8);
  out.limits.radius_m = as_wide_as_it_turns ? 0 : uniform(random, 0, 9);
  if (as_wide_as_it_turns) out.limits.sharpest_corner = Angle::degrees(180);
  const double tolerance = any_of(random, 0, 1) * uniform(random, 0, 1);
  const std::vector<Point> line = random_line(random);
  const auto reference =
      reference_beyond(kWindow.grown(margin), line, out.limits.least_radius_m(), tolerance);
  if (!reference) return std::nullopt;
  out.reference = *reference;
  return out;
}

double distance_to(const Path& path, Point p) {
  double least = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) least = std::min(least, distance_to_edge(segment, p, p));
  return least;
}

bool in(const Box& box, Point p) {
  return p.x > box.min_x && p.x < box.max_x && p.y > box.min_y && p.y < box.max_y;
}

template <class Check>
void for_random_scenes(int standard, bool as_wide_as_it_turns, double margin, Check check) {
  int drivable = 0;
  const int cases = testing::case_count(standard);
  for (int i = 0; i < cases; ++i) {
    testing::SeededRandom random(i);
    const std::optional<Scene> scene = random_scene(random, as_wide_as_it_turns, margin);
    if (!scene) continue;
    ++drivable;
    check(*scene, random);
    if (::testing::Test::HasFailure()) return;
  }
  EXPECT_GE(3 * drivable, cases < 100 ? 0 : cases);
}

/// Points along the segment, with both ends.
std::vector<Point> samples(const PathSegment& segment, int count) {
  std::vector<Point> out{segment.from};
  const std::vector<Point> line = chords({segment}, 1e-3);
  for (int i = 1; i < count; ++i) {
    const double share = static_cast<double>(i) / count;
    if (segment.straight()) {
      out.push_back(segment.from + share * (segment.to - segment.from));
    } else {
      const Point middle = centre(segment), arm = segment.from - middle;
      const double angle = share * turning(segment);
      out.push_back(middle + Point{std::cos(angle) * arm.x - std::sin(angle) * arm.y,
                                   std::sin(angle) * arm.x + std::cos(angle) * arm.y});
    }
  }
  out.push_back(segment.to);
  return out;
}

TEST(ParallelProperties, KeepTheirDistanceAndTheirRadius) {
  for_random_scenes(300, false, 0, [](const Scene& scene, std::mt19937_64& random) {
    const double radius = scene.limits.least_radius_m();
    for (int times = 0; times < 6; ++times) {
      const int k = any_of(random, -30, 30);
      const double offset = (k + 0.5) * scene.limits.width_m;
      for (const ParallelTrack& track : parallel(scene.reference, offset, scene.limits)) {
        expect_drivable(track.path, radius, track.closed);
        for (const PathSegment& segment : track.path) {
          const bool rounded = segment.curvature == std::copysign(1 / radius, -offset);
          for (const Point p : samples(segment, 7)) {
            const double away = distance_to(scene.reference, p);
            EXPECT_GE(away, std::abs(offset) - 1e-6) << "track " << k;
            EXPECT_LE(away, rounded ? away : std::abs(offset) + 1e-6) << "track " << k;
          }
        }
      }
    }
  });
}

// Swaths of tracks in a row touch and do not overlap, neither one another nor themselves.
TEST(ParallelProperties, WorkNothingTwice) {
  for_random_scenes(6, false, 0, [](const Scene& scene, std::mt19937_64& random) {
    const int first = any_of(random, -12, 8);
    Region all;
    double sum = 0;
    for (const FamilyTrack& track : parallel_family(scene.reference, first, first + 3, scene.limits)) {
      const double w = scene.limits.width_m;
      // In parts, so that a ring is never closed; with chords the two sides of a seam differ by the sagitta.
      for (const PathSegment& segment : track.track.path) all.push_back({band({segment}, w, 1e-5), {}});
      sum += w * length(track.track.path);
    }
    EXPECT_NEAR(area(unite(all)), sum, 1e-6 * sum + 1e-2);
  });
}

/// Points within the distance of a line, as rectangles and fans on both sides: chords of fans are off by no
/// more than the distance times 4e-6. GEOS's own buffers simplify their input by more than what is compared
/// here.
Region near(const std::vector<Point>& line, double distance_m) {
  Region out;
  const auto add = [&out](Ring ring) {
    if (std::abs(signed_area(ring)) > 1e-9) out.push_back(oriented(Polygon{std::move(ring), {}}));
  };
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const Point along = (1 / distance(line[i], line[i + 1])) * (line[i + 1] - line[i]);
    const Point left = distance_m * Point{-along.y, along.x};
    // A little longer, so that the precision grid leaves no slit between it and the next one.
    const Point a = line[i] - 1e-4 * along, b = line[i + 1] + 1e-4 * along;
    add({a - left, b - left, b + left, a + left});
    if (i + 2 == line.size()) break;
    const Point next = line[i + 2] - line[i + 1];
    const double turn = std::atan2(cross(along, next), dot(along, next));
    const int count = static_cast<int>(std::abs(turn) / 0.005) + 1;
    Ring fan{line[i + 1]};
    for (int step = 0; step <= count; ++step) {
      const double angle = turn * step / count, c = std::cos(angle), s = std::sin(angle);
      const Point arm = turn > 0 ? -1 * left : left;
      fan.push_back(line[i + 1] + Point{c * arm.x - s * arm.y, s * arm.x + c * arm.y});
    }
    add(std::move(fan));
  }
  return unite(out);
}

/// Points within the distance of a region.
Region near(const Region& region, double distance_m) {
  Region out = region;
  for (Ring ring : rings_of(region)) {
    ring.push_back(ring[0]);
    ring.push_back(ring[1]);
    out = unite(out, near(ring, distance_m));
  }
  return out;
}

// E, the points at least t + ρ away, and then all within ρ of E: with w = 2ρ and no corner too sharp, that
// is the rule, and polygon booleans with fine chords follow it on a road of their own.
TEST(ParallelProperties, RunWherePolygonBooleansPutThem) {
  int compared = 0;
  for_random_scenes(3, true, 60, [&](const Scene& scene, std::mt19937_64& random) {
    const double rho = scene.limits.least_radius_m(), t = (any_of(random, 0, 5) + 0.5) * 2 * rho;
    const Box box = kWindow.grown(50);
    const Region plane{
        {{{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}},
         {}}};
    const Region far = difference(plane, near(chords(scene.reference, 1e-5), t + rho));
    const Region near_far = near(far, rho);

    Path all;
    for (const double offset : {t, -t})
      for (const ParallelTrack& track : parallel(scene.reference, offset, scene.limits))
        all.insert(all.end(), track.path.begin(), track.path.end());
    const std::vector<Ring> rings = rings_of(near_far);
    const Box inner = kWindow.grown(-10);
    for (const PathSegment& segment : all)
      for (const Point p : samples(segment, 5)) {
        if (!in(inner, p)) continue;
        double least = std::numeric_limits<double>::infinity();
        for (const Ring& ring : rings)
          for (std::size_t i = 0; i < ring.size(); ++i)
            least = std::min(least, distance_to_edge({p, p, 0}, ring[i], ring[(i + 1) % ring.size()]));
        EXPECT_LE(least, 1e-3) << p.x << " " << p.y << " t " << t;
        ++compared;
      }
    for (const Ring& ring : rings)
      for (const Point p : ring)
        EXPECT_LE(in(inner, p) ? distance_to(all, p) : 0, 1e-3) << p.x << " " << p.y << " t " << t;
  });
  EXPECT_GT(compared, 100);
}

}  // namespace tramline::parallel_properties_test
