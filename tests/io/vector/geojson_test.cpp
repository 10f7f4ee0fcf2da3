// What GeoJSON says in its own ways.

#include "io/vector/files.h"

namespace tramline::testing_files {
namespace {

using GeoJson = Files;

std::string collection(const std::string& members, const std::string& geometry) {
  return R"({"type": "FeatureCollection", "features": [{"type": "Feature", )" + members + R"("geometry": )" +
         geometry + "}]}";
}
const char* const kSquare =
    R"({"type": "Polygon", "coordinates": [[[9, 50], [9.01, 50], [9.01, 50.01], [9, 50.01], [9, 50]]]})";

TEST_F(GeoJson, IdIsThePropertyOrTheMember) {
  const auto id = [&](const std::string& members) {
    return read_vector(query(write("f.geojson", collection(members, kSquare)))).layers[0].features[0].id;
  };
  EXPECT_EQ(id(R"("properties": {"id": "north"}, )"), "north");
  EXPECT_EQ(id(R"("properties": {"ID": 12}, )"), "12");
  EXPECT_EQ(id(R"("id": "south", "properties": {}, )"), "south");
  EXPECT_EQ(id(R"("id": 7, "properties": {}, )"), "7");
  EXPECT_EQ(id(R"("properties": {"idea": "no"}, )"), "");
}

TEST_F(GeoJson, PrescribesItsWindingAndItsCrs) {
  const RawDataset dataset =
      read_vector(query(write("f.geojson", collection("\"properties\": {}, ", kSquare))));
  EXPECT_EQ(dataset.winding, RingWinding::kPrescribed);
  EXPECT_EQ(dataset.driver, "GeoJSON");
  EXPECT_NE(dataset.layers[0].crs.find("WGS 84"), std::string::npos);
}

TEST_F(GeoJson, AnUnclosedRingIsHandedOnAsSuch) {
  const RawDataset dataset = read_vector(
      query(write("f.geojson",
                  collection("\"properties\": {}, ",
                             R"({"type": "Polygon", "coordinates": [[[9, 50], [9.01, 50], [9, 50.01]]]})"))));
  const RawRing& ring = dataset.layers[0].features[0].polygons[0].rings[0];
  EXPECT_FALSE(ring.closed);
  EXPECT_EQ(ring.points, (std::vector<Point>{{9, 50}, {9.01, 50}, {9, 50.01}}));
}

TEST_F(GeoJson, CollectionsAreFlattened) {
  const std::string parts = std::string(R"({"type": "GeometryCollection", "geometries": [)") + kSquare +
                            R"(, {"type": "Point", "coordinates": [9, 50]},
                              {"type": "MultiLineString", "coordinates": [[[9, 50], [9, 51]], [[8, 50], [8, 51]]]}]})";
  const RawDataset dataset =
      read_vector(query(write("f.geojson", collection("\"properties\": {}, ", parts))));
  const RawFeature& feature = dataset.layers[0].features[0];
  EXPECT_EQ(feature.polygons.size(), 1u);
  EXPECT_EQ(feature.points.size(), 1u);
  EXPECT_EQ(feature.lines.size(), 2u);
}

TEST_F(GeoJson, AFeatureWithoutGeometryIsHandedOn) {
  const RawDataset dataset =
      read_vector(query(write("f.geojson", collection("\"properties\": {}, ", "null"))));
  EXPECT_EQ(dataset.layers[0].features[0].geometry_type, "none");
}

}  // namespace
}  // namespace tramline::testing_files
