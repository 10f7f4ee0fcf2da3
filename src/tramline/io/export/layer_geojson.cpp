#include "tramline/io/export/layer_geojson.h"

#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include <cmath>

#include "tramline/geometry/error.h"
#include "tramline/io/export/layer_copy.h"
#include "tramline/io/export/target_crs.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/memory_folder.h"
#include "tramline/io/geopackage/time_stamp.h"

namespace tramline::io {
namespace {

GDALDatasetUniquePtr opened(const std::filesystem::path& file) {
  start_gdal();
  RegisterOGRGeoPackage();
  RegisterOGRGeoJSON();
  const char* const drivers[] = {"GPKG", nullptr};
  GDALDatasetUniquePtr out(
      GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, nullptr, nullptr));
  if (out == nullptr) throw bad_input(fmt::format("{}: the file cannot be opened", file.string()));
  return out;
}

OGRLayer& layer_with_shapes(GDALDataset& file, const std::string& name) {
  OGRLayer* layer = file.GetLayerByName(name.c_str());
  if (layer == nullptr || layer->GetGeomType() == wkbNone)
    throw bad_input(fmt::format("there is no layer '{}' with shapes", name));
  return *layer;
}

/// Decimals of a degree: digits are most of what a layer weighs. Along lines machines are led, so that these
/// are true to a millimetre; land that is drawn coarsely moves by a tenth of the tolerance at most.
int decimals_of(OGRLayer& layer, double tolerance_m) {
  constexpr int kAll = 10, kMillimetre = 8, kLeast = 5;
  if (tolerance_m <= 0) return kAll;
  int out = kMillimetre;
  const OGRwkbGeometryType shapes = wkbFlatten(layer.GetGeomType());
  if (shapes != wkbPolygon && shapes != wkbMultiPolygon) return out;
  constexpr double kDegree_m = 111'320, kShare = 0.1;
  const auto moved_m = [](int decimals) { return std::sqrt(0.5) * kDegree_m * std::pow(10.0, -decimals); };
  while (out > kLeast && moved_m(out - 1) <= kShare * tolerance_m) --out;
  return out;
}

}  // namespace

LocalFrame shown_frame(const LocalFrame& frame) {
  if (frame.geodetic) return frame;
  LocalFrame out;
  out.geodetic = true;
  return out;
}

std::string layer_geojson(const std::filesystem::path& file, const LocalFrame& frame,
                          const std::string& layer, double tolerance_m) {
  GdalErrors errors;
  const GDALDatasetUniquePtr from = opened(file);
  OGRLayer& source = layer_with_shapes(*from, layer);
  Field place;
  place.frame = shown_frame(frame);
  const TargetCrs target(place, "wgs84", ExportFormat::kGeoJson);
  const MemoryFolder folder;
  const std::string name = "layer.geojson";
  {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(driver_of(ExportFormat::kGeoJson));
    if (driver == nullptr) throw failure("this GDAL cannot write GeoJSON");
    const GDALDatasetUniquePtr to(driver->Create(folder.file(name).c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    std::vector<Skipped> shortened;
    if (to != nullptr)
      copy_layer(source, *to,
                 {ExportFormat::kGeoJson,
                  target,
                  offset_of(frame),
                  time_of_files(),
                  tolerance_m,
                  {},
                  decimals_of(source, tolerance_m)},
                 shortened);
  }
  const std::span<const std::byte> bytes = folder.bytes(name);
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("layer '{}' cannot be shown: GDAL reports: {}", layer, errors.first()));
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace tramline::io
