// The exact engine over random drives: against the definitions taken word for word, against polygon
// booleans, and against itself.

#include <gtest/gtest.h>

#include <tbb/task_arena.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

#include "coverage/tiles/literal_coverage.h"
#include "coverage/tiles/random_drive.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::tile_coverage_properties_test {

using coverage::TileCoverage;
using coverage::WorkedStep;
using testing::Drive;

constexpr std::array kLandClasses = {
    LandClass::kCovered, LandClass::kRepeated, LandClass::kSliver, LandClass::kMissed, LandClass::kUnrecorded,
    LandClass::kOutside, LandClass::kOnce,     LandClass::kTwice,  LandClass::kOften,  LandClass::kAgain};

double area_of(const CoverageAreas& areas, LandClass what) {
  switch (what) {
    case LandClass::kCovered:
      return areas.covered_m2;
    case LandClass::kRepeated:
      return areas.repeated_m2;
    case LandClass::kSliver:
      return areas.sliver_m2;
    case LandClass::kMissed:
      return areas.missed_m2;
    case LandClass::kUnrecorded:
      return areas.not_recorded_m2;
    case LandClass::kOutside:
      return areas.outside_m2;
    case LandClass::kOnce:
      return areas.worked_times_m2[1];
    case LandClass::kTwice:
      return areas.worked_times_m2[2];
    case LandClass::kOften:
      return areas.worked_times_m2[3];
    case LandClass::kAgain:
      return areas.worked_times_m2[2] + areas.worked_times_m2[3];
  }
  return 0;
}

std::string name(LandClass what) {
  constexpr std::array kNames = {"covered", "repeated", "sliver", "missed", "not recorded",
                                 "outside", "once",     "twice",  "often",  "again"};
  static_assert(kNames.size() == kLandClasses.size());
  return kNames[static_cast<std::size_t>(what)];
}

TileCoverage evaluated(const Drive& drive, const TileCoverage::Settings& settings = {}) {
  TileCoverage out(drive.field, settings);
  for (const WorkedStep& step : drive.steps) out.add(step);
  return out;
}

/// Edges of the field and of quads are rounded by up to 4 nm, over some hundred metres: no less than 1e-6 m².
double worked(const CoverageAreas& areas) { return std::max(areas.covered_m2, 1.0); }

void expect_same(const CoverageAreas& got, const CoverageAreas& expected, double tolerance) {
  for (const LandClass what : kLandClasses)
    EXPECT_NEAR(area_of(got, what), area_of(expected, what), tolerance) << name(what);
  EXPECT_NEAR(got.covered_inside_m2, expected.covered_inside_m2, tolerance);
}

template <class Check>
void for_random_drives(int standard, int length, Check check) {
  testing::for_each_seed(standard, [&](std::mt19937_64& random, int number) {
    const double far_m = number % 3 == 0 ? 1e5 : 50;
    check(testing::random_drive(random, length, far_m), random);
  });
}

TEST(TileCoverageProperties, AgreesWithTheDefinitionsTakenWordForWord) {
  int repeated = 0, slivers = 0;
  for_random_drives(400, 40, [&](const Drive& drive, std::mt19937_64&) {
    const CoverageAreas expected = testing::literal_coverage(drive.field, drive.steps);
    expect_same(evaluated(drive).areas(), expected, 1e-6 * worked(expected));
    repeated += expected.repeated_m2 > 0.1 ? 1 : 0;
    slivers += expected.sliver_m2 > 0.1 ? 1 : 0;
  });
  EXPECT_GT(2 * repeated, testing::case_count(400) / 2);
  EXPECT_GT(2 * slivers, testing::case_count(400) / 2);
}

TEST(TileCoverageProperties, AreasAreCurrentAfterEveryStep) {
  for_random_drives(20, 25, [](const Drive& drive, std::mt19937_64&) {
    TileCoverage engine(drive.field, {});
    std::vector<WorkedStep> so_far;
    for (const WorkedStep& step : drive.steps) {
      engine.add(step);
      so_far.push_back(step);
      const CoverageAreas expected = testing::literal_coverage(drive.field, so_far);
      expect_same(engine.areas(), expected, 1e-6 * worked(expected));
    }
  });
}

// The precision grid of the booleans moves every edge of their results by up to 1e-6/√2 m.
TEST(TileCoverageProperties, AgreesWithPolygonBooleans) {
  for_random_drives(60, 60, [](const Drive& drive, std::mt19937_64&) {
    Region quads;
    double perimeters = 0;
    for (const WorkedStep& step : drive.steps)
      for (const coverage::Quad& quad : step.quads) {
        const Polygon polygon{{quad.begin(), quad.end()}, {}};
        perimeters += perimeter(polygon.outer);
        for (const Polygon& part : made_valid(polygon)) quads.push_back(oriented(part));
      }
    const Region covered = unite(quads);
    const CoverageAreas areas = evaluated(drive).areas();
    const double tolerance = 1e-6 * perimeters;
    EXPECT_NEAR(areas.covered_m2, area(covered), tolerance);
    EXPECT_NEAR(areas.gross_m2, area(quads), tolerance);
    if (drive.field.empty()) return;
    EXPECT_NEAR(areas.missed_m2, area(difference(drive.field, covered)), tolerance);
    EXPECT_NEAR(areas.outside_m2, area(difference(covered, drive.field)), tolerance);
  });
}

TEST(TileCoverageProperties, RegionsAreValidAndMeasureWhatTheAreasSay) {
  for_random_drives(150, 150, [](const Drive& drive, std::mt19937_64&) {
    const TileCoverage engine = evaluated(drive);
    for (const LandClass what : kLandClasses) {
      SCOPED_TRACE(name(what));
      const Region region = engine.region(what);
      EXPECT_NEAR(area(region), area_of(engine.areas(), what), 1e-6 * worked(engine.areas()));
      for (const Polygon& polygon : region) {
        const auto fault = find_invalidity(polygon);
        EXPECT_FALSE(fault) << fault->reason << " at " << fault->place.x << " " << fault->place.y;
        EXPECT_GT(signed_area(polygon.outer), 0);
        for (const Ring& hole : polygon.holes) EXPECT_LT(signed_area(hole), 0);
      }
    }
  });
}

double perimeter_of(const Region& region) {
  double sum = 0;
  for (const Ring& ring : rings_of(region)) sum += perimeter(ring);
  return sum;
}

// Parts of a region do not overlap: their union is as large as their sum. Grounds of different kinds neither.
// The booleans' precision grid moves edges by up to 1e-6/√2 m.
TEST(TileCoverageProperties, RegionsDoNotOverlap) {
  for_random_drives(20, 60, [](const Drive& drive, std::mt19937_64&) {
    const TileCoverage engine = evaluated(drive);
    const Region covered = engine.region(LandClass::kCovered), missed = engine.region(LandClass::kMissed);
    EXPECT_NEAR(area(unite(covered)), area(covered), 1e-6 * perimeter_of(covered));
    EXPECT_NEAR(area(unite(missed)), area(missed), 1e-6 * perimeter_of(missed));
    EXPECT_NEAR(area(intersection(covered, missed)), 0, 1e-6 * perimeter_of(covered));
  });
}

TEST(TileCoverageProperties, DoesNotDependOnTheOrderOfQuadsInAStep) {
  for_random_drives(100, 80, [](const Drive& drive, std::mt19937_64& random) {
    Drive shuffled = drive;
    for (WorkedStep& step : shuffled.steps) std::shuffle(step.quads.begin(), step.quads.end(), random);
    const CoverageAreas expected = evaluated(drive).areas();
    expect_same(evaluated(shuffled).areas(), expected, 1e-6 * worked(expected));
  });
}

TEST(TileCoverageProperties, DoesNotDependOnWhereTheGroundLies) {
  for_random_drives(100, 80, [](const Drive& drive, std::mt19937_64& random) {
    std::uniform_real_distribution<double> by(-50, 50);
    const CoverageAreas expected = evaluated(drive).areas();
    expect_same(evaluated(testing::moved(drive, {by(random), by(random)})).areas(), expected,
                1e-6 * worked(expected));
  });
}

/// Every edge of the field and of quads may lie a unit of the grid aside: 2^-30 of a tile's side, rounded up
/// to a power of two.
double edges_moved_by_a_unit(const Drive& drive, double tile_m) {
  double perimeters = perimeter_of(drive.field);
  for (const WorkedStep& step : drive.steps)
    for (const coverage::Quad& quad : step.quads) perimeters += perimeter(Ring(quad.begin(), quad.end()));
  return std::ldexp(tile_m, -29) * perimeters;
}

TEST(TileCoverageProperties, DoesNotDependOnTheSizeOfTiles) {
  for_random_drives(60, 80, [](const Drive& drive, std::mt19937_64&) {
    const CoverageAreas expected = evaluated(drive).areas();
    for (const double tile_m : {1.0, 4.0, 6.3, 32.0}) {
      SCOPED_TRACE(tile_m);
      const TileCoverage engine = evaluated(drive, {tile_m, true});
      expect_same(engine.areas(), expected,
                  1e-6 * worked(expected) + edges_moved_by_a_unit(drive, std::max(tile_m, 8.0)));
      for (const LandClass what : {LandClass::kCovered, LandClass::kMissed}) {
        const Region region = engine.region(what);
        EXPECT_NEAR(area(region), area_of(expected, what),
                    1e-6 * std::max(worked(expected), area_of(expected, what)));
        for (const Polygon& polygon : region) EXPECT_FALSE(find_invalidity(polygon)) << name(what);
      }
    }
  });
}

TEST(TileCoverageProperties, WithoutMultiplicityAllElseIsTheSame) {
  for_random_drives(60, 80, [](const Drive& drive, std::mt19937_64&) {
    const CoverageAreas expected = evaluated(drive).areas(), got = evaluated(drive, {8, false}).areas();
    for (const LandClass what : {LandClass::kCovered, LandClass::kRepeated, LandClass::kSliver,
                                 LandClass::kMissed, LandClass::kOutside})
      EXPECT_NEAR(area_of(got, what), area_of(expected, what), 1e-6 * worked(expected)) << name(what);
    EXPECT_TRUE(std::isnan(got.worked_times_m2[2]));
  });
}

TEST(TileCoverageProperties, RegionsAreTheSameOnAnyNumberOfThreads) {
  for_random_drives(20, 150, [](const Drive& drive, std::mt19937_64&) {
    const TileCoverage engine = evaluated(drive);
    for (const LandClass what : kLandClasses) {
      Region alone, together;
      tbb::task_arena(1).execute([&] { alone = engine.region(what); });
      tbb::task_arena(2).execute([&] { together = engine.region(what); });
      EXPECT_EQ(alone, together) << name(what);
    }
  });
}

// What changes_since() gives, kept by tile and put in the place of what was there, adds up to all ground.
TEST(TileCoverageProperties, ChangesAddUp) {
  for_random_drives(40, 80, [](const Drive& drive, std::mt19937_64& random) {
    TileCoverage engine(drive.field, {});
    std::map<std::pair<double, double>, double> kept;
    std::uint64_t stamp = 0;
    const auto take = [&] {
      for (const TileCoverage::Change& change : engine.changes_since(stamp, LandClass::kCovered)) {
        kept[{change.tile.min_x, change.tile.min_y}] = area(change.ground);
        const Box ground = bounds(change.ground);
        EXPECT_TRUE(change.ground.empty() ||
                    (ground.min_x >= change.tile.min_x && ground.max_x <= change.tile.max_x &&
                     ground.min_y >= change.tile.min_y && ground.max_y <= change.tile.max_y));
      }
      stamp = engine.stamp();
    };
    for (const WorkedStep& step : drive.steps) {
      engine.add(step);
      if (std::bernoulli_distribution(0.1)(random)) take();
    }
    take();
    EXPECT_TRUE(engine.changes_since(stamp, LandClass::kCovered).empty());
    double sum = 0;
    for (const auto& [tile, size] : kept) sum += size;
    EXPECT_NEAR(sum, engine.areas().covered_m2, 1e-6 * worked(engine.areas()));
  });
}

}  // namespace tramline::tile_coverage_properties_test
