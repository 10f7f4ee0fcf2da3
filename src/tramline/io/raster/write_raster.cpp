#include "tramline/io/raster/write_raster.h"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_priv.h>

#include <array>
#include <span>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/memory_folder.h"
#include "tramline/io/geopackage/whole_file.h"

namespace tramline::io {
namespace {

GDALDriver& driver() {
  start_gdal();
  GDALRegister_GTiff();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName("GTiff");
  if (found == nullptr) throw failure("this GDAL has no GeoTIFF driver");
  return *found;
}

float value_of(const DoseMap& map, std::size_t cell) {
  const bool nothing = map.amount[cell] == 0 && !(map.ground[cell] > 0);
  return nothing ? kNoDose : static_cast<float>(rate_per_ha(map, cell));
}

void place(GDALDataset& file, const DoseMap& map) {
  const Point offset = offset_of(map.frame);
  const Box box = map.grid.box();
  std::array<double, 6> transform{box.min_x + offset.x, map.grid.cell_m, 0, box.max_y + offset.y, 0,
                                  -map.grid.cell_m};
  file.SetGeoTransform(transform.data());
  const OGRSpatialReference crs = crs_of(map.frame);
  file.SetSpatialRef(&crs);
}

/// Rows from the north, as rasters have them.
void fill(GDALRasterBand& band, const DoseMap& map) {
  const std::string unit = map.unit + "/ha";
  band.SetNoDataValue(kNoDose);
  band.SetDescription("applied amount");
  band.SetUnitType(unit.c_str());
  std::vector<float> line(static_cast<std::size_t>(map.grid.columns));
  for (int row = 0; row < map.grid.rows; ++row) {
    for (int column = 0; column < map.grid.columns; ++column)
      line[static_cast<std::size_t>(column)] = value_of(map, map.grid.index(column, map.grid.rows - 1 - row));
    if (band.RasterIO(GF_Write, 0, row, map.grid.columns, 1, line.data(), map.grid.columns, 1, GDT_Float32, 0,
                      0, nullptr) != CE_None)
      return;
  }
}

}  // namespace

void write_raster(const DoseMap& map, const std::filesystem::path& path) {
  if (!EQUAL(path.extension().c_str(), ".tif") && !EQUAL(path.extension().c_str(), ".tiff"))
    throw bad_input(
        fmt::format("'{}' cannot hold a map: maps are GeoTIFFs; end the name in .tif", path.string()));
  GdalErrors errors;
  const MemoryFolder memory;
  const std::string name = "whole.tif";
  {
    CPLStringList options;
    options.SetNameValue("COMPRESS", "DEFLATE");
    options.SetNameValue("PREDICTOR", "3");
    options.SetNameValue("TILED", "YES");
    const GDALDatasetUniquePtr file(driver().Create(memory.file(name).c_str(), map.grid.columns,
                                                    map.grid.rows, 1, GDT_Float32, options.List()));
    if (file != nullptr) {
      place(*file, map);
      fill(*file->GetRasterBand(1), map);
    }
  }
  const std::span<const std::byte> bytes = memory.bytes(name);
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", path.string(), errors.first()));
  write_whole(path, bytes);
}

}  // namespace tramline::io
