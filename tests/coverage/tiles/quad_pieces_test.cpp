#include "tramline/coverage/tiles/quad_pieces.h"

#include <gtest/gtest.h>

namespace tramline::coverage {
namespace {

struct Worked {
  std::size_t pieces = 0;
  double area_m2 = 0;
};

Worked worked(const Quad& quad) {
  const TileFrame frame = tile_frame(8);
  std::vector<ConvexPiece> pieces;
  append_pieces(quad, frame, pieces);
  Worked out;
  for (const ConvexPiece& piece : pieces) {
    ++out.pieces;
    EXPECT_GT(frame.area_m2(twice_area(piece)), 0);
    out.area_m2 += frame.area_m2(twice_area(piece));
  }
  return out;
}

void expect(const Quad& quad, std::size_t pieces, double area_m2) {
  const Worked got = worked(quad);
  EXPECT_EQ(got.pieces, pieces);
  EXPECT_NEAR(got.area_m2, area_m2, 1e-6);
}

TEST(QuadPieces, AConvexQuadIsItself) { expect({{{-2, 0}, {2, 0}, {2, 1}, {-2, 1.5}}}, 1, 5); }

TEST(QuadPieces, AReversedQuadIsTurned) { expect({{{-2, 0}, {2, 0}, {2, -1}, {-2, -1.5}}}, 1, 5); }

TEST(QuadPieces, EndsThatCrossMakeTwoTriangles) {
  // Rear end along the x axis, front end turned by 90 degrees about (1, 0): triangles with legs 3 and 3, 1
  // and 1.
  expect({{{-2, 0}, {2, 0}, {1, 1}, {1, -3}}}, 2, 0.5 * (3 * 3 + 1 * 1));
}

TEST(QuadPieces, SidesThatCrossMakeTwoTriangles) {
  // The front is driven over from the other side: two triangles of base 4 and height 1.
  expect({{{-2, 0}, {2, 0}, {-2, 2}, {2, 2}}}, 2, 4);
}

TEST(QuadPieces, AnArrowIsTwoTriangles) {
  expect({{{0, 0}, {4, 0}, {1, 1}, {0, 4}}}, 2, 0.5 * 4 * 1 + 0.5 * 4 * 1);
  expect({{{0, 4}, {1, 1}, {4, 0}, {0, 0}}}, 2, 4);
}

TEST(QuadPieces, TurningAboutAnEndIsOneTriangle) { expect({{{0, 0}, {4, 0}, {0, 4}, {0, 0}}}, 1, 8); }

TEST(QuadPieces, AStraightCornerLosesNothing) {
  const Worked got = worked({{{0, 0}, {2, 0}, {4, 0}, {0, 4}}});
  EXPECT_NEAR(got.area_m2, 8, 1e-6);
}

TEST(QuadPieces, StandingStillIsNothing) {
  expect({{{-2, 0}, {2, 0}, {2, 0}, {-2, 0}}}, 0, 0);
  expect({{{-2, 0}, {2, 0}, {3, 0}, {-1, 0}}}, 0, 0);
  expect({{{1, 1}, {1, 1}, {1, 1}, {1, 1}}}, 0, 0);
}

}  // namespace
}  // namespace tramline::coverage
