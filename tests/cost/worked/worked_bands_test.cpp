#include "tramline/cost/worked/worked_bands.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/path/path_between.h"
#include "tramline/geometry/path/smoothed_line.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

constexpr double kSagitta = 2e-3;

struct Family {
  Path reference;
  std::vector<TrackPiece> pieces;
  double width_m = 0;
};

double between(std::mt19937_64& random, double a, double b) {
  return std::uniform_real_distribution<double>(a, b)(random);
}

/// Tracks on both sides of a winding line, most of them cut into pieces at any places; some pieces left out,
/// and some driven the other way.
Family random_family(std::mt19937_64& random) {
  Family out;
  const TrackLimits limits{between(random, 2, 8), between(random, 2, 8)};
  out.width_m = limits.width_m;
  std::vector<Point> line;
  for (int i = 0; i < 6; ++i) line.push_back({60.0 * i, between(random, -25, 25)});
  out.reference = smoothed(line, limits.least_radius_m(), 0.1).path;
  for (const FamilyTrack& track : parallel_family(out.reference, -12, 11, limits)) {
    const double whole = length(track.track.path);
    for (double at = 0; at < whole;) {
      const double end = random() % 3 == 0 ? whole : std::min(whole, at + between(random, 5, 150));
      if (end - at > 1 && random() % 8 != 0) {
        TrackPiece piece;
        piece.curve = path_between(track.track.path, at, end);
        if (random() % 2 == 0) piece.curve = reversed(piece.curve);
        piece.track = track.index;
        out.pieces.push_back(piece);
      }
      at = end + (random() % 2 == 0 ? 0 : between(random, 1, 30));
    }
  }
  return out;
}

// Swaths of one family do not overlap, so that their areas, width times length, add up to that of the ground.
TEST(WorkedBands, AreTheUnionOfTheSwaths) {
  std::size_t vertices = 0, vertices_of_swaths = 0;
  for (unsigned seed = 0; seed < 10; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    const Family family = random_family(random);
    double worked_m2 = 0, arcs_m = 0;
    Region swaths;
    for (const TrackPiece& piece : family.pieces)
      for (const PathSegment& segment : piece.curve) {
        worked_m2 += family.width_m * length(segment);
        if (!segment.straight()) arcs_m += length(segment);
        swaths.push_back({band({segment}, family.width_m, kSagitta), {}});
      }
    Region bands;
    for (Region& region : worked_bands(family.reference, family.pieces, family.width_m, kSagitta)) {
      EXPECT_NEAR(area(region), area(unite(region)), 1e-3);
      for (Polygon& part : region) bands.push_back(std::move(part));
    }
    const Region ground = unite(bands);
    EXPECT_NEAR(area(ground), worked_m2, kSagitta * arcs_m + 1e-3);
    EXPECT_NEAR(area(symmetric_difference(ground, unite(swaths))), 0, 2 * kSagitta * arcs_m + 1e-2);
    vertices += vertex_count(bands);
    vertices_of_swaths += vertex_count(swaths);
  }
  EXPECT_LT(2 * vertices, vertices_of_swaths);
}

// Four rounds of a quarter ring, side by side: one polygon with two arcs and two ends.
TEST(WorkedBands, OfTracksSideBySideAreOnePolygon) {
  Family family;
  family.width_m = 3;
  family.reference = {{{100, 0}, {0, 100}, 0.01}};
  for (const FamilyTrack& track : parallel_family(family.reference, -2, 1, {6, 3})) {
    TrackPiece piece;
    piece.curve = track.track.path;
    piece.track = track.index;
    family.pieces.push_back(piece);
  }
  ASSERT_EQ(family.pieces.size(), 4u);
  const std::vector<Region> grounds = worked_bands(family.reference, family.pieces, 3, kSagitta);
  ASSERT_EQ(grounds.size(), 3u);
  EXPECT_TRUE(grounds[1].empty() && grounds[2].empty());
  const Region& ground = grounds[0];
  ASSERT_EQ(ground.size(), 1u);
  const double quarter = 0.25 * 3.14159265358979 * (106 * 106 - 94 * 94);
  EXPECT_NEAR(area(ground), quarter, kSagitta * 300);
  for (const Point p : ground[0].outer) {
    const double r = std::hypot(p.x, p.y);
    EXPECT_TRUE(std::abs(r - 94) < 1e-6 || std::abs(r - 106) < 1e-6 || p.x < 1e-6 || p.y < 1e-6) << r;
  }
}

}  // namespace
}  // namespace tramline
