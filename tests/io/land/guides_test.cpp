// Guide lines from terminals and from other programs: of every kind, and with names that repeat.

#include <gtest/gtest.h>

#include "io/land/small_files.h"
#include "support/refusals.h"
#include "tramline/io/land/read_fields.h"

namespace tramline::io::guides_test {

using testing_land::pattern;
using testing_land::task_set;
using testing_support::mentions;
using testing_support::refusal_of;

class Guides : public testing_land::LandFiles {
 protected:
  RawDataset guides_of(const std::string& file, const std::string& where = "") const {
    VectorQuery query;
    query.file = file;
    query.where = where;
    query.all_layers = true;
    return read_guides(query);
  }
  RawDataset in_set(const std::string& inside, const std::string& where = "") const {
    write("TASKDATA.XML", task_set("<PFD A=\"PFD1\">" + inside + "</PFD>"));
    return guides_of(path("TASKDATA.XML"), where);
  }
};

RawFeature only_line(const RawDataset& guides) {
  EXPECT_EQ(guides.layers.at(0).features.size(), 1U);
  return guides.layers.at(0).features.at(0);
}

/// From the start of a line to its end in metres east and north. At 52° N the radii of curvature of WGS 84
/// are 6,375,150 m along the meridian and 6,391,435 m across it, so a degree of latitude is 111,267.35 m, one
/// of longitude 68,678.02 m (by hand).
Point metres_along(const std::vector<Point>& line) {
  return {(line.back().x - line.front().x) * 68678.02, (line.back().y - line.front().y) * 111267.35};
}

// 100 m to the north, to the east, and at 210°: 50 m to the west and 86.603 m to the south.
TEST_F(Guides, AnAPlusLineRunsAlongItsHeading) {
  struct Case {
    const char* heading;
    Point metres;
  };
  for (const Case& c : {Case{"0", {0, 100}}, Case{"90", {100, 0}}, Case{"210", {-50, -86.603}}}) {
    const RawDataset guides =
        in_set(pattern(1, "A plus", 2, {{5, 52}}, std::string("G=\"") + c.heading + "\""));
    const RawFeature guide = only_line(guides);
    EXPECT_EQ(guide.attributes.at("role"), "track");
    ASSERT_EQ(guide.lines.at(0).size(), 2U);
    EXPECT_EQ(guide.lines[0][0], (Point{5, 52}));
    EXPECT_NEAR(metres_along(guide.lines[0]).x, c.metres.x, 0.01) << c.heading;
    EXPECT_NEAR(metres_along(guide.lines[0]).y, c.metres.y, 0.01) << c.heading;
  }
}

TEST_F(Guides, AnAPlusLineOfTwoPointsIsTheLineBetweenThem) {
  const RawDataset guides = in_set(pattern(1, "A plus", 2, {{5, 52}, {5.001, 52.002}}, R"(G="0")"));
  EXPECT_EQ(only_line(guides).lines.at(0), (std::vector<Point>{{5, 52}, {5.001, 52.002}}));
}

TEST_F(Guides, WhatIsNoLineIsToldWithItsReason) {
  const RawDataset guides =
      in_set(pattern(1, "Pivot", 4, {{5, 52}, {5.001, 52}}) + pattern(2, "No heading", 2, {{5, 52}}) +
             pattern(3, "One point", 1, {{5, 52}}) +
             pattern(4, "Spiral", 5, {{5, 52}, {5.001, 52}, {5.001, 52.001}}));
  EXPECT_EQ(only_line(guides).id, "GPN4");
  ASSERT_EQ(guides.skipped.size(), 3U);
  EXPECT_TRUE(mentions(guides.skipped[0].why, "pivot")) << guides.skipped[0].why;
  EXPECT_TRUE(mentions(guides.skipped[1].why, "a point and a heading")) << guides.skipped[1].why;
  EXPECT_TRUE(mentions(guides.skipped[2].why, "two points")) << guides.skipped[2].why;
}

TEST_F(Guides, ASetOfPivotsHasNoLine) {
  EXPECT_TRUE(mentions(refusal_of([&] { in_set(pattern(1, "Pivot", 4, {{5, 52}, {5.001, 52}})); }), "pivot"));
}

// Two fields, each with an "AB 1": the name finds both, the id one.
TEST_F(Guides, NamesThatRepeatInATaskSetAreToldApartById) {
  const std::vector<Point> one = {{5, 52}, {5.001, 52}}, other = {{6, 52}, {6.001, 52}};
  const std::string second = "</PFD><PFD A=\"PFD2\">";
  const std::string inside = pattern(1, "AB 1", 1, one) + second + pattern(2, "AB 1", 1, other);
  EXPECT_EQ(in_set(inside, "name = 'AB 1'").layers.at(0).features.size(), 2U);
  EXPECT_EQ(only_line(in_set(inside, "id='GPN2'")).lines.at(0), other);
  EXPECT_TRUE(mentions(refusal_of([&] { in_set(inside, "id='GPN3'"); }), "there are GPN1, GPN2"));
}

TEST_F(Guides, NamesThatRepeatInAFieldFolderGetANumber) {
  const std::string north = "AB\n0\n10,0\n10,90\n0\n2\nTrue\n0\n",
                    east = "AB\n1.5708\n0,10\n90,10\n0\n2\nTrue\n0\n";
  const std::string folder = write_folder("Mill", north + east + north);
  EXPECT_EQ(guides_of(folder, "name='AB'").layers.at(0).features.size(), 3U);
  const std::vector<Point> line = only_line(guides_of(folder, "id='AB (2)'")).lines.at(0);
  EXPECT_NEAR(metres_along(line).x, 90, 0.01);
  EXPECT_NEAR(metres_along(line).y, 0, 0.01);
  EXPECT_EQ(only_line(guides_of(folder, "id='AB (3)'")).attributes.at("name"), "AB");
}

TEST_F(Guides, PivotsOfAFieldFolderAreTold) {
  const std::string folder = write_folder("Mill", "Round\n0\n5,5\n0,0\n0\n64\nTrue\n0\n");
  const RawDataset guides = guides_of(folder);
  EXPECT_TRUE(guides.layers.at(0).features.empty());
  ASSERT_EQ(guides.skipped.size(), 1U);
  EXPECT_TRUE(mentions(guides.skipped[0].why, "pivot"));
  const std::string wrong = write_folder("Wrong", "AB\n0\n10,0\n10,90\n0\n1e300\nTrue\n0\n");
  EXPECT_TRUE(mentions(refusal_of([&] { guides_of(wrong); }), "line 7: a mode"));
}

TEST_F(Guides, KmlAsOtherProgramsWriteIt) {
  // Blanks and line breaks between the places, heights behind them, a namespace of an older version.
  const std::string file = write("lines.kml", R"(<?xml version="1.0" encoding="UTF-8"?>
<kml xmlns="http://earth.google.com/kml/2.1"><Document><Folder><Placemark><name>AB 90</name><LineString>
<coordinates>5,52,0
  5.001,52,12.5   5.002,52.001,0</coordinates></LineString></Placemark>
<Placemark><name>Gate</name><Point><coordinates>5,52</coordinates></Point></Placemark></Folder></Document></kml>)");
  const RawDataset guides = guides_of(file);
  std::vector<std::vector<Point>> lines;
  for (const RawLayer& layer : guides.layers)
    for (const RawFeature& feature : layer.features) {
      EXPECT_EQ(feature.attributes.count("role"), 0U) << "a border of two swaths";
      lines.insert(lines.end(), feature.lines.begin(), feature.lines.end());
    }
  ASSERT_EQ(lines.size(), 1U);
  EXPECT_EQ(lines[0], (std::vector<Point>{{5, 52}, {5.001, 52}, {5.002, 52.001}}));
}

TEST_F(Guides, ShapefilesWithTheirOwnCoordinates) {
  testing_files::write_layer("ESRI Shapefile", path("lines.shp"), "lines", 25832,
                             {{"north", "LINESTRING (500000 5761000, 500000 5761100)"},
                              {"bend", "LINESTRING (500000 5761000, 500050 5761000, 500060 5761020)"}});
  EXPECT_EQ(guides_of(path("lines.shp")).layers.at(0).features.size(), 2U);
  const RawDataset one = guides_of(path("lines.shp"), "id = 'bend'");
  ASSERT_EQ(one.layers.at(0).features.size(), 1U);
  EXPECT_EQ(one.layers[0].features[0].lines.at(0),
            (std::vector<Point>{{500000, 5761000}, {500050, 5761000}, {500060, 5761020}}));
  EXPECT_TRUE(mentions(one.layers[0].crs, "25832") || mentions(one.layers[0].crs, "zone 32N"));
}

}  // namespace tramline::io::guides_test
