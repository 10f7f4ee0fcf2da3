#include "tramline/geodesy/field_projection.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <thread>

#include "tramline/geodesy/frame_text.h"
#include "tramline/geometry/error.h"

namespace tramline {
namespace {

constexpr double kSemiMajor_m = 6378137.0;
constexpr double kFlattening = 1 / 298.257223563;
constexpr double kEccentricitySquared = kFlattening * (2 - kFlattening);

LocalFrame frame_at(double lon, double lat) {
  LocalFrame frame;
  frame.geodetic = true;
  frame.origin_lon_deg = lon;
  frame.origin_lat_deg = lat;
  return frame;
}

// At the equator a small step east is a·λ, a small step north a·(1 − e²)·φ.
TEST(FrameProjection, StepsFromTheEquatorAreMetresOnTheEllipsoid) {
  const FrameProjection projection(frame_at(20, 0));
  const double step = 0.001, radians = step * std::numbers::pi / 180;
  const Point east = projection.from_lonlat({20 + step, 0}).value();
  EXPECT_NEAR(east.x, kSemiMajor_m * radians, 1e-6);
  EXPECT_NEAR(east.y, 0, 1e-9);
  const Point north = projection.from_lonlat({20, step}).value();
  EXPECT_NEAR(north.x, 0, 1e-9);
  EXPECT_NEAR(north.y, kSemiMajor_m * (1 - kEccentricitySquared) * radians, 1e-6);
}

TEST(FrameProjection, ThereAndBackToTheNanometre) {
  const FrameProjection projection(frame_at(9.1234567, 52.7654321));
  for (const Point p : {Point{0, 0}, Point{1500, -900}, Point{-20000, 20000}}) {
    const Point again = projection.from_lonlat(projection.to_lonlat(p)).value();
    EXPECT_NEAR(again.x, p.x, 1e-8);
    EXPECT_NEAR(again.y, p.y, 1e-8);
  }
}

TEST(FrameCentredOn, RoundsItsOriginSoThatSevenDecimalsHoldIt) {
  Box box;
  box.extend(Point{10.00000004, 50});
  box.extend(Point{10.00000008, 50.00000032});
  const LocalFrame frame = frame_centred_on(Crs("EPSG:4326"), box);
  EXPECT_TRUE(frame.geodetic);
  EXPECT_EQ(frame.origin_lon_deg, 10.0000001);
  EXPECT_EQ(frame.origin_lat_deg, 50.0000002);
}

TEST(FrameCentredOn, PlainMetresAreShiftedByWholeMetres) {
  Box box;
  box.extend(Point{1000.25, 2000});
  box.extend(Point{1100.75, 2051});
  const Crs plain;
  const LocalFrame frame = frame_centred_on(plain, box);
  EXPECT_FALSE(frame.geodetic);
  EXPECT_EQ(frame.origin_x_m, 1051);  // 1050.5 rounded away from zero
  EXPECT_EQ(frame.origin_y_m, 2026);
  const FieldProjection projection(plain, frame);
  EXPECT_EQ(projection.to_local({1051.5, 2026}), (Point{0.5, 0}));
  EXPECT_EQ(projection.to_input({0.5, 0}), (Point{1051.5, 2026}));
  EXPECT_RUN_FAILURE(projection.to_lonlat({0, 0}));
}

TEST(FieldProjection, ProjectedInputComesBackToItsOwnCoordinates) {
  const Crs crs("EPSG:25832");
  Box box;
  box.extend(Point{600000, 5800000});
  box.extend(Point{600400, 5800300});
  const FieldProjection projection(crs, frame_centred_on(crs, box));
  const Point input{600123.456, 5800012.345};
  const Point again = projection.to_input(projection.to_local(input).value());
  EXPECT_NEAR(again.x, input.x, 1e-6);
  EXPECT_NEAR(again.y, input.y, 1e-6);
}

TEST(FrameText, TheWktIsTheSamePlane) {
  const LocalFrame frame = frame_at(9.1234567, -33.7654321);
  const Crs crs(wkt(frame));
  const FrameProjection projection(frame);
  const Point lonlat{9.13, -33.76};
  const Point by_text = crs.from_lonlat(lonlat).value(), directly = projection.from_lonlat(lonlat).value();
  EXPECT_NEAR(by_text.x, directly.x, 1e-7);
  EXPECT_NEAR(by_text.y, directly.y, 1e-7);
  EXPECT_NE(proj_string(frame).find("+lat_0=-33.7654321 +lon_0=9.1234567 +k=1"), std::string::npos);
  EXPECT_EQ(proj_string(LocalFrame{}), "");
  EXPECT_EQ(wkt(LocalFrame{}).find('\n'), std::string::npos);
}

TEST(FieldProjection, ObjectsOnDifferentThreadsDoNotDisturbOneAnother) {
  const auto work = [](double lon, int* wrong) {
    const Crs crs("EPSG:4326");
    const FieldProjection projection(crs, frame_at(lon, 45));
    for (int i = 0; i < 2000; ++i)
      if (std::abs(projection.to_local({lon, 45}).value().x) > 1e-9) ++*wrong;
  };
  int wrong_here = 0, wrong_there = 0;
  std::thread other(work, 11, &wrong_there);
  work(-70, &wrong_here);
  other.join();
  EXPECT_EQ(wrong_here + wrong_there, 0);
}

}  // namespace
}  // namespace tramline
