#include "tramline/cost/worked/worked_rows.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tramline/geometry/polygon/boolean.h"

namespace tramline {
namespace {

/// Pieces anywhere in ten strips, apart, touching, and side by side; every one as a rectangle as well.
LaidTracks random_tracks(std::mt19937_64& random, Region& rectangles) {
  const auto between = [&random](double a, double b) {
    return std::uniform_real_distribution<double>(a, b)(random);
  };
  const TrackFrame frame(Direction::clockwise_from_north(Angle::degrees(between(0, 180))));
  LaidTracks out{{frame, between(-5, 5), 4}, {}, {}};
  for (int strip = -3; strip < 7; ++strip) {
    double at = between(0, 20);
    while (at < 100) {
      LaidPiece piece;
      piece.track = strip;
      piece.from = at;
      piece.to = at + (random() % 3 == 0 ? 10 : between(1, 40));
      at = piece.to + (random() % 4 == 0 ? 0 : between(1, 30));
      const double left = out.grid.line(strip), right = out.grid.line(strip + 1);
      rectangles.push_back({{frame.to_field({left, piece.from}), frame.to_field({right, piece.from}),
                             frame.to_field({right, piece.to}), frame.to_field({left, piece.to})},
                            {}});
      out.pieces.push_back(piece);
    }
  }
  return out;
}

TEST(WorkedRows, AreTheUnionOfTheSwaths) {
  for (unsigned seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    Region rectangles;
    const Region rows = worked_rows(random_tracks(random, rectangles));
    const Region expected = unite(rectangles);
    EXPECT_NEAR(area(rows), area(expected), 1e-3);
    EXPECT_NEAR(area(symmetric_difference(unite(rows), expected)), 0, 1e-2);
    for (const Polygon& part : rows) EXPECT_GT(signed_area(part.outer), 0);
  }
}

}  // namespace
}  // namespace tramline
