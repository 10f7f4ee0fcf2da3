#include "tramline/io/geopackage/write_geopackage.h"

#include <cpl_conv.h>
#include <cpl_port.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <memory>
#include <span>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/local_crs.h"
#include "tramline/io/geopackage/time_stamp.h"
#include "tramline/io/geopackage/whole_file.h"

namespace tramline::io {
namespace {

/// A file in GDAL's memory, gone at the end of the scope. Building the GeoPackage there keeps
/// half-written databases and journals off the disk, whatever happens.
class MemoryFile {
 public:
  MemoryFile() {
    static std::atomic<unsigned> count{0};
    name_ = fmt::format("/vsimem/tramline_{}_{}.gpkg", getpid(), count++);
  }
  MemoryFile(const MemoryFile&) = delete;
  MemoryFile& operator=(const MemoryFile&) = delete;
  ~MemoryFile() { VSIUnlink(name_.c_str()); }
  const char* name() const { return name_.c_str(); }
  std::span<const std::byte> bytes() const {
    vsi_l_offset size = 0;
    const GByte* data = VSIGetMemFileBuffer(name_.c_str(), &size, FALSE);
    return std::as_bytes(std::span(data, static_cast<std::size_t>(size)));
  }

 private:
  std::string name_;
};

GDALDriver& driver() {
  RegisterOGRGeoPackage();
  GDALDriver* found = GetGDALDriverManager()->GetDriverByName("GPKG");
  if (found == nullptr) throw failure("this GDAL has no GeoPackage driver; install one built with SQLite");
  return *found;
}

}  // namespace

void write_geopackage(const std::filesystem::path& path, const FileKind& kind, const LocalFrame& frame,
                      const std::function<void(const Target&)>& fill) {
  if (!EQUAL(path.extension().c_str(), ".gpkg"))
    throw bad_input(fmt::format("'{}' cannot hold a {}: {}s are GeoPackages; end the name in .gpkg",
                                path.string(), kind.what, kind.what));
  const CPLConfigOptionSetter date("OGR_CURRENT_DATE", time_stamp().c_str(), false);
  GdalErrors errors;
  MemoryFile memory;
  {
    const GDALDatasetUniquePtr file(driver().Create(memory.name(), 0, 0, 0, GDT_Unknown, nullptr));
    if (file != nullptr) {
      OGRSpatialReference crs = crs_of(frame);
      const Point offset = offset_of(frame);
      file->StartTransaction();
      fill({*file, &crs, offset, Shapes(offset)});
      file->CommitTransaction();
    }
  }
  const std::span<const std::byte> bytes = memory.bytes();
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", path.string(), errors.first()));
  write_whole(path, bytes);
}

}  // namespace tramline::io
