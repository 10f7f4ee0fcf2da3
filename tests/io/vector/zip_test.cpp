// Zips, as registers hand them out.

#include "io/vector/files.h"

namespace tramline::testing_files {
namespace {

class Zip : public Files {
 protected:
  using Members = std::vector<std::pair<std::string, std::string>>;
  const std::string square_ = "POLYGON ((0 0, 100 0, 100 50, 0 0))";

  /// The files of a Shapefile `stem`, under `folder` in the zip.
  Members shapefile(const std::string& stem, const std::string& folder) const {
    write_layer("ESRI Shapefile", path(stem + ".shp"), stem, 25832, {{stem, square_}});
    Members out;
    for (const char* extension : {".shp", ".shx", ".dbf", ".prj"})
      out.emplace_back(folder + stem + extension, bytes_of(path(stem + extension)));
    return out;
  }
};

TEST_F(Zip, ShapefileAtTheTop) {
  write_zip(path("a.zip"), shapefile("marker", ""));
  EXPECT_EQ(read_vector(query(path("a.zip"))).layers[0].features[0].id, "marker");
}

TEST_F(Zip, ShapefileInNestedFolders) {
  Members members = shapefile("marker", "export/2026/");
  members.emplace_back("export/readme.txt", "hello");
  members.emplace_back("__MACOSX/export/2026/._marker.shp", "junk");
  write_zip(path("a.zip"), members);
  EXPECT_EQ(read_vector(query(path("a.zip"))).layers[0].features[0].id, "marker");
}

TEST_F(Zip, GeoPackageInAFolder) {
  write_layer("GPKG", path("a.gpkg"), "fields", 25832, {{"inside", square_}});
  write_zip(path("a.zip"), {{"data/a.gpkg", bytes_of(path("a.gpkg"))}});
  const RawDataset dataset = read_vector(query(path("a.zip")));
  EXPECT_EQ(dataset.driver, "GPKG");
  EXPECT_EQ(dataset.layers[0].features[0].id, "inside");
}

TEST_F(Zip, SeveralShapefilesOfAFolderAreLayersToChooseFrom) {
  Members members = shapefile("east", "d/");
  for (auto& member : shapefile("west", "d/")) members.push_back(member);
  write_zip(path("a.zip"), members);
  const std::string sentence = refusal(query(path("a.zip")));
  EXPECT_NE(sentence.find("east"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("--layer"), std::string::npos) << sentence;
  EXPECT_EQ(read_vector(query(path("a.zip"), "west")).layers[0].features[0].id, "west");
}

TEST_F(Zip, SeveralDatasetsAreChosenByLayerToo) {
  Members members = shapefile("east", "d/");
  write_layer("GPKG", path("a.gpkg"), "fields", 25832, {{"inside", square_}});
  members.emplace_back("other/a.gpkg", bytes_of(path("a.gpkg")));
  write_zip(path("a.zip"), members);
  const std::string sentence = refusal(query(path("a.zip")));
  EXPECT_NE(sentence.find("several vector files"), std::string::npos) << sentence;
  EXPECT_EQ(read_vector(query(path("a.zip"), "fields")).layers[0].features[0].id, "inside");
  EXPECT_NE(refusal(query(path("a.zip"), "none")).find("none with layer 'none'"), std::string::npos);
}

TEST_F(Zip, WithoutVectorFiles) {
  write_zip(path("a.zip"), {{"readme.txt", "hello"}});
  EXPECT_NE(refusal(query(path("a.zip"))).find("holds no vector file; found readme.txt"), std::string::npos);
}

TEST_F(Zip, CutOff) {
  write_zip(path("whole.zip"), shapefile("marker", ""));
  const std::string bytes = bytes_of(path("whole.zip"));
  const std::string sentence = refusal(query(write("a.zip", bytes.substr(0, bytes.size() / 2))));
  EXPECT_NE(sentence.find("cannot be read as a zip file"), std::string::npos) << sentence;
  EXPECT_NE(refusal(query(write("b.zip", ""))).find("b.zip"), std::string::npos);
}

}  // namespace
}  // namespace tramline::testing_files
