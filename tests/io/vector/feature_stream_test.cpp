// Features read some at a time are those of reading at once, in any order of asking.

#include "tramline/io/vector/feature_stream.h"

#include <fmt/format.h>

#include <algorithm>

#include "io/vector/files.h"
#include "tramline/geometry/error.h"

namespace tramline::testing_files {
namespace {

constexpr int kRows = 23;

std::string square_at(int number) {
  const int x = 100 * number;
  return fmt::format("POLYGON (({0} 0, {1} 0, {1} 50, {0} 50, {0} 0))", x, x + 60);
}

class Streams : public Files {
 protected:
  /// kRows squares named f0, f1 …
  std::string written(const std::string& driver, const std::string& name) const {
    std::vector<Row> rows;
    for (int i = 0; i < kRows; ++i) rows.push_back({fmt::format("f{}", i), square_at(i)});
    write_layer(driver, path(name), "parcels", 25832, rows);
    return path(name);
  }
};

std::vector<std::string> ids_in(const RawDataset& dataset) {
  std::vector<std::string> out;
  for (const RawLayer& layer : dataset.layers)
    for (const RawFeature& feature : layer.features) out.push_back(feature.id);
  return out;
}

std::vector<std::string> names(int first, int end) {
  std::vector<std::string> out;
  for (int i = first; i < end; ++i) out.push_back(fmt::format("f{}", i));
  return out;
}

TEST_F(Streams, GiveTheFeaturesOfTheFileInItsOrder) {
  for (const auto& [driver, name] : std::vector<std::pair<std::string, std::string>>{
           {"GPKG", "a.gpkg"}, {"GeoJSON", "a.geojson"}, {"ESRI Shapefile", "a.shp"}}) {
    SCOPED_TRACE(driver);
    const std::string file = written(driver, name);
    io::FeatureStream stream(query(file));
    ASSERT_EQ(stream.count(), kRows);
    const RawDataset whole = read_vector(query(file));
    std::vector<std::string> found;
    for (long long first = 0; first < stream.count(); first += 5) {
      const RawDataset part = stream.read(first, 5);
      ASSERT_EQ(part.layers.size(), 1u);
      EXPECT_EQ(part.layers[0].crs, whole.layers[0].crs);
      EXPECT_EQ(part.layers[0].name, whole.layers[0].name);
      EXPECT_EQ(part.layers[0].matching, first + 5 <= kRows ? 5 : kRows - first);
      for (const RawFeature& feature : part.layers[0].features) {
        const RawFeature& same = whole.layers[0].features.at(found.size());
        EXPECT_EQ(feature.fid, same.fid);
        double west = 1e9;  // rings begin anywhere, and run either way
        for (const Point& point : feature.polygons.at(0).rings.at(0).points) west = std::min(west, point.x);
        EXPECT_EQ(west, 100.0 * static_cast<double>(found.size()));
        found.push_back(feature.id);
      }
    }
    EXPECT_EQ(found, names(0, kRows));
  }
}

TEST_F(Streams, GoForwardsAndBackwards) {
  io::FeatureStream stream(query(written("GPKG", "a.gpkg")));
  EXPECT_EQ(ids_in(stream.read(10, 3)), names(10, 13));
  EXPECT_EQ(ids_in(stream.read(20, 2)), names(20, 22));
  EXPECT_EQ(ids_in(stream.read(4, 3)), names(4, 7));
  EXPECT_EQ(ids_in(stream.read(4, 3)), names(4, 7));
  EXPECT_EQ(ids_in(stream.read(0, 100)), names(0, kRows));
  EXPECT_TRUE(stream.read(kRows, 5).layers.empty());
  EXPECT_TRUE(stream.read(kRows + 9, 5).layers.empty());
  EXPECT_EQ(ids_in(stream.read(kRows - 1, 5)), names(kRows - 1, kRows));
}

TEST_F(Streams, CountAndGiveWhatTheFilterLeaves) {
  const std::string file = written("GPKG", "a.gpkg");
  io::FeatureStream stream(query(file, "parcels", "id IN ('f3', 'f8', 'f21')"));
  EXPECT_EQ(stream.count(), 3);
  EXPECT_EQ(ids_in(stream.read(1, 5)), (std::vector<std::string>{"f8", "f21"}));
  EXPECT_THROW(io::FeatureStream(query(file, "parcels", "id = 'none'")), Error);
  EXPECT_THROW(io::FeatureStream(query(file, "parcels", "nonsense =")), Error);
  EXPECT_THROW(io::FeatureStream(query(file, "fields")), Error);
  EXPECT_THROW(io::FeatureStream(query(path("none.gpkg"))), Error);
}

TEST_F(Streams, NameTheFilesThatHoldTheFeatures) {
  const std::string geopackage = written("GPKG", "a.gpkg");
  EXPECT_EQ(io::FeatureStream(query(geopackage)).files(), std::vector<std::string>{geopackage});

  const std::string shape = written("ESRI Shapefile", "b.shp");
  write("b.qix", "an index that a GIS has made");
  std::vector<std::string> expected;
  for (const char* ending : {"dbf", "prj", "shp", "shx"})
    expected.push_back(path(std::string("b.") + ending));
  std::vector<std::string> found = io::FeatureStream(query(shape)).files();
  std::erase(found, path("b.cpg"));  // not all versions of GDAL write it
  EXPECT_EQ(found, expected);

  std::filesystem::create_directory(path("folder"));
  const std::string in_folder = written("ESRI Shapefile", "folder/c.shp");
  found = io::FeatureStream(query(path("folder"))).files();
  EXPECT_NE(std::find(found.begin(), found.end(), in_folder), found.end());
  EXPECT_NE(std::find(found.begin(), found.end(), path("folder/c.dbf")), found.end());

  write_zip(path("d.zip"), {{"d.gpkg", bytes_of(geopackage)}});
  EXPECT_EQ(io::FeatureStream(query(path("d.zip"))).files(), std::vector<std::string>{path("d.zip")});
}

}  // namespace
}  // namespace tramline::testing_files
