#include "io/vector/files.h"

#include <cpl_conv.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <fstream>
#include <iterator>
#include <memory>

#include "tramline/geometry/error.h"

namespace tramline::testing_files {

void Files::SetUp() {
  std::string name = (std::filesystem::temp_directory_path() / "tramline-vector-XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = name;
}
void Files::TearDown() { std::filesystem::remove_all(folder_); }

std::string Files::write(const std::string& name, const std::string& bytes) const {
  std::ofstream(folder_ / name, std::ios::binary) << bytes;
  return path(name);
}

std::string Files::bytes_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

void write_layer(const std::string& driver, const std::string& path, const std::string& layer, int epsg,
                 const std::vector<Row>& rows, bool append) {
  GDALAllRegister();
  GDALDatasetUniquePtr dataset(append ? GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE)
                                      : GetGDALDriverManager()
                                            ->GetDriverByName(driver.c_str())
                                            ->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  ASSERT_TRUE(dataset) << driver;
  OGRSpatialReference srs;
  if (epsg > 0) {
    srs.importFromEPSG(epsg);
    srs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  }
  OGRGeometry* first = nullptr;
  OGRGeometryFactory::createFromWkt(rows.front().wkt.c_str(), nullptr, &first);
  const std::unique_ptr<OGRGeometry> owner(first);
  OGRLayer* out = dataset->CreateLayer(layer.c_str(), epsg > 0 ? &srs : nullptr, first->getGeometryType());
  ASSERT_NE(out, nullptr) << driver;
  OGRFieldDefn id("id", OFTString);
  out->CreateField(&id);
  for (const Row& row : rows) {
    const OGRFeatureUniquePtr feature(OGRFeature::CreateFeature(out->GetLayerDefn()));
    feature->SetField("id", row.id.c_str());
    OGRGeometry* shape = nullptr;
    OGRGeometryFactory::createFromWkt(row.wkt.c_str(), nullptr, &shape);
    feature->SetGeometryDirectly(shape);
    ASSERT_EQ(out->CreateFeature(feature.get()), OGRERR_NONE) << driver;
  }
}

void write_zip(const std::string& zip,
               const std::vector<std::pair<std::string, std::string>>& name_and_bytes) {
  void* archive = CPLCreateZip(zip.c_str(), nullptr);
  ASSERT_NE(archive, nullptr);
  for (const auto& [name, bytes] : name_and_bytes) {
    ASSERT_EQ(CPLCreateFileInZip(archive, name.c_str(), nullptr), CE_None);
    ASSERT_EQ(CPLWriteFileInZip(archive, bytes.data(), static_cast<int>(bytes.size())), CE_None);
    ASSERT_EQ(CPLCloseFileInZip(archive), CE_None);
  }
  ASSERT_EQ(CPLCloseZip(archive), CE_None);
}

VectorQuery query(const std::string& file, const std::string& layer, const std::string& where) {
  VectorQuery out;
  out.file = file;
  out.layer = layer;
  out.where = where;
  return out;
}

std::string refusal(const VectorQuery& query) {
  testing::internal::CaptureStderr();
  std::string sentence;
  try {
    read_vector(query);
    ADD_FAILURE() << query.file << " was read";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    sentence = error.what();
  }
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << "GDAL was not silent";
  EXPECT_EQ(sentence.find('\n'), std::string::npos) << sentence;
  return sentence;
}

}  // namespace tramline::testing_files
