#include "tramline/io/vector/foreign_files.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>
#include <gdal_priv.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/vsi_file.h"

namespace tramline::io {
namespace {

constexpr int kDeepest = 3;

enum class Packing { kNone, kZip, kGzip };

/// By its first bytes: names say what they like.
Packing packing_of(const std::string& name) {
  const VsiFile file = opened_to_read(name);
  std::array<unsigned char, 4> start{};
  if (!file || VSIFReadL(start.data(), 1, start.size(), file.get()) < start.size()) return Packing::kNone;
  if (start[0] == 'P' && start[1] == 'K' && (start[2] == 3 || start[2] == 5)) return Packing::kZip;
  return start[0] == 0x1f && start[1] == 0x8b ? Packing::kGzip : Packing::kNone;
}

class Unpacking {
 public:
  Unpacking(const std::filesystem::path& file, std::size_t most_bytes, int most_files)
      : file_(file.string()), most_bytes_(most_bytes), most_files_(most_files) {}

  void walk(const std::string& name, int depth) {
    const Packing packing = packing_of(name);
    if (packing == Packing::kNone) return;
    if (depth == kDeepest) throw refused("holds archives within archives within archives");
    if (packing == Packing::kGzip) return read("/vsigzip/" + name);
    const std::string root = "/vsizip/{" + name + "}";
    const CPLStringList entries(VSIReadDirRecursive(root.c_str()));
    if (entries.empty()) throw refused("cannot be read as a zip file");
    for (int i = 0; i < entries.size(); ++i) {
      if (++files_ > most_files_) throw refused(fmt::format("holds more than {} files", most_files_));
      const std::string entry = root + "/" + entries[i];
      if (entry.ends_with('/')) continue;
      read(entry);
      walk(entry, depth + 1);
    }
  }

 private:
  void read(const std::string& name) {
    const VsiFile file = opened_to_read(name);
    if (!file) throw refused("cannot be read as an archive");
    std::vector<char> buffer(std::size_t{1} << 16);
    for (std::size_t got = 0; (got = VSIFReadL(buffer.data(), 1, buffer.size(), file.get())) > 0;) {
      bytes_ += got;
      if (bytes_ > most_bytes_) throw refused(fmt::format("expands to more than {} MB", most_bytes_ >> 20));
    }
  }

  Error refused(const std::string& why) const {
    return bad_input(fmt::format("'{}' {}; send the one file that is meant, unpacked", file_, why));
  }

  std::string file_;
  std::size_t most_bytes_;
  int most_files_;
  std::size_t bytes_ = 0;
  int files_ = 0;
};

}  // namespace

void open_plain_files_only() {
  register_gdal_drivers();
  GDALDriverManager& manager = *GetGDALDriverManager();
  for (int i = manager.GetDriverCount() - 1; i >= 0; --i)
    if (GDALDriver* driver = manager.GetDriver(i); !reads_plain_files(driver->GetDescription())) {
      manager.DeregisterDriver(driver);
      GDALDestroyDriver(driver);  // the manager deletes at its end what is registered then
    }
}

void require_bounded_archive(const std::filesystem::path& file, std::size_t most_bytes, int most_files) {
  const GdalMessages silence;
  Unpacking(file, most_bytes, most_files).walk(file.string(), 0);
}

}  // namespace tramline::io
