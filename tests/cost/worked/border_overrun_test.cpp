// Swaths that run on over a border: by hand, and against polygon booleans.

#include "tramline/cost/worked/border_overrun.h"

#include <gtest/gtest.h>

#include "properties/seeds.h"
#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/curved_tracks.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline::border_overrun_test {

constexpr double kWidth = 3;

Polygon rectangle_of(double min_x, double min_y, double max_x, double max_y) {
  return {{{min_x, min_y}, {max_x, min_y}, {max_x, max_y}, {min_x, max_y}}, {}};
}

Direction at_degrees(double degrees) { return Direction::clockwise_from_north(Angle::degrees(degrees)); }

LaidTracks covering(const Subfield& subfield, double origin_m) {
  const StripGrid grid{TrackFrame(subfield.direction), origin_m, kWidth};
  return cut_pieces(straight_tracks(grid, grid.frame.to_track(Region{subfield.shape}).front(), {},
                                    {false, kWidthTolerance}),
                    0);
}

// Ten metres by strips of three: the fourth swath reaches 2 m over the border at x = 10, 20 m long.
TEST(BorderOverrun, IsTheLandBeyondTheBorderThatNobodyElseCovers) {
  const std::vector<Subfield> halves{{rectangle_of(0, 0, 10, 20), at_degrees(0)},
                                     {rectangle_of(10, 0, 20, 20), at_degrees(0)}};
  const LaidTracks west = covering(halves[0], 0);
  ASSERT_EQ(west.pieces.size(), 4u);
  const LaidTracks nothing{{TrackFrame(at_degrees(0)), 10, kWidth}, {}, {}};
  EXPECT_NEAR(covered_by_neighbours_m2(halves, {west, nothing}), 2 * 20, 1e-9);
  // The neighbour covers all of its own land.
  EXPECT_NEAR(covered_by_neighbours_m2(halves, {west, covering(halves[1], 10)}), 0, 1e-9);
  // Where its first strip begins 1.5 m beyond the border, it leaves that much to the neighbour.
  LaidTracks late = covering(halves[1], 11.5);
  std::erase_if(late.pieces, [&](const LaidPiece& piece) { return late.grid.line(piece.track) < 11; });
  EXPECT_NEAR(covered_by_neighbours_m2(halves, {west, late}), 1.5 * 20, 1e-9);
}

TEST(BorderOverrun, OfOneSubfieldIsNone) {
  const std::vector<Subfield> one{{rectangle_of(0, 0, 10, 20), at_degrees(0)}};
  EXPECT_EQ(covered_by_neighbours_m2(one, {covering(one[0], 0)}), 0);
}

Region swaths_of(const LaidTracks& tracks) {
  Region out;
  for (const LaidPiece& piece : tracks.pieces) {
    Path path = piece.path;
    if (path.empty()) {
      const double across = tracks.grid.centre(piece.track);
      path = straight_path({across, piece.from}, {across, piece.to});
    }
    out.push_back(
        {band(moved(path, [&](Point p) { return tracks.grid.frame.to_field(p); }), kWidth, 1e-5), {}});
  }
  return unite(out);
}

double by_booleans(const std::vector<Subfield>& subfields, const std::vector<LaidTracks>& tracks) {
  double sum = 0;
  for (std::size_t host = 0; host < subfields.size(); ++host) {
    Region others;
    for (std::size_t other = 0; other < subfields.size(); ++other)
      if (other != host) others = unite(others, swaths_of(tracks[other]));
    sum += area(difference(intersection({subfields[host].shape}, others), swaths_of(tracks[host])));
  }
  return sum;
}

/// Three parts of 40 m × 30 m with slanting borders, one of them with a hole at a border.
std::vector<Subfield> three_parts(std::mt19937_64& random) {
  std::uniform_real_distribution<double> slant(-8, 8), degrees(0, 180);
  const double low = 14 + slant(random), high = 14 + slant(random), right = 15 + 0.5 * slant(random);
  const double x = 0.5 * (low + high);
  return {{{{{0, 0}, {low, 0}, {high, 30}, {0, 30}}, {}}, at_degrees(degrees(random))},
          {{{{low, 0}, {40, 0}, {40, right}, {x, 15}}, {{{x + 4, 9}, {x + 6, 12}, {x + 8, 8}}}},
           at_degrees(degrees(random))},
          {{{{x, 15}, {40, right}, {40, 30}, {high, 30}}, {}}, at_degrees(degrees(random))}};
}

/// Some swaths of the subfield, so that land is left for the neighbours' to cover.
LaidTracks some_of(LaidTracks all, std::mt19937_64& random) {
  std::uniform_int_distribution<int> one_in_four(0, 3);
  std::erase_if(all.pieces, [&](const LaidPiece&) { return one_in_four(random) == 0; });
  return all;
}

TEST(BorderOverrun, OfStripsIsThatOfBooleans) {
  double most = 0;
  testing::for_each_seed(12, [&](std::mt19937_64& random, int) {
    const std::vector<Subfield> subfields = three_parts(random);
    std::uniform_real_distribution<double> origin(0, kWidth);
    std::vector<LaidTracks> tracks;
    for (const Subfield& subfield : subfields)
      tracks.push_back(some_of(covering(subfield, origin(random)), random));
    const double expected = by_booleans(subfields, tracks);
    most = std::max(most, expected);
    ASSERT_NEAR(covered_by_neighbours_m2(subfields, tracks), expected, 5e-3);
  });
  if (testing::case_count(12) >= 12) {
    EXPECT_GT(most, 1) << "swaths run over the borders";
  }
}

// The first subfield along arcs, the others in strips.
TEST(BorderOverrun, OfCurvesIsThatOfBooleans) {
  testing::for_each_seed(4, [](std::mt19937_64& random, int) {
    const std::vector<Subfield> subfields = three_parts(random);
    const Path reference{{{45, -20}, {-15, 40}, 1 / 60.0}};
    std::vector<LaidTracks> tracks{
        some_of(cut_pieces(curved_tracks(parallel_family(reference, -12, 12, {6, kWidth}), kWidth,
                                         {EdgeIndex(Region{subfields[0].shape})}, {false, kWidthTolerance}),
                           0),
                random)};
    ASSERT_FALSE(tracks[0].pieces.empty());
    ASSERT_FALSE(tracks[0].pieces.front().path.empty());
    for (std::size_t i = 1; i < subfields.size(); ++i)
      tracks.push_back(some_of(covering(subfields[i], 0.4), random));
    ASSERT_NEAR(covered_by_neighbours_m2(subfields, tracks), by_booleans(subfields, tracks), 5e-3);
  });
}

}  // namespace tramline::border_overrun_test
