#include "server/uploads/uploads.h"

#include <fmt/format.h>

#include <array>
#include <cassert>
#include <string_view>
#include <system_error>

#include "server/http/http_error.h"
#include "server/store/new_id.h"
#include "tramline/geometry/error.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::server {
namespace {

namespace fs = std::filesystem;

constexpr const char* kFolder = ".uploads";

/// Readers look at extensions, so those of files that are read are kept. Longer ones first.
constexpr std::array<std::string_view, 27> kExtensions = {
    ".csv.gz", ".txt.gz", ".log.gz", ".nmea.gz", ".geojsonl", ".geojson", ".gpkg", ".json", ".nmea",
    ".sqlite", ".shp",    ".zip",    ".fgb",     ".kml",      ".kmz",     ".gml",  ".gpx",  ".csv",
    ".txt",    ".log",    ".tsv",    ".xml",     ".bin",      ".dxf",     ".mif",  ".shz",  ".toml"};

std::string_view extension_of(const std::string& lower_name) {
  for (const std::string_view extension : kExtensions)
    if (lower_name.ends_with(extension)) return extension;
  return "";
}

/// Precondition: `from` is not empty.
void replace_all(std::string& text, const std::string& from, const std::string& to) {
  assert(!from.empty());
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

std::string without_folders(const std::string& name) { return name.substr(name.find_last_of("/\\") + 1); }

}  // namespace

const char* name(UploadKind kind) {
  switch (kind) {
    case UploadKind::kFields:
      return "fields";
    case UploadKind::kLog:
      return "log";
    case UploadKind::kPlan:
      return "plan";
    case UploadKind::kUnknown:
      return "unknown";
  }
  return "unknown";
}

std::string Upload::in_its_name(std::string sentence) const {
  replace_all(sentence, path.string(), name);
  // Readers call layers after the file, and features without an id after their layer.
  if (!id.empty()) replace_all(sentence, id + ":", stem_of(name) + ", field ");
  replace_all(sentence, path.filename().string(), name);
  if (!id.empty()) replace_all(sentence, id, stem_of(name));
  return sentence;
}

std::string stem_of(const std::string& name) {
  const std::string file = without_folders(name);
  const std::string stem = file.substr(0, file.size() - extension_of(io::lower_case(file)).size());
  return stem.empty() ? "field" : stem;
}

std::string id_in_its_name(const Upload& upload, const std::string& id) {
  const bool after_the_file = id == upload.id || id.starts_with(upload.id + ":");
  return after_the_file ? stem_of(upload.name) + id.substr(upload.id.size()) : id;
}

Uploads::Uploads(const StoreFolder& folder) : store_(folder), folder_(folder.path() / kFolder) {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Uploads::~Uploads() {
  std::error_code ignored;
  fs::remove_all(folder_, ignored);
}

Upload Uploads::begin(const std::string& name) const {
  Upload out;
  out.id = new_id();
  constexpr std::size_t kLongest = 200;
  out.name = without_folders(name).substr(0, kLongest);
  std::replace_if(
      out.name.begin(), out.name.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  if (out.name.empty()) out.name = "file";
  const fs::path own = store_.part(kFolder) / out.id;
  std::error_code error;
  if (!fs::create_directory(own, error))
    throw failure(fmt::format("the file could not be kept ({}); is the disk full?", error.message()));
  // Readers name layers and obstacles after the file: no two are to have the same name.
  out.path = own / (out.id + std::string(extension_of(io::lower_case(out.name))));
  return out;
}

void Uploads::discard(const Upload& upload) const {
  std::error_code ignored;
  fs::remove_all(folder_ / upload.id, ignored);
}

void Uploads::keep(const Upload& upload) {
  const std::lock_guard lock(mutex_);
  entries_[upload.id] = {upload, std::chrono::steady_clock::now()};
}

Upload Uploads::get(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = entries_.find(id);
  if (found == entries_.end())
    throw HttpError(Fault::kNotFound, "the file is not here any more; choose it again");
  return found->second.upload;
}

void Uploads::remove(const std::string& id) {
  const std::lock_guard lock(mutex_);
  if (entries_.erase(id) == 0) throw not_found("upload", id);
  std::error_code ignored;
  fs::remove_all(folder_ / id, ignored);
}

void Uploads::forget_old() {
  const std::lock_guard lock(mutex_);
  const auto day_ago = std::chrono::steady_clock::now() - std::chrono::hours(24);
  for (auto entry = entries_.begin(); entry != entries_.end();) {
    if (entry->second.since > day_ago) {
      ++entry;
      continue;
    }
    std::error_code ignored;
    fs::remove_all(folder_ / entry->first, ignored);
    entry = entries_.erase(entry);
  }
}

}  // namespace tramline::server
