// What holds for headlands of random fields. TRAMLINE_CASES and TRAMLINE_SEED as for the other properties.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "headland/headland_faults.h"
#include "properties/random_field.h"
#include "properties/random_scene.h"
#include "support/turned_ring.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/headland/pass_tally.h"
#include "tramline/headland/path_stretch.h"
#include "tramline/headland/tolerances.h"
#include "tramline/headland/turning_room.h"

namespace tramline::testing {
namespace {

HeadlandTerms random_terms(std::mt19937_64& random, const Field& field, double width_m) {
  const auto whole = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  HeadlandTerms terms{width_m,
                      whole(0, 3) == 0 ? 0.0 : std::uniform_real_distribution<double>(0, 15)(random),
                      whole(0, 3),
                      {}};
  if (whole(0, 1) == 0)
    terms = terms_of(field, width_m, terms.radius_m, whole(1, 3));
  else
    for (std::size_t i = 0; i < field.obstacles.size(); ++i) terms.obstacle_passes.push_back(whole(0, 3));
  if (whole(0, 3) == 0) terms.clearance_m = std::uniform_real_distribution<double>(0, 3)(random);
  return terms;
}

void expect_no_faults(const Field& field, const HeadlandTerms& terms, unsigned long long seed) {
  try {
    for (const std::string& fault : faults_of(field, terms, headland_of(field, terms)))
      ADD_FAILURE() << fault << ", TRAMLINE_SEED=" << seed;
  } catch (const Error& error) {
    ADD_FAILURE() << error.what() << ", TRAMLINE_SEED=" << seed;
  }
}

TEST(HeadlandProperties, HoldForRandomFields) {
  for (int i = 0; i < case_count(30); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    const Field field = random_field(random, 8);
    const double width = std::uniform_real_distribution<double>(1, 12)(random);
    expect_no_faults(field, random_terms(random, field, width), seed);
  }
}

/// Numbers of passes by edge, in runs.
std::vector<int> random_edge_passes(std::mt19937_64& random, std::size_t edges) {
  const auto whole = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  std::vector<int> out;
  while (out.size() < edges) out.insert(out.end(), static_cast<std::size_t>(whole(1, 5)), whole(0, 3));
  out.resize(edges);
  return out;
}

/// The path of a pass without so much at either end; all of one that is closed or no longer.
Path without_ends(const HeadlandPass& pass, double end_m) {
  const double length_m = length(pass.path);
  return is_closed(pass) || length_m <= 2 * end_m ? pass.path
                                                  : stretch_of(pass.path, end_m, length_m - end_m);
}

/// How many pairs of passes along the field's edges, round no obstacle, cross away from their ends.
int crossings_of(const std::vector<HeadlandPass>& passes, double end_m) {
  int out = 0;
  for (std::size_t i = 0; i < passes.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!passes[i].obstacles.empty() || !passes[j].obstacles.empty()) continue;
      const Path a = without_ends(passes[i], end_m), b = without_ends(passes[j], end_m);
      out += meeting_count({a}) + meeting_count({b}) < meeting_count({a, b}) ? 1 : 0;
    }
  return out;
}

TEST(HeadlandProperties, HoldAlongSomeEdges) {
  int passes = 0, crossings = 0;
  for (int i = 0; i < case_count(20); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    const Field field = random_field(random, i % 2 == 0 ? 0 : 8);
    const double width = std::uniform_real_distribution<double>(1, 12)(random);
    HeadlandTerms terms = random_terms(random, field, width);
    terms.edge_passes = random_edge_passes(random, field.outer.size());
    expect_no_faults(field, terms, seed);
    const HeadlandAndBody found = headland_of(field, terms);
    passes += static_cast<int>(found.passes.size());
    crossings += crossings_of(found.passes, 0.5 * width);
    // By polygons: the passes lie where they are meant to work, or beside it.
    Region swaths;
    double all_m2 = 0;
    for (const HeadlandPass& pass : found.passes)
      for (const Polygon& part : pass_ground_parts(pass.path, width, kLayerSagitta)) {
        swaths.push_back(part);
        all_m2 += area(part);
      }
    const double useful_m2 = area(intersection(unite(swaths), found.ground));
    const double slack_m2 = 1e-3 * all_m2 + 1;
    if (obstacle_shapes(field, ObstacleKind::kPassable).empty()) {
      EXPECT_NEAR(found.overlap_m2, all_m2 - useful_m2, slack_m2) << "TRAMLINE_SEED=" << seed;
      EXPECT_NEAR(found.uncovered_m2, area(found.ground) - useful_m2, slack_m2) << "TRAMLINE_SEED=" << seed;
    }
  }
  // At their ends passes cross where chains meet at sharp corners, and in tips into which they lead along
  // both sides; hardly ever elsewhere.
  EXPECT_LE(crossings, passes / 100) << passes << " passes";
}

TEST(HeadlandProperties, HoldForScenesFullOfObstacles) {
  for (int i = 0; i < case_count(30); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    Scene scene;
    try {
      scene = random_scene(random);
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::kBadInput) throw;
      continue;  // obstacles all over the field
    }
    expect_no_faults(scene.field, random_terms(random, scene.field, scene.machine.width_m), seed);
  }
}

/// Rooms along a line with bends, joined by corridors too narrow for the machine to turn in, if not for it.
Field with_necks(std::mt19937_64& random, double width_m, double radius_m) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double narrow = 0.5 * width_m, room = radius_m + width_m;
  Point at{0, 0};
  double heading = between(0, 6);
  Region parts;
  for (int i = std::uniform_int_distribution<int>(2, 8)(random); i > 0; --i) {
    const Point next = at + between(2, 8) * room * Point{std::cos(heading), std::sin(heading)};
    Ring ring;
    for (int k = 0; k < 7; ++k)
      ring.push_back(next + room * between(0.5, 2.5) * Point{std::cos(k * 0.9), std::sin(k * 0.9)});
    parts.push_back({ring, {}});
    const Region corridor = buffered_line({at, next}, between(0.9 * narrow, narrow + radius_m));
    parts.insert(parts.end(), corridor.begin(), corridor.end());
    heading += between(-1.5, 1.5);
    at = next;
  }
  const Region whole = unite(parts);
  const Polygon& largest = *std::max_element(
      whole.begin(), whole.end(), [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  Field field;
  field.outer = largest.outer;
  for (const Ring& hole : largest.holes)
    field.obstacles.push_back({{reversed(hole), {}}, ObstacleKind::kObstacle, "hole"});
  return field;
}

/// What passes leave, five times, and double of all ground within their width, whether it is left to tracks
/// or not.
double with_passes(const std::vector<HeadlandPass>& passes, const Region& ground, double width_m) {
  HeadlandAndBody headland;
  headland.ground = ground;
  headland.passes = passes;
  tally_passes({}, width_m, headland);
  return 5 * headland.uncovered_m2 + headland.overlap_m2;
}

/// One pass where it is driven only in places where the machine could turn.
std::vector<HeadlandPass> where_it_can_turn(const Field& field, const HeadlandTerms& terms) {
  std::vector<HeadlandPass> out;
  const TurningRoom land = turning_room(boundaries_of(field, terms), terms.width_m, 1, tightest_m(terms));
  for (const OffsetRing& ring : turning_centres(land))
    out.push_back({closed_path(ring, land.radius_m), 1, true, {}});
  return out;
}

bool any_meet(const std::vector<HeadlandPass>& rings) {
  std::vector<Path> paths;
  for (const HeadlandPass& ring : rings) paths.push_back(ring.path);
  return meeting_count(paths) > 0;
}

TEST(HeadlandProperties, HoldWhereThereAreNecks) {
  int through = 0;
  for (int i = 0; i < case_count(30); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    const double width = std::uniform_real_distribution<double>(1, 12)(random);
    const double radius = std::uniform_real_distribution<double>(0, 12)(random);
    const Field field = with_necks(random, width, radius);
    expect_no_faults(field, terms_of(field, width, radius, 2), seed);
    const HeadlandTerms once = terms_of(field, width, radius, 1);
    const HeadlandAndBody headland = headland_of(field, once);
    if (!field.obstacles.empty()) continue;  // may be driven round one by one
    const Region ground =
        difference({{field.outer, {}}}, land_behind_headlands(boundaries_of(field, once), width));
    const std::vector<HeadlandPass> rings = where_it_can_turn(field, once);
    if (any_meet(rings)) continue;  // may be left for what costs more
    const double apart = with_passes(rings, ground, width);
    const double all = with_passes(headland.passes, ground, width);
    EXPECT_LE(all, apart + 1e-3) << "TRAMLINE_SEED=" << seed;
    through += all < apart - 1 ? 1 : 0;
  }
  EXPECT_GT(10 * through, case_count(30)) << "the fields have too few narrow passages";
}

/// A room with arms in which one or two swaths lie beside one another, and that end blindly.
Field with_arms(std::mt19937_64& random, double width_m, double radius_m) {
  const auto between = [&](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const double room = (radius_m + width_m) * between(2, 4);
  double heading = between(0, 2);
  Ring middle;
  for (int k = 0; k < 7; ++k)
    middle.push_back(room * between(0.9, 1.3) * Point{std::cos(k * 0.9), std::sin(k * 0.9)});
  Region parts{{middle, {}}};
  for (int i = std::uniform_int_distribution<int>(1, 3)(random); i > 0; --i) {
    const Point along{std::cos(heading), std::sin(heading)};
    const Point end = (room + width_m * between(3, 10)) * along;
    const Point across = width_m * between(0.55, 1.15) * Point{-along.y, along.x};
    parts.push_back({{-1 * across, end - across, end + across, across}, {}});
    heading += between(1, 2);
  }
  Field field;
  field.outer = unite(parts).front().outer;
  return field;
}

// Turned land is the same land, and where its outline begins says nothing about it. Where passes are worth as
// much one way as another either may be chosen; no arm stays unworked for that.
TEST(HeadlandProperties, HardlyDependOnHowTheLandLies) {
  int open = 0;
  for (int i = 0; i < case_count(30); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    const double width = std::uniform_real_distribution<double>(2, 12)(random);
    const double radius = std::uniform_real_distribution<double>(0, 12)(random);
    Field field = with_arms(random, width, radius);
    const HeadlandTerms terms = terms_of(field, width, radius, 1);
    const HeadlandAndBody headland = headland_of(field, terms);
    open += std::ranges::any_of(headland.passes, [](const HeadlandPass& pass) { return !is_closed(pass); })
                ? 1
                : 0;
    for (int other = 0; other < 5; ++other) {
      field.outer = testing_support::turned(field.outer, 1.1);
      std::rotate(field.outer.begin(), field.outer.begin() + 1, field.outer.end());
      const HeadlandAndBody same = headland_of(field, terms);
      EXPECT_NEAR(same.uncovered_m2, headland.uncovered_m2, 0.05 * area(headland.ground))
          << "TRAMLINE_SEED=" << seed;
    }
  }
  EXPECT_GT(10 * open, case_count(30)) << "hardly any arm is too narrow to turn in";
}

}  // namespace
}  // namespace tramline::testing
