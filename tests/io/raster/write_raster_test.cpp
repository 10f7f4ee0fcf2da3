// Maps as GeoTIFFs, read back by GDAL.

#include "tramline/io/raster/write_raster.h"

#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <array>
#include <fstream>
#include <iterator>
#include <memory>
#include <vector>

#include "support/refusals.h"
#include "support/temporary_folder.h"
#include "tramline/geodesy/field_projection.h"

namespace tramline::io {
namespace {

using testing_support::error_of;
using testing_support::mentions;
using testing_support::refusal_of;

/// 3 columns, 2 rows of 2 m; amounts 1 to 5 from the south-west, the last cell no ground and empty.
DoseMap small_map() {
  DoseMap map;
  map.unit = "kg";
  map.grid = {{-4, 6}, 2, 3, 2};
  map.amount = {1, 2, 3, 4, 5, 0};
  map.ground = {1, 1, 1, 1, 1, 0};
  map.frame.geodetic = true;
  map.frame.origin_lon_deg = 9.25;
  map.frame.origin_lat_deg = 52.5;
  return map;
}

struct ReadBack {
  std::array<double, 6> transform{};
  std::vector<double> values;  ///< from the north-west
  double no_data = 0;
  std::string unit;
  int columns = 0, rows = 0;
  std::unique_ptr<OGRSpatialReference> crs;
};

ReadBack read_back(const std::filesystem::path& path) {
  GDALAllRegister();
  ReadBack out;
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (!file) return out;
  file->GetGeoTransform(out.transform.data());
  out.columns = file->GetRasterXSize();
  out.rows = file->GetRasterYSize();
  out.values.resize(static_cast<std::size_t>(out.columns * out.rows));
  GDALRasterBand& band = *file->GetRasterBand(1);
  EXPECT_EQ(band.RasterIO(GF_Read, 0, 0, out.columns, out.rows, out.values.data(), out.columns, out.rows,
                          GDT_Float64, 0, 0, nullptr),
            CE_None);
  out.no_data = band.GetNoDataValue();
  out.unit = band.GetUnitType();
  if (file->GetSpatialRef() != nullptr) out.crs.reset(file->GetSpatialRef()->Clone());
  return out;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(WriteRaster, ComesBackWithItsPlaceAndItsSum) {
  const testing_support::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "dose.tif";
  write_raster(small_map(), path);
  const ReadBack back = read_back(path);
  ASSERT_EQ(back.columns, 3);
  ASSERT_EQ(back.rows, 2);
  EXPECT_EQ(back.transform, (std::array<double, 6>{-4, 2, 0, 10, 0, -2}));
  // 4 m² a cell: 1 kg is 2500 kg/ha.
  EXPECT_EQ(back.values, (std::vector<double>{10000, 12500, -9999, 2500, 5000, 7500}));
  EXPECT_EQ(back.no_data, -9999);
  EXPECT_EQ(back.unit, "kg/ha");
  double sum = 0;
  for (const double value : back.values)
    if (value != back.no_data) sum += value * 4 / 1e4;
  EXPECT_NEAR(sum, 15, 15e-6);
  // The middle of the frame, and a corner by the project's own projection.
  ASSERT_TRUE(back.crs);
  OGRSpatialReference wgs84;
  wgs84.SetWellKnownGeogCS("WGS84");
  wgs84.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  back.crs->SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> to_lonlat(
      OGRCreateCoordinateTransformation(back.crs.get(), &wgs84));
  ASSERT_TRUE(to_lonlat);
  double x = -4, y = 10;
  ASSERT_TRUE(to_lonlat->Transform(1, &x, &y));
  const Point corner = FrameProjection(small_map().frame).to_lonlat({-4, 10});
  EXPECT_NEAR(x, corner.x, 1e-9);
  EXPECT_NEAR(y, corner.y, 1e-9);
  EXPECT_NEAR(x, 9.25, 1e-3);
  EXPECT_NEAR(y, 52.5, 1e-3);
}

TEST(WriteRaster, PlainMetresKeepTheInputsPlane) {
  const testing_support::TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "dose.TIFF";
  DoseMap map = small_map();
  map.frame = LocalFrame{};
  map.frame.origin_x_m = 1000;
  map.frame.origin_y_m = -500;
  write_raster(map, path);
  EXPECT_EQ(read_back(path).transform, (std::array<double, 6>{996, 2, 0, -490, 0, -2}));
}

TEST(WriteRaster, EqualMapsAreEqualFiles) {
  const testing_support::TemporaryFolder folder;
  write_raster(small_map(), folder.path() / "a.tif");
  write_raster(small_map(), folder.path() / "b.tif");
  EXPECT_EQ(bytes_of(folder.path() / "a.tif"), bytes_of(folder.path() / "b.tif"));
}

TEST(WriteRaster, RefusesOtherNamesAndFoldersThatAreNotThere) {
  EXPECT_TRUE(mentions(refusal_of([] { write_raster(small_map(), "dose.png"); }), ".tif"));
  const Error error = error_of([] { write_raster(small_map(), "no-such-folder/dose.tif"); });
  EXPECT_EQ(error.kind(), ErrorKind::kFailure);
}

}  // namespace
}  // namespace tramline::io
