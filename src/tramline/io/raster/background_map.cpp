#include "tramline/io/raster/background_map.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_alg.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <ogr_spatialref.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <mutex>
#include <numbers>
#include <span>

#include "tramline/geometry/error.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/memory_folder.h"

namespace tramline::io {
namespace {

constexpr int kTile_px = 256;
constexpr int kDeepest = 24;
/// Half the width of the Web Mercator square.
constexpr double kHalf_m = 20037508.342789244;
/// Of a file without overviews: a tile is put together from 2^5 × 256 pixels squared at most.
constexpr int kLevelsWithoutOverviews = 5;

/// How many levels below the last one overviews reach.
int levels_of_overviews(GDALRasterBand& band) {
  const int count = band.GetOverviewCount();
  if (count == 0) return 0;
  const double coarsest = std::max(1, band.GetOverview(count - 1)->GetXSize());
  return static_cast<int>(std::floor(std::log2(std::max(1.0, band.GetXSize() / coarsest))));
}

double pixel_m(int zoom) { return 2 * kHalf_m / kTile_px / std::exp2(zoom); }

Point lonlat_of(Point mercator_m) {
  const double radius_m = kHalf_m / std::numbers::pi;
  constexpr double kDegrees = 180 / std::numbers::pi;
  return {mercator_m.x / radius_m * kDegrees,
          (2 * std::atan(std::exp(mercator_m.y / radius_m)) - std::numbers::pi / 2) * kDegrees};
}

void register_rasters() {
  start_gdal();
  GDALRegister_GTiff();
  GDALRegister_PNG();
  GDALRegister_JPEG();
  GDALRegister_WEBP();
  GDALRegister_MEM();
  RegisterOGRGeoPackage();
  GDALRegister_MBTiles();
}

GDALDatasetUniquePtr opened(const std::filesystem::path& file) {
  register_rasters();
  const char* const drivers[] = {"GTiff", "MBTiles", "GPKG", nullptr};
  return GDALDatasetUniquePtr(
      GDALDataset::Open(file.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers, nullptr, nullptr));
}

GDALDatasetUniquePtr in_memory(int bands) {
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  if (driver == nullptr) throw failure("this GDAL cannot draw in memory");
  return GDALDatasetUniquePtr(driver->Create("", kTile_px, kTile_px, bands, GDT_Byte, nullptr));
}

bool is_alpha(GDALRasterBand& band) { return band.GetColorInterpretation() == GCI_AlphaBand; }

struct Extent {
  Box mercator_m;
  double pixel_m = 0;
};

/// Where the picture lies in Web Mercator, and how large its pixels are there.
Extent extent_of(GDALDataset& file) {
  CPLStringList options;
  options.SetNameValue("DST_SRS", "EPSG:3857");
  void* transformer = GDALCreateGenImgProjTransformer2(&file, nullptr, options.List());
  if (transformer == nullptr) return {};
  std::array<double, 6> place{};
  std::array<double, 4> box{};
  int columns = 0, rows = 0;
  const CPLErr result = GDALSuggestedWarpOutput2(&file, GDALGenImgProjTransform, transformer, place.data(),
                                                 &columns, &rows, box.data(), 0);
  GDALDestroyGenImgProjTransformer(transformer);
  if (result != CE_None || columns <= 0) return {};
  Extent out;
  out.mercator_m.extend(Point{std::max(box[0], -kHalf_m), std::max(box[1], -kHalf_m)});
  out.mercator_m.extend(Point{std::min(box[2], kHalf_m), std::min(box[3], kHalf_m)});
  out.pixel_m = place[1];
  return out;
}

using Pixels = std::vector<std::uint8_t>;

Pixels pixels_of(GDALRasterBand& band) {
  Pixels out(std::size_t{kTile_px} * kTile_px);
  if (band.RasterIO(GF_Read, 0, 0, kTile_px, kTile_px, out.data(), kTile_px, kTile_px, GDT_Byte, 0, 0,
                    nullptr) != CE_None)
    out.clear();
  return out;
}

void write(GDALRasterBand& band, Pixels& pixels) {
  if (band.RasterIO(GF_Write, 0, 0, kTile_px, kTile_px, pixels.data(), kTile_px, kTile_px, GDT_Byte, 0, 0,
                    nullptr) != CE_None)
    throw failure("a tile of the background cannot be drawn");
}

}  // namespace

struct BackgroundMap::Source {
  std::mutex mutex;
  GDALDatasetUniquePtr file;
  int bands = 0;  ///< without that of transparency
  bool indexed = false;

  std::array<Pixels, 4> drawn(const Box& mercator_m) const;
  void colour(std::array<Pixels, 4>& rgba) const;
};

/// Red, green, blue and how opaque each pixel is.
std::array<Pixels, 4> BackgroundMap::Source::drawn(const Box& mercator_m) const {
  const GDALDatasetUniquePtr canvas = in_memory(bands + 1);
  canvas->GetRasterBand(bands + 1)->SetColorInterpretation(GCI_AlphaBand);
  std::array<double, 6> place{mercator_m.min_x,
                              mercator_m.width() / kTile_px,
                              0,
                              mercator_m.max_y,
                              0,
                              -mercator_m.height() / kTile_px};
  canvas->SetGeoTransform(place.data());
  OGRSpatialReference mercator;
  mercator.importFromEPSG(3857);
  canvas->SetSpatialRef(&mercator);
  CPLStringList words;
  // The numbers of colours in a palette cannot be averaged.
  for (const char* word : {"-dstalpha", "-r", indexed ? "near" : "bilinear"}) words.AddString(word);
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> options(
      GDALWarpAppOptionsNew(words.List(), nullptr), GDALWarpAppOptionsFree);
  GDALDatasetH from = file.get();
  int wrong = 0;
  if (GDALWarp(nullptr, canvas.get(), 1, &from, options.get(), &wrong) == nullptr)
    throw failure("a tile of the background cannot be drawn");
  const auto band = [&](int number) { return pixels_of(*canvas->GetRasterBand(number)); };
  constexpr int kRgb = 3;
  std::array<Pixels, 4> out{band(1), {}, {}, band(bands + 1)};
  if (bands >= kRgb)
    out[1] = band(2), out[2] = band(kRgb);
  else
    out[1] = out[2] = out[0];
  if (indexed) colour(out);
  return out;
}

/// The colours that a palette has for the numbers.
void BackgroundMap::Source::colour(std::array<Pixels, 4>& rgba) const {
  const GDALColorTable* table = file->GetRasterBand(1)->GetColorTable();
  for (std::size_t i = 0; i < rgba[0].size(); ++i) {
    const GDALColorEntry* entry = table->GetColorEntry(rgba[0][i]);
    if (entry == nullptr) continue;
    rgba[0][i] = static_cast<std::uint8_t>(entry->c1);
    rgba[1][i] = static_cast<std::uint8_t>(entry->c2);
    rgba[2][i] = static_cast<std::uint8_t>(entry->c3);
    rgba[3][i] = std::min(rgba[3][i], static_cast<std::uint8_t>(entry->c4));
  }
}

BackgroundMap::BackgroundMap(const std::filesystem::path& file)
    : source_(std::make_unique<Source>()), name_(file.filename().string()) {
  const GdalErrors errors;
  source_->file = opened(file);
  if (source_->file == nullptr || source_->file->GetRasterCount() == 0)
    throw bad_input(
        fmt::format("the background '{}' cannot be opened: give an MBTiles file with pictures, a GeoTIFF, or "
                    "a GeoPackage "
                    "with one raster",
                    file.string()));
  GDALDataset& raster = *source_->file;
  for (int i = 1; i <= raster.GetRasterCount(); ++i) {
    GDALRasterBand& band = *raster.GetRasterBand(i);
    if (band.GetRasterDataType() != GDT_Byte)
      throw bad_input(
          fmt::format("the background '{}' holds numbers of type {}, and only pictures of bytes are shown: "
                      "convert it with gdal_translate -ot Byte -scale",
                      file.string(), GDALGetDataTypeName(band.GetRasterDataType())));
    if (!is_alpha(band)) ++source_->bands;
  }
  if (source_->bands == 0)
    throw bad_input(fmt::format("the background '{}' has no band of colours", file.string()));
  source_->indexed = source_->bands == 1 && raster.GetRasterBand(1)->GetColorTable() != nullptr;
  const Extent extent = extent_of(raster);
  if (!(extent.pixel_m > 0) || extent.mercator_m.empty())
    throw bad_input(fmt::format(
        "the background '{}' does not say where it lies: give it a coordinate system with gdal_edit.py or "
        "gdal_translate -a_srs",
        file.string()));
  const Point low = lonlat_of({extent.mercator_m.min_x, extent.mercator_m.min_y}),
              high = lonlat_of({extent.mercator_m.max_x, extent.mercator_m.max_y});
  lonlat_deg_.extend(low);
  lonlat_deg_.extend(high);
  constexpr double kAlmost = 0.05;  // tiles of whole levels differ from these by rounding
  last_zoom_ =
      std::clamp(static_cast<int>(std::ceil(std::log2(pixel_m(0) / extent.pixel_m) - kAlmost)), 0, kDeepest);
  first_zoom_ =
      std::max(0, last_zoom_ - levels_of_overviews(*raster.GetRasterBand(1)) - kLevelsWithoutOverviews);
}

BackgroundMap::~BackgroundMap() = default;

MapTile BackgroundMap::tile(int zoom, int x, int y) {
  assert(zoom >= 0 && zoom <= kDeepest && x >= 0 && y >= 0 && x < (1 << zoom) && y < (1 << zoom));
  const std::lock_guard lock(source_->mutex);
  GdalErrors errors;
  const double side_m = 2 * kHalf_m / std::exp2(zoom);
  Box box;
  box.extend(Point{-kHalf_m + x * side_m, kHalf_m - (y + 1) * side_m});
  box.extend(Point{-kHalf_m + (x + 1) * side_m, kHalf_m - y * side_m});
  std::array<Pixels, 4> rgba = source_->drawn(box);
  const auto solid = [](std::uint8_t one) { return one == std::numeric_limits<std::uint8_t>::max(); };
  const bool opaque = std::all_of(rgba[3].begin(), rgba[3].end(), solid);
  const int bands = opaque ? 3 : 4;
  const GDALDatasetUniquePtr picture = in_memory(bands);
  for (int i = 0; i < bands; ++i) write(*picture->GetRasterBand(i + 1), rgba[static_cast<std::size_t>(i)]);
  if (!opaque) picture->GetRasterBand(4)->SetColorInterpretation(GCI_AlphaBand);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(opaque ? "JPEG" : "PNG");
  if (driver == nullptr) throw failure("this GDAL cannot write PNG or JPEG");
  const MemoryFolder folder;
  const std::string name = opaque ? "tile.jpg" : "tile.png";
  GDALDatasetUniquePtr(
      driver->CreateCopy(folder.file(name).c_str(), picture.get(), 0, nullptr, nullptr, nullptr))
      .reset();
  const std::span<const std::byte> bytes = folder.bytes(name);
  if (bytes.empty())
    throw failure(
        fmt::format("a tile of the background cannot be written: GDAL reports: {}", errors.first()));
  return {{reinterpret_cast<const char*>(bytes.data()), bytes.size()}, opaque ? "image/jpeg" : "image/png"};
}

}  // namespace tramline::io
