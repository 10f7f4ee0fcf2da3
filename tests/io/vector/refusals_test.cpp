// What cannot be read ends in one sentence, and GDAL stays silent.

#include "io/vector/files.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::testing_files {
namespace {

class Unreadable : public Files {
 protected:
  const std::string square_ = "POLYGON ((0 0, 100 0, 100 50, 0 0))";
  void expect(const VectorQuery& query, const std::string& part) const {
    const std::string sentence = refusal(query);
    EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
};

TEST_F(Unreadable, MissingFile) {
  expect(query(path("nowhere.gpkg")), "there is no file '" + path("nowhere.gpkg") + "'");
}

TEST_F(Unreadable, NotAVectorFile) {
  expect(query(write("a.geojson", "hello")), "cannot be read as a vector file");
  expect(query(write("b.shp", "")), "cannot be read as a vector file");
  expect(query(write("c.geojson", R"({"type": "FeatureCollection", "features": [)")), "c.geojson");
}

TEST_F(Unreadable, TruncatedGeoPackage) {
  std::vector<Row> rows;
  for (int i = 0; i < 2000; ++i) rows.push_back({"field " + std::to_string(i), square_});
  write_layer("GPKG", path("whole.gpkg"), "fields", 25832, rows);
  const std::string bytes = bytes_of(path("whole.gpkg"));
  // Cut in the schema and in the rows.
  for (const double share : {0.02, 0.2, 0.5, 0.8}) {
    const auto kept = static_cast<std::size_t>(share * static_cast<double>(bytes.size()));
    expect(query(write("cut.gpkg", bytes.substr(0, kept))), "cut.gpkg");
  }
}

TEST_F(Unreadable, TruncatedShapefile) {
  std::vector<Row> rows(200, {"x", square_});
  write_layer("ESRI Shapefile", path("f.shp"), "f", 25832, rows);
  const std::string bytes = bytes_of(path("f.shp"));
  write("f.shp", bytes.substr(0, bytes.size() / 2));
  expect(query(path("f.shp")), "damaged");
}

TEST_F(Unreadable, UnknownLayerListsThoseFound) {
  write_layer("GPKG", path("f.gpkg"), "fields", 25832, {{"a", square_}});
  expect(query(path("f.gpkg"), "meadows"), "has no layer 'meadows'; found fields (Polygon)");
}

TEST_F(Unreadable, SeveralLayersWithPolygons) {
  write_layer("GPKG", path("f.gpkg"), "north", 25832, {{"a", square_}});
  write_layer("GPKG", path("f.gpkg"), "south", 25832, {{"b", square_}}, true);
  expect(query(path("f.gpkg")), "choose one with --layer: north (Polygon), south (Polygon)");
}

TEST_F(Unreadable, FiltersThatAreNoFilters) {
  write_layer("GPKG", path("f.gpkg"), "fields", 25832, {{"a", square_}});
  write_layer("FlatGeobuf", path("f.fgb"), "fields", 25832, {{"a", square_}});
  for (const char* file : {"f.gpkg", "f.fgb"}) {
    expect(query(path(file), "", "id === 3"), "--where \"id === 3\"");
    expect(query(path(file), "", "nonsense = 3"), "--where \"nonsense = 3\"");
    expect(query(path(file), "", "id = 'z'"), "no feature of '" + path(file) + "' matches");
  }
}

TEST_F(Unreadable, NoFeatures) {
  expect(query(write("f.geojson", R"({"type": "FeatureCollection", "features": []})")), "f.geojson");
}

TEST_F(Unreadable, NoFeatureOfThisNumber) {
  write_layer("GPKG", path("f.gpkg"), "fields", 25832, {{"a", square_}});
  VectorQuery by_number = query(path("f.gpkg"));
  by_number.fid = 99;
  expect(by_number, "has no feature with number 99");
}

TEST(ShownName, MasksPasswords) {
  EXPECT_EQ(shown_name("PG:dbname=farm password=a host=h"), "PG:dbname=farm password=*** host=h");
  EXPECT_EQ(shown_name("PG:Password='a b' user=u"), "PG:Password=*** user=u");
  EXPECT_EQ(shown_name("PG:password=a"), "PG:password=***");
  EXPECT_EQ(shown_name("PG:password="), "PG:password=***");
  EXPECT_EQ(shown_name("postgresql://me:secret@host:5432/farm"), "postgresql://me:***@host:5432/farm");
  EXPECT_EQ(shown_name("folder/field@home.gpkg"), "folder/field@home.gpkg");
}

TEST(DatabaseString, IsAWordAndAColonButNoPath) {
  EXPECT_TRUE(is_database_string("PG:dbname=farm"));
  EXPECT_FALSE(is_database_string("field.gpkg"));
  EXPECT_FALSE(is_database_string("C:field.gpkg"));
  EXPECT_FALSE(is_database_string("a folder/b:c.gpkg"));
}

TEST_F(Unreadable, DatabaseStringsThatCannotBeOpenedDoNotShowThePassword) {
  const std::string sentence = refusal(query("PG:host=/nonexistent dbname=farm password=secret"));
  EXPECT_NE(sentence.find("password=***"), std::string::npos) << sentence;
  EXPECT_EQ(sentence.find("secret"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace tramline::testing_files
