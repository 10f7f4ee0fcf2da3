// AgOpenGPS folders as they are written: read by a second reader, and back by our own, 2 mm over kilometres.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>

#include "io/agopengps/plain_reader.h"
#include "io/export/export_fixture.h"
#include "support/refusals.h"
#include "support/small_plan.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/export/file_set.h"
#include "tramline/io/land/read_fields.h"
#include "tramline/io/log/read_log.h"
#include "tramline/io/terminal/agopengps_folder.h"
#include "tramline/io/terminal/terminal_field.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;
using testing_agopengps::FieldFiles;
using testing_agopengps::Place;
using testing_agopengps::read_plainly;

constexpr double kTwo_mm = 0.002;

class WrittenFolderTest : public ExportTest {
 protected:
  AgOpenGpsReport written(const char* target, LineChoice lines = LineChoice::kSubfields) const {
    return export_agopengps({{plan_file()}, folder_ / target, lines, 0.02, ""});
  }
};

/// In the field's own plane, which is a true projection.
Point local(const Place& place, const LocalFrame& frame) {
  return FrameProjection(frame).from_lonlat({place.lon_deg, place.lat_deg}).value();
}

double distance_to_line(Point p, const std::vector<Point>& line) {
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    out = std::min(out, distance_to_segment(p, line[i], line[i + 1]));
  return out;
}

TEST_F(WrittenFolderTest, ASecondReaderFindsTheBoundaryTo2mm) {
  written("Mill");
  const Plan plan = sample_plan();
  const FieldFiles read = read_plainly(folder_ / "Mill");
  EXPECT_EQ(read.name, "Mill");
  ASSERT_EQ(read.boundaries.size(), 2U);
  // 3.2 km long. Clockwise: the plan's ring the other way round.
  ASSERT_EQ(read.boundaries[0].places.size(), 4U);
  Ring outer;
  for (const Place& place : read.boundaries[0].places) outer.push_back(local(place, plan.field.frame));
  EXPECT_LT(signed_area(outer), 0);
  for (const Point corner : plan.field.outer)
    EXPECT_LT(distance(corner, *std::min_element(outer.begin(), outer.end(),
                                                 [&](Point a, Point b) {
                                                   return distance(a, corner) < distance(b, corner);
                                                 })),
              kTwo_mm);
  Ring hole;
  for (const Place& place : read.boundaries[1].places) hole.push_back(local(place, plan.field.frame));
  EXPECT_NEAR(signed_area(hole), 12, 0.05) << "against the clock";
  EXPECT_FALSE(read.boundaries[1].driven_through);
}

TEST_F(WrittenFolderTest, HeadingsOfABoundaryPointAlongIt) {
  written("Mill");
  const FieldFiles read = read_plainly(folder_ / "Mill");
  const LocalFrame frame = sample_plan().field.frame;
  for (const auto& boundary : read.boundaries) {
    const std::size_t n = boundary.places.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Point before = local(boundary.places[(i + n - 1) % n], frame);
      const Point after = local(boundary.places[(i + 1) % n], frame);
      const double wanted = std::atan2(after.x - before.x, after.y - before.y);
      const double off = std::remainder(boundary.places[i].heading_rad - wanted, 2 * std::numbers::pi);
      EXPECT_NEAR(off, 0, 1e-3);
      EXPECT_GE(boundary.places[i].heading_rad, 0);
    }
  }
}

TEST_F(WrittenFolderTest, TracksAreAbLinesOrCurvesOfShortSteps) {
  const AgOpenGpsReport report = written("Mill", LineChoice::kAll);
  EXPECT_EQ(report.lines, 4U);
  EXPECT_EQ(report.curves, 3U);
  const Plan plan = sample_plan();
  const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kAll, 0.02);
  const FieldFiles read = read_plainly(folder_ / "Mill");
  ASSERT_EQ(read.tracks.size(), lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto& track = read.tracks[i];
    EXPECT_EQ(track.name, lines[i].name);
    EXPECT_EQ(track.mode, lines[i].straight() ? 2 : 4);
    EXPECT_LT(distance(local(track.a, plan.field.frame), lines[i].points.front()), kTwo_mm);
    EXPECT_LT(distance(local(track.b, plan.field.frame), lines[i].points.back()), kTwo_mm);
    if (lines[i].straight()) {
      EXPECT_TRUE(track.places.empty());
      continue;
    }
    ASSERT_GE(track.places.size(), 5U);
    for (std::size_t k = 0; k < track.places.size(); ++k) {
      const Point here = local(track.places[k], plan.field.frame);
      EXPECT_LT(distance_to_line(here, lines[i].points), kTwo_mm);
      const Point before = local(track.places[k > 0 ? k - 1 : 0], plan.field.frame);
      EXPECT_LT(distance(before, here), 5.01);
    }
  }
}

TEST_F(WrittenFolderTest, OurOwnReaderReadsFieldAndLinesBack) {
  written("Mill");
  const Plan plan = sample_plan();
  VectorQuery query;
  query.file = (folder_ / "Mill").string();
  const RawDataset field = read_fields(query);
  const RawFeature& feature = field.layers.at(0).features.at(0);
  EXPECT_EQ(feature.id, "Mill");
  ASSERT_EQ(feature.polygons.at(0).rings.size(), 2U);
  const FrameProjection projection(plan.field.frame);
  for (const Point lonlat : feature.polygons[0].rings[0].points)
    EXPECT_LT(distance_to_line(projection.from_lonlat(lonlat).value(),
                               {plan.field.outer[0], plan.field.outer[1], plan.field.outer[2],
                                plan.field.outer[3], plan.field.outer[0]}),
              kTwo_mm);
  const RawDataset guides = read_guides(query);
  const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kSubfields, 0.02);
  ASSERT_EQ(guides.layers.at(0).features.size(), lines.size());
  const std::vector<Point>& ab = guides.layers[0].features[0].lines.at(0);
  EXPECT_LT(distance(projection.from_lonlat(ab[0]).value(), lines[0].points[0]), kTwo_mm);
  EXPECT_LT(distance(projection.from_lonlat(ab[1]).value(), lines[0].points[1]), kTwo_mm);
}

TEST_F(WrittenFolderTest, HeadlandLinesEndWhereTheBodyBegins) {
  Plan plan = sample_plan();
  plan.body = {
      {{{-1580, -270}, {1570, -260}, {1560, 290}, {-1570, 280}}, {{{5, 5}, {5, 18}, {20, 18}, {20, 5}}}}};
  write_plan(plan, folder_ / "plan.gpkg");
  written("Mill");
  const FieldFiles read = read_plainly(folder_ / "Mill");
  ASSERT_EQ(read.headlands.size(), 2U) << "one for each boundary";
  EXPECT_EQ(read.headlands[0].size(), 4U);
  EXPECT_EQ(read.headlands[1].size(), 4U);
  Ring line;
  for (const Place& place : read.headlands[1]) line.push_back(local(place, plan.field.frame));
  EXPECT_NEAR(signed_area(line), 15 * 13, 0.1);
}

/// Of triangles between each three places in turn, as AgOpenGPS draws and adds up a patch.
double area_of(const std::vector<testing_agopengps::Patch>& patches, const LocalFrame& frame) {
  double out = 0;
  for (const auto& patch : patches)
    for (std::size_t i = 0; i + 2 < patch.places.size(); ++i)
      out += std::abs(signed_area({local(patch.places[i], frame), local(patch.places[i + 1], frame),
                                   local(patch.places[i + 2], frame)}));
  return out;
}

TEST_F(WrittenFolderTest, APlanHasNoWorkedLand) {
  written("Mill");
  EXPECT_TRUE(read_plainly(folder_ / "Mill").patches.empty());
  EXPECT_TRUE(fs::exists(folder_ / "Mill/Sections.txt")) << "AgOpenGPS asks for the file";
  EXPECT_EQ(fs::file_size(folder_ / "Mill/Sections.txt"), 0U);
}

// 100 m by 6 m without a gap of 20 m by 3 m.
TEST_F(WrittenFolderTest, LandThatWasWorkedBeforeIsPatches) {
  Plan plan = testing_support::small_plan();
  plan.kind = PlanKind::kRepair;
  plan.body = {{{{30, 0}, {50, 0}, {50, 3}, {30, 3}}, {}}};
  plan.worked = {{{{0, 0}, {30, 0}, {30, 3}, {50, 3}, {50, 0}, {100, 0}, {100, 6}, {0, 6}}, {}}};
  write_plan(plan, folder_ / "plan.gpkg");
  written("Mill");
  const FieldFiles read = read_plainly(folder_ / "Mill");
  // Sides of 3 and 20 m, whose ends are off by half a millimetre.
  EXPECT_NEAR(area_of(read.patches, plan.field.frame), 600 - 60, 0.3);
  for (const auto& patch : read.patches)
    for (const Place& place : patch.places) {
      const Point at = local(place, plan.field.frame);
      EXPECT_FALSE(at.x > 30.01 && at.x < 49.99 && at.y < 2.99) << "in the gap";
    }
}

TEST_F(WrittenFolderTest, OfACoverageTheWorkedLandIsReadBackAsALog) {
  Coverage coverage;
  coverage.field_id = "strip";
  coverage.frame = {true, 13, 52, 0, 0};
  coverage.field = {{{{0, 0}, {100, 0}, {100, 60}, {0, 60}}, {}}};
  // 30 m wide with a gap inside, reaching 10 m beyond the field.
  coverage.covered = {
      {{{-10, 10}, {100, 10}, {100, 40}, {-10, 40}}, {{{20, 20}, {20, 30}, {50, 30}, {50, 20}}}}};
  const TerminalField field = terminal_fields(coverage, 0.02, "coverage.gpkg").at(0);
  const auto files = agopengps_files(field, "strip");
  fs::create_directories(folder_ / "strip");
  for (const NamedFile& file : files)
    std::ofstream(folder_ / "strip" / file.name, std::ios::binary) << file.content;
  const FieldFiles read = read_plainly(folder_ / "strip");
  EXPECT_NEAR(area_of(read.patches, coverage.frame), 3000 - 300, 0.3);
  const WorkLog log = read_log((folder_ / "strip").string());
  double log_m2 = 0;
  const FrameProjection projection(coverage.frame);
  for (const Polygon& shape : log.shapes) {
    Ring metres;
    for (const Point p : shape.outer) metres.push_back(projection.from_lonlat(p).value());
    log_m2 += std::abs(signed_area(metres));
  }
  EXPECT_NEAR(log_m2, 3000 - 300, 0.3);
  EXPECT_EQ(log.shapes.size(), read.patches.size());
}

// The island's headland meets that of the edge: it has none of its own.
TEST_F(WrittenFolderTest, AnIslandNearTheEdgeHasNoHeadlandLineOfItsOwn) {
  Plan plan = testing_support::small_plan();
  plan.field.outer = {{0, 0}, {200, 0}, {200, 100}, {0, 100}};
  plan.field.obstacles = {
      {{{{50, 3}, {60, 3}, {60, 9}, {50, 9}}, {}}, ObstacleKind::kObstacle, "hole 1"},
      {{{{120, 50}, {124, 50}, {124, 54}, {120, 54}}, {}}, ObstacleKind::kObstacle, "hole 2"}};
  plan.body = {{{{6, 6}, {44, 6}, {44, 15}, {66, 15}, {66, 6}, {194, 6}, {194, 94}, {6, 94}},
                {{{114, 44}, {114, 60}, {130, 60}, {130, 44}}}}};
  plan.headland.ground = {{plan.field.outer, {plan.body[0].outer}}};
  write_plan(plan, folder_ / "plan.gpkg");
  written("Mill");
  const FieldFiles read = read_plainly(folder_ / "Mill");
  ASSERT_EQ(read.boundaries.size(), 3U);
  ASSERT_EQ(read.headlands.size(), 3U) << "one for each boundary, in their order";
  EXPECT_EQ(read.headlands[0].size(), 8U);
  EXPECT_TRUE(read.headlands[1].empty());
  EXPECT_EQ(read.headlands[2].size(), 4U);
}

TEST_F(WrittenFolderTest, WhatCannotBeWrittenIsNamedAsTheUserDoes) {
  const std::string sentence = testing_support::error_of([&] {
                                 write_folder({{"a/Field.txt", "x"}, {"a", "y"}}, folder_ / "Mill");
                               }).what();
  EXPECT_TRUE(testing_support::mentions(sentence, (folder_ / "Mill/a").string())) << sentence;
  EXPECT_FALSE(testing_support::mentions(sentence, ".part")) << sentence;
  EXPECT_FALSE(fs::exists(folder_ / "Mill"));
}

TEST_F(WrittenFolderTest, SeveralPlansGetAFolderEach) {
  write_plan(testing_support::small_plan(), folder_ / "small.gpkg");
  const AgOpenGpsReport report = export_agopengps(
      {{plan_file(), folder_ / "small.gpkg"}, folder_ / "Fields", LineChoice::kSubfields, 0.02, ""});
  EXPECT_EQ(report.folders, (std::vector<std::string>{"Grosse Breite", "small"}));
  EXPECT_EQ(read_plainly(folder_ / "Fields/Grosse Breite").name, "Grosse Breite");
  EXPECT_TRUE(read_plainly(folder_ / "Fields/small").headlands.empty());
  EXPECT_REFUSED(written("Fields"));
  EXPECT_RUN_FAILURE(export_agopengps({{plan_file()}, "/proc/Mill", LineChoice::kSubfields, 0.02, ""}));
}

}  // namespace
}  // namespace tramline::io
