// Random rings on a coarse grid: crossings, touching edges, spikes and doubled points in every mixture.
// Whatever happens, the area that was drawn and the changes that were noted have to add up to what is left.

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "admission/feature.h"
#include "tramline/geometry/error.h"

namespace tramline::testing_features {
namespace {

class RandomRings : public testing::TestWithParam<int> {
 protected:
  std::mt19937 random_{static_cast<unsigned>(GetParam())};

  int number(int low, int high) {
    return low + static_cast<int>(random_() % static_cast<unsigned>(high - low + 1));
  }

  RawRing ring(int vertices, int low, int high) {
    RawRing out;
    for (int i = 0; i < vertices; ++i)
      out.points.push_back({10.0 * number(low, high), 10.0 * number(low, high)});
    out.closed = number(0, 9) > 0;
    return out;
  }

  /// A convex outer ring half of the time, so that holes and not crossings are at issue.
  RawFeature feature() {
    RawFeature out;
    out.geometry_type = "Polygon";
    RawPolygon part;
    if (number(0, 1) == 0)
      part.rings.push_back({{{0, 0}, {100, 0}, {100, 100}, {0, 100}}, true});
    else
      part.rings.push_back(ring(number(3, 9), 0, 10));
    const int holes = number(0, 4);
    for (int h = 0; h < holes; ++h) part.rings.push_back(ring(number(2, 5), -1, 11));
    out.polygons.push_back(part);
    return out;
  }
};

TEST_P(RandomRings, AreAdmittedSoundlyOrRefused) {
  int admitted = 0, refused = 0;
  for (int round = 0; round < 400; ++round) {
    const RawFeature raw = feature();
    try {
      double left_m2 = 0, changed_m2 = 0;
      for (const Field& field : admit_plain(raw).fields) {
        expect_admissible(field);
        left_m2 += workable_m2(field);
        changed_m2 += changes_m2(field);
      }
      // The grid of the polygon engine moves vertices by up to 1e-6 m.
      EXPECT_NEAR(drawn_m2(raw) + changed_m2, left_m2, 0.02) << "seed " << GetParam() << ", round " << round;
      ++admitted;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput)
          << "seed " << GetParam() << ", round " << round << ": " << error.what();
      ++refused;
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(admitted, 100);
  EXPECT_GT(refused, 10);
}

INSTANTIATE_TEST_SUITE_P(Seeds, RandomRings, testing::Range(1, 11));

}  // namespace
}  // namespace tramline::testing_features
