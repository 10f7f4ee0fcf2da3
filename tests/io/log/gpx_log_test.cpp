#include "tramline/io/log/gpx_log.h"
#include "support/refusals.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

const std::string kGpx = R"(<?xml version="1.0"?>
<gpx version="1.1" xmlns="http://www.topografix.com/GPX/1/1" xmlns:gpxtpx="http://www.garmin.com/xmlschemas/TrackPointExtension/v2">
 <wpt lat="1" lon="1"/>
 <trk><trkseg>
  <trkpt lat="52.25" lon="10.5"><ele>80</ele><time>2020-01-02T17:30:20Z</time>
   <extensions><gpxtpx:TrackPointExtension><gpxtpx:speed>2</gpxtpx:speed><gpxtpx:course>90</gpxtpx:course>
   </gpxtpx:TrackPointExtension></extensions></trkpt>
  <trkpt lat="97" lon="10.5"/>
  <trkpt lon="10.5"/>
  <trkpt lat="52.26" lon="10.5"><speed>0.1</speed><course>90</course></trkpt>
 </trkseg><trkseg><trkpt lat="52.27" lon="10.5"/></trkseg></trk>
 <trk><trkseg><trkpt lat="52.28" lon="10.5"/></trkseg></trk>
</gpx>)";

TEST(GpxLog, SegmentsAreUnits) {
  const WorkLog log = read_gpx_log(kGpx, "'t.gpx'");
  ASSERT_EQ(log.fixes.size(), 4U);
  EXPECT_EQ(log.fixes[0].position, (Point{10.5, 52.25}));
  EXPECT_DOUBLE_EQ(log.fixes[0].time_s, 18263 * 86400.0 + 63020);
  EXPECT_DOUBLE_EQ(log.fixes[0].speed_mps, 2);
  EXPECT_NEAR(log.fixes[0].heading.degrees(), 90, 1e-9);
  // As good as standing.
  EXPECT_TRUE(std::isnan(log.fixes[1].heading.degrees()));
  EXPECT_EQ(log.fixes[1].record, 4U);
  EXPECT_EQ(log.fixes[0].unit, 0);
  EXPECT_EQ(log.fixes[1].unit, 0);
  EXPECT_EQ(log.fixes[2].unit, 1);
  EXPECT_EQ(log.fixes[3].unit, 2);
  EXPECT_EQ(log.skipped.count, 2U);
}

TEST(GpxLog, DamagedOrWithoutTracks) {
  EXPECT_REFUSED(read_gpx_log(kGpx.substr(0, 400), "'t.gpx'"));
  EXPECT_REFUSED(read_gpx_log("<gpx><wpt lat='1' lon='1'/></gpx>", "'t.gpx'"));
  EXPECT_REFUSED(read_gpx_log("", "'t.gpx'"));
}

}  // namespace
}  // namespace tramline::io
