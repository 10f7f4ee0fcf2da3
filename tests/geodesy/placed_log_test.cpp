#include "tramline/geodesy/placed_log.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "tramline/geometry/error.h"

namespace tramline {
namespace {

WorkLog log_at(std::vector<Point> places) {
  WorkLog log;
  log.name = "drive.csv";
  std::size_t record = 0;
  for (const Point p : places) {
    Fix fix;
    fix.position = p;
    fix.record = ++record;
    log.fixes.push_back(fix);
  }
  return log;
}

// On WGS 84 at latitude 52, 0.001° are 111.2567 m northwards and 68.6770 m eastwards (the meridian's radius
// of curvature a(1 − e²)/(1 − e² sin²φ)^1.5 is 6 375 040 m there, and the parallel's a cosφ/√(1 − e² sin²φ) 3
// 934 893 m).
TEST(PlacedLog, IsInMetresFromTheFramesOrigin) {
  LocalFrame frame;
  frame.geodetic = true;
  frame.origin_lon_deg = 10;
  frame.origin_lat_deg = 52;
  const double e2 = 0.00669437999014;
  const double s = std::sin(52 * M_PI / 180);
  const double c = std::cos(52 * M_PI / 180);
  const double north_m = 6378137 * (1 - e2) / std::pow(1 - e2 * s * s, 1.5) * 0.001 * M_PI / 180;
  const double east_m = 6378137 * c / std::sqrt(1 - e2 * s * s) * 0.001 * M_PI / 180;
  const WorkLog local = placed(log_at({{10, 52}, {10, 52.001}, {10.001, 52}}), frame);
  ASSERT_EQ(local.fixes.size(), 3U);
  EXPECT_EQ(local.positions, Positions::kLocal);
  EXPECT_NEAR(length(local.fixes[0].position), 0, 1e-9);
  EXPECT_NEAR(local.fixes[1].position.y, north_m, 2e-3);
  EXPECT_NEAR(local.fixes[2].position.x, east_m, 1e-6);
}

TEST(PlacedLog, SkipsWhatIsNoPlace) {
  LocalFrame frame;
  frame.geodetic = true;
  frame.origin_lon_deg = 10;
  frame.origin_lat_deg = 52;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const WorkLog local =
      placed(log_at({{10, 52}, {0, 0}, {10, 95}, {nan, 52}, {190, 52}, {10, -52}, {10.001, 52}}), frame);
  ASSERT_EQ(local.fixes.size(), 2U);
  EXPECT_EQ(local.fixes[1].record, 7U);
  ASSERT_EQ(local.skipped.count, 5U);
  EXPECT_EQ(local.skipped.listed[0].record, 2U);
  EXPECT_EQ(local.skipped.listed[1].why, "the latitude 95 is past a pole");
}

TEST(PlacedLog, FrameOfALogAlone) {
  const LocalFrame frame = frame_centred_on(log_at({{10, 52}, {0, 0}, {10.002, 52.002}}));
  EXPECT_TRUE(frame.geodetic);
  EXPECT_NEAR(frame.origin_lon_deg, 10.001, 1e-6);
  EXPECT_NEAR(frame.origin_lat_deg, 52.001, 1e-6);
  EXPECT_REFUSED(frame_centred_on(log_at({{0, 0}})));
}

TEST(PlacedLog, PlainMetresAndDegreesDoNotMix) {
  WorkLog plain = log_at({{500, 700}});
  plain.positions = Positions::kLocal;
  LocalFrame frame;
  frame.origin_x_m = 450;
  frame.origin_y_m = 650;
  EXPECT_EQ(placed(plain, frame).fixes.at(0).position, (Point{50, 50}));
  frame.geodetic = true;
  EXPECT_REFUSED(placed(plain, frame));
}

}  // namespace
}  // namespace tramline
