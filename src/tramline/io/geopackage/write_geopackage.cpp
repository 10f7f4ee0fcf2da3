#include "tramline/io/geopackage/write_geopackage.h"

#include <cpl_conv.h>
#include <cpl_port.h>
#include <fmt/format.h>

#include <memory>
#include <span>
#include <string>

#include "tramline/geometry/error.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/memory_folder.h"
#include "tramline/io/geopackage/time_stamp.h"
#include "tramline/io/geopackage/whole_file.h"

namespace tramline::io {
namespace {

GDALDriver& driver() {
  start_gdal();
  RegisterOGRGeoPackage();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (found == nullptr) throw failure("this GDAL has no GeoPackage driver; install one built with SQLite");
  return *found;
}

}  // namespace

void fill_geopackage(const std::string& name, const LocalFrame& frame,
                     const std::function<void(const Target&)>& fill) {
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", time_stamp().c_str(), false);
  // With several processors GDAL would index the first table in a thread, and put off writing the others.
  const CPLConfigOptionSetter in_order("OGR_GPKG_ALLOW_THREADED_RTREE", "NO", false);
  const GDALDatasetUniquePtr file(driver().Create(name.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (file == nullptr) return;
  OGRSpatialReference crs = crs_of(frame);
  const Point offset = offset_of(frame);
  file->StartTransaction();
  fill({*file, &crs, offset, Shapes(offset)});
  file->CommitTransaction();
}

void write_geopackage(const std::filesystem::path& path, const FileKind& kind, const LocalFrame& frame,
                      const std::function<void(const Target&)>& fill) {
  if (!EQUAL(path.extension().c_str(), ".gpkg"))
    throw bad_input(fmt::format("'{}' cannot hold a {}: {}s are GeoPackages; end the name in .gpkg",
                                path.string(), kind.what, kind.what));
  GdalErrors errors;
  // Half-written databases and journals never lie on the disk.
  const MemoryFolder memory;
  const std::string name = "whole.gpkg";
  fill_geopackage(memory.file(name), frame, fill);
  const std::span<const std::byte> bytes = memory.bytes(name);
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", path.string(), errors.first()));
  write_whole(path, bytes);
}

}  // namespace tramline::io
