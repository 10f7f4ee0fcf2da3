// What detours cover beyond the straight swaths: by hand, and against polygon booleans.

#include "tramline/cost/worked/detour_cover.h"

#include <gtest/gtest.h>

#include <cmath>

#include "properties/seeds.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline {
namespace {

constexpr double kStrip = 3;

Polygon box_shape(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

/// Strips in one direction over the whole body.
TrackFamily strips_over_body(double degrees, const Polygon& body) {
  const StripGrid grid{TrackFrame(Direction::clockwise_from_north(Angle::degrees(degrees))), 0, kStrip};
  return straight_tracks(grid, grid.frame.to_track(Region{body}).front(), {}, {false, kWidthTolerance});
}

/// Three arcs out of the strip and back: r·(1 − cos) of each bend to the side, 4·r·sin along.
TrackDetour three_arcs(const TrackFamily& family, int strip, double from, double radius_m, double bend_rad,
                       Passing side) {
  const double x = family.grid.centre(strip), sense = side == Passing::kLeft ? 1 : -1;
  const double out_m = radius_m * (1 - std::cos(bend_rad)), step = radius_m * std::sin(bend_rad);
  TrackDetour detour;
  detour.from = from;
  detour.to = from + 4 * step;
  detour.side = side;
  const double beside = x - sense * out_m;
  detour.path = {{{x, from}, {beside, from + step}, sense / radius_m},
                 {{beside, from + step}, {beside, from + 3 * step}, -sense / radius_m},
                 {{beside, from + 3 * step}, {x, from + 4 * step}, sense / radius_m}};
  detour.length_m = length(detour.path);
  return detour;
}

LaidPiece piece_on(int strip, Interval whole, std::vector<TrackDetour> detours) {
  LaidPiece out;
  out.track = strip;
  out.from = whole.from;
  out.to = whole.to;
  out.detours = std::move(detours);
  return out;
}

// Alone on the land, a detour covers its length times the width. Where the next strip is driven as well, it
// covers what lies on its side of the common line only.
TEST(DetourCover, IsTheBandOfADetourLessTheNeighbour) {
  const Polygon body = box_shape(0, 0, 30, 60);
  const std::vector<TrackFamily> families{strips_over_body(0, body)};
  const TrackDetour left = three_arcs(families[0], 4, 20, 12, 0.5, Passing::kLeft);
  const LaidPiece with = piece_on(4, {0, 60}, {left});
  const double alone = covered_by_detours_m2({body}, families, {{families[0].grid, {with}, {}}});
  EXPECT_NEAR(alone, kStrip * left.length_m, 1e-9);
  EXPECT_NEAR(left.length_m, 4 * 12 * 0.5, 1e-9) << "four bends of half a radian";

  const Region band_left = {{band(left.path, kStrip, 1e-7), {}}};
  const double on_neighbour = area(intersection(band_left, {box_shape(9, 0, 12, 60)}));
  ASSERT_GT(on_neighbour, 1);
  const LaidPiece neighbour = piece_on(3, {0, 60}, {});
  EXPECT_NEAR(covered_by_detours_m2({body}, families, {{families[0].grid, {neighbour, with}, {}}}),
              alone - on_neighbour, 1e-4);
}

TEST(DetourCover, IsNothingWithoutDetoursAndOnlyWithinTheBody) {
  const Polygon body = box_shape(0, 0, 30, 60);
  const std::vector<TrackFamily> families{strips_over_body(0, body)};
  EXPECT_EQ(covered_by_detours_m2({body}, families, {{families[0].grid, {piece_on(2, {0, 60}, {})}, {}}}), 0);
  const TrackDetour left = three_arcs(families[0], 4, 20, 12, 0.5, Passing::kLeft);
  const Region elsewhere{box_shape(0, 0, 30, 19.9)};
  EXPECT_NEAR(
      covered_by_detours_m2(elsewhere, families, {{families[0].grid, {piece_on(4, {0, 60}, {left})}, {}}}), 0,
      1e-9);
}

Region straight_swaths(const LaidTracks& tracks) {
  Region out;
  for (const LaidPiece& piece : tracks.pieces)
    for (const Interval& part : parts_on_track(piece))
      out.push_back(
          box_shape(tracks.grid.line(piece.track), part.from, tracks.grid.line(piece.track + 1), part.to));
  return tracks.grid.frame.to_field(out);
}

Region detour_bands(const LaidTracks& tracks) {
  Region out;
  for (const LaidPiece& piece : tracks.pieces)
    for (const TrackDetour& detour : piece.detours) out.push_back({band(detour.path, kStrip, 1e-5), {}});
  return tracks.grid.frame.to_field(out);
}

// Two families across one another, some strips driven, some of them with detours that overlap others'.
TEST(DetourCover, OfOverlappingDetoursCountsEveryPlaceOnce) {
  testing::for_each_seed(12, [](std::mt19937_64& random, int) {
    std::uniform_real_distribution<double> degrees(1, 179), start(0.05, 0.4), radius(4, 20), bend(0.1, 0.9);
    std::uniform_int_distribution<int> one_in(0, 2);
    const Polygon body{box_shape(0, 0, 40, 50).outer, {{{15, 20}, {17, 27}, {25, 24}}}};
    const std::vector<TrackFamily> families{strips_over_body(degrees(random), body),
                                            strips_over_body(degrees(random), body)};
    std::vector<LaidTracks> tracks;
    for (const TrackFamily& family : families) {
      tracks.push_back({family.grid, {}, {}});
      for (const Track& strip : family.tracks) {
        if (one_in(random) == 0 || strip.stretches.empty()) continue;
        const Interval whole{strip.stretches.front().from, strip.stretches.back().to};
        LaidPiece piece = piece_on(strip.index, whole, {});
        const TrackDetour detour =
            three_arcs(family, strip.index, whole.from + start(random) * whole.length(), radius(random),
                       bend(random), one_in(random) == 0 ? Passing::kRight : Passing::kLeft);
        if (one_in(random) == 0 && detour.to < whole.to) piece.detours = {detour};
        tracks.back().pieces.push_back(std::move(piece));
      }
    }
    Region straight, bands;
    for (const LaidTracks& laid : tracks) {
      straight = unite(straight, unite(straight_swaths(laid)));
      bands = unite(bands, unite(detour_bands(laid)));
    }
    ASSERT_NEAR(covered_by_detours_m2({body}, families, tracks),
                area(difference(intersection(bands, {body}), straight)), 2e-3);
  });
}

}  // namespace
}  // namespace tramline
