#include "tramline/io/export/file_set.h"

#include <cpl_vsi.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <span>
#include <system_error>

#include "tramline/geometry/error.h"
#include "tramline/io/export/zip_folder.h"
#include "tramline/io/gdal/start_gdal.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/geopackage/memory_folder.h"
#include "tramline/io/geopackage/time_stamp.h"
#include "tramline/io/geopackage/whole_file.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

void put_into(const MemoryFolder& folder, const NamedFile& file) {
  VSILFILE* out = VSIFOpenL(folder.file(file.name).c_str(), "wb");
  const bool written =
      out != nullptr && VSIFWriteL(file.content.data(), 1, file.content.size(), out) == file.content.size();
  if (out != nullptr) VSIFCloseL(out);
  if (!written) throw failure(fmt::format("{} does not fit into memory", file.name));
}

[[noreturn]] void refuse_folder(const fs::path& folder, const std::error_code& cause) {
  throw failure(fmt::format("cannot write {}: {}; choose a folder that exists, is writable and has room",
                            folder.string(), cause.message()));
}

/// The same error about the place that the user knows.
Error with_place(const Error& error, const std::string& place, const std::string& known) {
  std::string sentence = error.what();
  if (const std::size_t at = sentence.find(place); at != std::string::npos)
    sentence.replace(at, place.size(), known);
  return Error(error.kind(), sentence);
}

/// A folder that disappears, with all that is in it, unless it gets its name.
class UnfinishedFolder {
 public:
  explicit UnfinishedFolder(const fs::path& target) : target_(target) {
    static std::atomic<unsigned> count{0};
    path_ =
        target.parent_path() / fmt::format(".{}.{}-{}.part", target.filename().string(), getpid(), count++);
    std::error_code cause;
    if (!fs::create_directory(path_, cause) || cause) refuse_folder(target_, cause);
  }
  UnfinishedFolder(const UnfinishedFolder&) = delete;
  UnfinishedFolder& operator=(const UnfinishedFolder&) = delete;
  ~UnfinishedFolder() {
    std::error_code ignored;
    if (!kept_) fs::remove_all(path_, ignored);
  }

  void add(const NamedFile& file) const {
    const fs::path path = path_ / file.name;
    std::error_code cause;
    fs::create_directories(path.parent_path(), cause);
    if (cause) refuse_folder(target_, cause);
    try {
      write_whole(path, std::as_bytes(std::span(file.content.data(), file.content.size())));
    } catch (const Error& error) {
      throw with_place(error, path.string(), (target_ / file.name).string());
    }
  }

  /// An empty folder of that name is replaced.
  void keep() {
    std::error_code cause;
    fs::rename(path_, target_, cause);
    if (cause) refuse_folder(target_, cause);
    kept_ = true;
  }

 private:
  fs::path target_;
  fs::path path_;
  bool kept_ = false;
};

/// "out/" and "out" are the same folder.
fs::path without_last_slash(const fs::path& folder) {
  const fs::path whole = folder.lexically_normal();
  return whole.has_filename() ? whole : whole.parent_path();
}

}  // namespace

void write_zip(const std::vector<NamedFile>& files, const fs::path& zip) {
  start_gdal();
  const GdalErrors errors;
  const MemoryFolder folder;
  const std::string result = "files.zip";
  std::vector<std::string> names;
  for (const NamedFile& file : files) {
    put_into(folder, file);
    names.push_back(file.name);
  }
  zip_files(folder, names, result, time_of_files());
  const std::span<const std::byte> bytes = folder.bytes(result);
  if (errors.any() || bytes.empty())
    throw failure(fmt::format("cannot write {}: GDAL reports: {}", zip.string(), errors.first()));
  write_whole(zip, bytes);
}

void require_free(const fs::path& folder) {
  const fs::path path = without_last_slash(folder);
  std::error_code ignored;
  const fs::file_status there = fs::symlink_status(path, ignored);
  const fs::path above = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(above, ignored))
    throw bad_input(
        fmt::format("'{}' cannot be written: there is no folder '{}'", path.string(), above.string()));
  if (!fs::exists(there)) return;
  if (!fs::is_directory(path, ignored))
    throw bad_input(fmt::format("'{}' is a file, so there can be no folder of that name; choose another name",
                                path.string()));
  if (!fs::is_empty(path, ignored))
    throw bad_input(fmt::format(
        "there is a folder '{}' already, which is not overwritten; move it away or choose another name",
        path.string()));
}

void write_folder(const std::vector<NamedFile>& files, const fs::path& folder) {
  require_free(folder);
  UnfinishedFolder unfinished(without_last_slash(folder));
  for (const NamedFile& file : files) unfinished.add(file);
  unfinished.keep();
}

}  // namespace tramline::io
