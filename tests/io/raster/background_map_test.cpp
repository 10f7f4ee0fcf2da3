// Tiles of a picture on the disk, looked at pixel by pixel.

#include "tramline/io/raster/background_map.h"

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <gtest/gtest.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include "support/refusals.h"
#include "support/temporary_folder.h"

namespace tramline::io {
namespace {

using testing_support::refusal_of;

/// The middle quarter of the world in Web Mercator: x and y from -10018754 to 10018754 m, red in the west and
/// blue in the east, 64 × 64 pixels of 313,086 m.
constexpr double kQuarter_m = 20037508.342789244 / 2;

struct Picture {
  double half_m = kQuarter_m;
  int overview = 0;  ///< so many times coarser, if there is one
  GDALDataType type = GDT_Byte;
  int bands = 3;
  bool placed = true;
  bool indexed = false;
};

std::filesystem::path picture(const testing_support::TemporaryFolder& folder, const Picture& wanted = {}) {
  GDALAllRegister();
  const std::filesystem::path path = folder.path() / "land.tif";
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const GDALDatasetUniquePtr file(driver->Create(path.c_str(), 64, 64, wanted.bands, wanted.type, nullptr));
  if (wanted.placed) {
    std::array<double, 6> place{-wanted.half_m, wanted.half_m / 32, 0, wanted.half_m, 0, -wanted.half_m / 32};
    file->SetGeoTransform(place.data());
    OGRSpatialReference crs;
    crs.importFromEPSG(3857);
    file->SetSpatialRef(&crs);
  }
  if (wanted.indexed) {
    GDALColorTable table;
    const GDALColorEntry red{255, 0, 0, 255}, blue{0, 0, 255, 255};
    table.SetColorEntry(1, &red);
    table.SetColorEntry(2, &blue);
    file->GetRasterBand(1)->SetColorTable(&table);
  }
  for (int band = 1; band <= wanted.bands; ++band) {
    std::vector<int> pixels(std::size_t{64} * 64);
    for (std::size_t i = 0; i < pixels.size(); ++i) {
      const bool west = i % 64 < 32;
      pixels[i] = wanted.indexed ? (west ? 1 : 2) : band == (west ? 1 : 3) ? 255 : 0;
    }
    EXPECT_EQ(file->GetRasterBand(band)->RasterIO(GF_Write, 0, 0, 64, 64, pixels.data(), 64, 64, GDT_Int32, 0,
                                                  0, nullptr),
              CE_None);
  }
  if (wanted.overview > 0) {
    EXPECT_EQ(file->BuildOverviews("NEAREST", 1, &wanted.overview, 0, nullptr, nullptr, nullptr), CE_None);
  }
  return path;
}

/// Red, green, blue and opacity of a pixel of a tile; opaque where the tile does not say.
std::array<int, 4> colour(const MapTile& tile, int x, int y) {
  GDALAllRegister();
  const std::string name = "/vsimem/tile_of_test";
  std::string bytes = tile.bytes;
  VSIFCloseL(VSIFileFromMemBuffer(name.c_str(), reinterpret_cast<GByte*>(bytes.data()), bytes.size(), FALSE));
  std::array<int, 4> out{0, 0, 0, 255};
  {
    const GDALDatasetUniquePtr file(GDALDataset::Open(name.c_str(), GDAL_OF_RASTER));
    EXPECT_NE(file, nullptr);
    if (file == nullptr) return out;
    EXPECT_EQ(file->GetRasterXSize(), 256);
    EXPECT_EQ(file->GetRasterYSize(), 256);
    for (int band = 1; band <= std::min(4, file->GetRasterCount()); ++band)
      EXPECT_EQ(
          file->GetRasterBand(band)->RasterIO(GF_Read, x, y, 1, 1, &out[static_cast<std::size_t>(band - 1)],
                                              1, 1, GDT_Int32, 0, 0, nullptr),
          CE_None);
  }
  VSIUnlink(name.c_str());
  return out;
}

TEST(BackgroundMap, LiesWhereItsFileSays) {
  const testing_support::TemporaryFolder folder;
  const BackgroundMap map(picture(folder));
  // A quarter of the square about (0°, 0°): 90° to both sides, and 2·atan(e^(π/2)) − 90° = 66.51° up.
  EXPECT_NEAR(map.lonlat_deg().min_x, -90, 0.5);
  EXPECT_NEAR(map.lonlat_deg().max_x, 90, 0.5);
  EXPECT_NEAR(map.lonlat_deg().max_y, 66.51, 0.5);
  EXPECT_NEAR(map.lonlat_deg().min_y, -66.51, 0.5);
  EXPECT_EQ(map.name(), "land.tif");
  EXPECT_EQ(map.first_zoom(), 0);
  EXPECT_EQ(map.last_zoom(), 0) << "a pixel of level 0 is 156,543 m wide, one of the file twice as wide";
}

// Pixels of a metre: those of level 17 are 1.19 m wide, of level 18 0.6 m.
TEST(BackgroundMap, IsDrawnFromAsFarAsItsOverviewsReach) {
  const testing_support::TemporaryFolder folder;
  EXPECT_EQ(BackgroundMap(picture(folder, {.half_m = 32})).last_zoom(), 18);
  EXPECT_EQ(BackgroundMap(picture(folder, {.half_m = 32})).first_zoom(), 13) << "five levels from nothing";
  EXPECT_EQ(BackgroundMap(picture(folder, {.half_m = 32, .overview = 8})).first_zoom(), 10)
      << "three more from an overview eight times as coarse";
}

TEST(BackgroundMap, DrawsTheTileThatIsAskedFor) {
  const testing_support::TemporaryFolder folder;
  for (const bool indexed : {false, true}) {
    BackgroundMap map(picture(folder, {.bands = indexed ? 1 : 3, .indexed = indexed}));
    const MapTile world = map.tile(0, 0, 0);
    EXPECT_STREQ(world.type, "image/png");
    EXPECT_EQ(colour(world, 100, 128), (std::array<int, 4>{255, 0, 0, 255})) << indexed;
    EXPECT_EQ(colour(world, 156, 128), (std::array<int, 4>{0, 0, 255, 255})) << indexed;
    EXPECT_EQ(colour(world, 10, 128)[3], 0) << "beside the picture there is nothing";
    EXPECT_EQ(colour(world, 128, 10)[3], 0);
    // The tile of the north-west: the picture is its south-east quarter, all of it red.
    const MapTile north_west = map.tile(1, 0, 0);
    EXPECT_EQ(colour(north_west, 200, 200), (std::array<int, 4>{255, 0, 0, 255})) << indexed;
    EXPECT_EQ(colour(north_west, 60, 200)[3], 0);
    // Within the picture a tile has no transparent part.
    const MapTile inner = map.tile(3, 3, 3);
    EXPECT_STREQ(inner.type, "image/jpeg");
    EXPECT_NEAR(colour(inner, 128, 128)[0], 255, 4);
    EXPECT_NEAR(colour(inner, 128, 128)[2], 0, 4);
  }
}

TEST(BackgroundMap, SaysWhatIsWrongWithAFile) {
  const testing_support::TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& path) {
    return refusal_of([&] { const BackgroundMap map(path); });
  };
  {
    const std::string said = refusal(folder.path() / "none.tif");
    for (const char* part : {"none.tif", "cannot be opened", "MBTiles"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  {
    const std::string said = refusal(picture(folder, {.type = GDT_UInt16}));
    for (const char* part : {"land.tif", "UInt16", "gdal_translate"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
  {
    const std::string said = refusal(picture(folder, {.placed = false}));
    for (const char* part : {"land.tif", "where it lies"})
      EXPECT_NE(said.find(part), std::string::npos) << said;
  }
}

}  // namespace
}  // namespace tramline::io
