// AgOpenGPS folders as they come from the machine: decimal commas, several kinds of lines, coverage, damage.

#include "tramline/io/agopengps/field_folder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <random>

#include "support/refusals.h"
#include "support/temporary_folder.h"
#include "tramline/io/agopengps/sections_log.h"
#include "tramline/io/land/read_fields.h"
#include "tramline/io/log/read_log.h"

namespace tramline::io {
namespace {

using testing_support::mentions;
using testing_support::refusal_of;

class FieldFolderTest : public testing::Test {
 protected:
  void SetUp() override {
    write("Field.txt",
          "2026-mar.-27\r\n$FieldDir\r\ntest\r\n$Offsets\r\n0,0\r\nConvergence\r\n0\r\nStartFix\r\n"
          "52.0,5.0\r\n");
    write("Boundary.txt", "$Boundary\r\nFalse\r\n4\r\n0,0,0\r\n0,100,1.5\r\n100,100,3.1\r\n100,0,4.7\r\n");
  }
  void write(const char* name, const std::string& text) const { std::ofstream(folder_ / name) << text; }
  std::string path() const { return (folder_ / "").string(); }
  FieldFolder folder() const { return FieldFolder::open(path()).value(); }
  VectorQuery query(const std::string& where = "") const {
    VectorQuery out;
    out.file = path();
    out.where = where;
    return out;
  }
  testing_support::TemporaryFolder folder_;
};

// 100 m at 52°: by the radii of curvature of WGS 84, M = 6,375,150 m and N = 6,391,435 m.
TEST_F(FieldFolderTest, MetresBecomeDegreesAtTheStart) {
  const RawDataset field = field_in(folder());
  const std::vector<Point>& ring = field.layers.at(0).features.at(0).polygons.at(0).rings.at(0).points;
  ASSERT_EQ(ring.size(), 4U);
  EXPECT_NEAR(ring[0].x, 5, 1e-12);
  EXPECT_NEAR(ring[0].y, 52, 1e-12);
  const double degree = 3.14159265358979 / 180;
  const double sine = std::sin(52 * degree), w2 = 1 - 6.69437999014e-3 * sine * sine;
  const double across_m = 6378137 / std::sqrt(w2), along_m = across_m * (1 - 6.69437999014e-3) / w2;
  EXPECT_NEAR((ring[1].y - 52) * degree * along_m, 100, 0.002);
  EXPECT_NEAR((ring[3].x - 5) * degree * across_m * std::cos(52 * degree), 100, 0.002);
}

TEST_F(FieldFolderTest, DecimalCommasAreReadLikePoints) {
  const RawDataset with_points = field_in(folder());
  write("Field.txt", "x\n$FieldDir\ntest\n$Offsets\n0,0\nConvergence\n0\nStartFix\n52,00000000,5,00000000\n");
  write("Boundary.txt",
        "$Boundary\nFalse\n4\n0,000,0,000,0,00000\n0,000,100,000,1,50000\n"
        "100,000,100,000,3,10000\n100,000,0,000,4,70000\n");
  const RawDataset with_commas = field_in(folder());
  EXPECT_EQ(with_points.layers[0].features[0].polygons[0].rings[0].points,
            with_commas.layers[0].features[0].polygons[0].rings[0].points);
}

TEST_F(FieldFolderTest, InnerBoundariesAreHolesUnlessTheyAreDrivenThrough) {
  write("Boundary.txt",
        "$Boundary\nFalse\n4\n0,0,0\n0,100,0\n100,100,0\n100,0,0\n"
        "False\n3\n10,10,0\n20,10,0\n10,20,0\nTrue\n3\n50,50,0\n60,50,0\n50,60,0\n");
  const RawDataset field = field_in(folder());
  EXPECT_EQ(field.layers[0].features[0].polygons[0].rings.size(), 2U);
  ASSERT_EQ(field.skipped.size(), 1U);
  EXPECT_EQ(field.skipped[0].what, "inner boundary 2");
}

TEST_F(FieldFolderTest, TracksAndHeadlandLinesAreGuides) {
  write("TrackLines.txt",
        "$TrackLines\nAB 90\n1.5708\n0,10\n100,10\n0\n2\nTrue\n0\n"
        "Bend\n0.5\n0,0\n20,20\n0\n4\nTrue\n3\n0,0,0\n10,15,0\n20,20,0\n"
        "Pivot\n0\n5,5\n0,0\n0\n64\nTrue\n0\n");
  write("Headlines.txt", "$HeadLines\nHeadland\n12\n0\n0\n2\n1.5 , 2.5 , 0.00000\n3 , 4 , 0\n");
  const RawDataset guides = read_guides(query());
  ASSERT_EQ(guides.layers.at(0).features.size(), 3U);
  EXPECT_EQ(guides.layers[0].features[0].id, "AB 90");
  EXPECT_EQ(guides.layers[0].features[1].lines.at(0).size(), 3U);
  EXPECT_EQ(guides.layers[0].features[2].id, "Headland");
  ASSERT_EQ(guides.skipped.size(), 1U);
  EXPECT_TRUE(mentions(guides.skipped[0].what, "Pivot"));

  const RawDataset one = read_guides(query("name = 'Bend'"));
  ASSERT_EQ(one.layers.at(0).features.size(), 1U);
  EXPECT_TRUE(mentions(refusal_of([&] { read_guides(query("name='Bow'")); }), "AB 90, Bend, Headland"));
}

TEST_F(FieldFolderTest, CoverageIsALogOfShapes) {
  // A section of 4 m drives 10 m north, turns on the spot so that its ends change sides, and ends.
  write("Sections.txt",
        "6\n27, 151, 160\n0,0,0\n4,0,0\n0,10,0\n4,10,0\n4,10,0\n"
        "5\n27,151,160\n10,0,0\n14,0,0\n10,5,0\n14,5,0\n");
  EXPECT_TRUE(mentions(refusal_of([&] { sections_log(folder()); }), "line 2")) << "pairs do not add up";
  write("Sections.txt",
        "7\n27, 151, 160\n0,0,0\n4,0,0\n0,10,0\n4,10,0\n4,20,0\n0,20,0\n"
        "5\n27,151,160\n10,0,0\n14,0,0\n10,5,0\n14,5,0\n");
  const WorkLog log = read_log(path());
  ASSERT_EQ(log.shapes.size(), 4U) << "a quad, two triangles where the sides cross, a quad";
  ASSERT_EQ(log.fixes.size(), 4U);
  const FieldFolder here = folder();
  const auto area_m2 = [&](std::size_t i) {
    Ring metres;
    for (const Point p : log.shapes[i].outer) metres.push_back(here.plane().to_plane(p));
    return signed_area(metres);
  };
  EXPECT_NEAR(area_m2(0), 40, 1e-6);
  EXPECT_NEAR(area_m2(1), 20, 1e-6);
  EXPECT_NEAR(area_m2(3), 20, 1e-6);
  EXPECT_EQ(log.fixes[0].unit, 0);
  EXPECT_EQ(log.fixes[3].unit, 1);
  write("Sections.txt", "");
  EXPECT_TRUE(mentions(refusal_of([&] { read_log(path()); }), "Sections.txt"));
}

TEST_F(FieldFolderTest, WhatCannotBeReadIsNamedWithItsLine) {
  write("Boundary.txt", "$Boundary\nFalse\n4\n0,0,0\n0,x,0\n");
  EXPECT_TRUE(mentions(refusal_of([&] { field_in(folder()); }), "line 3"))
      << "more points announced than there are";
  write("Boundary.txt", "$Boundary\nFalse\n3\n0,0,0\n0,x,0\n1,1,1\n");
  EXPECT_TRUE(mentions(refusal_of([&] { field_in(folder()); }), "line 5"));
  write("Boundary.txt", "$Boundary\n");
  EXPECT_TRUE(mentions(refusal_of([&] { field_in(folder()); }), "no boundary"));
  write("Field.txt", "x\nStartFix\n95.0,5.0\n");
  EXPECT_TRUE(mentions(refusal_of([&] { folder(); }), "95"));
  write("Field.txt", "x\nStartFix\n89.0,5.0\n");
  EXPECT_TRUE(mentions(refusal_of([&] { folder(); }), "line 3: latitude 89 is too near to a pole"));
  write("Field.txt", "x\nStartFix\n52.0,5.0\n");
  write("Boundary.txt", "$Boundary\nFalse\n3\n0,0,0\n0,150000,0\n1,1,1\n");
  EXPECT_TRUE(
      mentions(refusal_of([&] { field_in(folder()); }), "line 5: (0, 150000) is farther than 100 km"));
  write("Field.txt", "x\n");
  EXPECT_TRUE(mentions(refusal_of([&] { folder(); }), "StartFix"));
}

// A degree of longitude is 68.7 km there: 2 km to the east of 179.99° lie beyond 180°.
TEST_F(FieldFolderTest, FieldsMayLieAcrossTheDateLine) {
  write("Field.txt", "x\nStartFix\n52.0,179.99\n");
  write("Boundary.txt", "$Boundary\nFalse\n3\n0,0,0\n2000,0,0\n2000,100,0\n");
  const RawDataset field = field_in(folder());
  const Point east = field.layers.at(0).features.at(0).polygons.at(0).rings.at(0).points.at(1);
  EXPECT_NEAR(east.x, 179.99 + 2000 / 68678.02, 1e-6) << "in one piece with the others";
  EXPECT_NEAR(folder().plane().to_plane(east).x, 2000, 1e-6);
}

/// Damaged files are read as far as they make sense, or refused in a sentence.
TEST_F(FieldFolderTest, DamagedFilesAreReadOrRefused) {
  const std::string field = "x\n$FieldDir\ntest\n$Offsets\n0,0\nConvergence\n0\nStartFix\n52.0,5.0\n";
  const std::string boundary = "$Boundary\nFalse\n4\n0,0,0\n0,100,1.5\n100,100,3.1\n100,0,4.7\n";
  const std::string tracks = "$TrackLines\nAB 90\n1.5708\n0,10\n100,10\n0\n2\nTrue\n0\n";
  const std::string sections = "5\n27,151,160\n10,0,0\n14,0,0\n10,5,0\n14,5,0\n";
  std::mt19937 random(29);
  int refused = 0;
  constexpr int kCases = 300;
  for (int i = 0; i < kCases; ++i) {
    write("Field.txt", i % 4 == 0 ? testing_support::damaged(field, 2, random) : field);
    write("Boundary.txt", testing_support::damaged(boundary, 1 + i % 3, random));
    write("TrackLines.txt", testing_support::damaged(tracks, 1 + i % 3, random));
    write("Sections.txt", testing_support::damaged(sections, 1 + i % 3, random));
    const auto refuses = [](auto call) { return !testing_support::unless_refused(call).has_value(); };
    refused += refuses([&] { return read_fields(query()).layers.size(); }) ? 1 : 0;
    refused += refuses([&] { return read_guides(query()).layers.size(); }) ? 1 : 0;
    refused += refuses([&] { return read_log(path()).fixes.size(); }) ? 1 : 0;
  }
  EXPECT_GT(refused, kCases / 10);
  EXPECT_LT(refused, 3 * kCases);
}

}  // namespace
}  // namespace tramline::io
