#include "tramline/io/vector/locate_dataset.h"

#include <cpl_string.h>
#include <cpl_vsi.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <memory>
#include <set>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/lower_case.h"

namespace tramline::io {
namespace {

std::string extension(const std::string& path) {
  const std::size_t dot = path.find_last_of("./");
  return dot == std::string::npos || path[dot] == '/' ? "" : lower_case(path.substr(dot + 1));
}

bool exists(const std::string& path) {
  VSIStatBufL status;
  return VSIStatL(path.c_str(), &status) == 0;
}

/// Vector files that stand for a dataset of their own inside a zip.
bool is_vector_file(const std::string& path) {
  static const std::set<std::string> known = {"shp", "gpkg", "geojson", "json", "geojsonl", "fgb", "kml",
                                              "kmz", "gml",  "sqlite",  "tab",  "mif",      "gpx", "dxf"};
  return known.count(extension(path)) > 0;
}

std::vector<std::string> members(const std::string& zip) {
  char** list = VSIReadDirRecursive(zip.c_str());
  std::vector<std::string> out;
  for (int i = 0; list != nullptr && list[i] != nullptr; ++i) out.emplace_back(list[i]);
  CSLDestroy(list);
  std::sort(out.begin(), out.end());
  return out;
}

/// A compressed file is expanded whole by most drivers. `name` is GDAL's for the packed one, `file` the
/// user's. Gives its size.
std::size_t expanded_size(const std::string& name, const std::string& file) {
  const std::unique_ptr<VSILFILE, int (*)(VSILFILE*)> expanded(VSIFOpenL(name.c_str(), "rb"), VSIFCloseL);
  if (!expanded) throw bad_input(fmt::format("'{}' cannot be opened", file));
  std::vector<char> buffer(std::size_t{1} << 20);
  std::size_t size = 0;
  for (std::size_t got = 0; (got = VSIFReadL(buffer.data(), 1, buffer.size(), expanded.get())) > 0;)
    if ((size += got) > kMostExpandedDataset)
      throw bad_input(
          fmt::format("'{}' expands to more than {} MiB; unpack it first", file, kMostExpandedDataset >> 20));
  return size;
}

/// The members of a zip that are vector datasets, each by itself: what a directory says of them may be wrong.
void refuse_endless(const std::string& zip, const std::set<std::string>& datasets, const std::string& file) {
  for (const std::string& name : datasets)
    if (const std::string full = zip + "/" + name; is_vector_file(name)) expanded_size(full, file);
}

/// Names inside the zip to open: a folder of Shapefiles counts once, a file geodatabase is its folder.
std::set<std::string> datasets_among(const std::vector<std::string>& names) {
  std::set<std::string> out;
  for (std::string name : names) {
    // macOS adds a shadow of every file.
    if (name.rfind("__MACOSX", 0) == 0) continue;
    if (!name.empty() && name.back() == '/') name.pop_back();
    if (extension(name) == "gdb") out.insert(name);
    if (!is_vector_file(name)) continue;
    const std::size_t slash = name.rfind('/');
    const std::string folder = slash == std::string::npos ? "" : name.substr(0, slash);
    const auto same_folder_shapefile = [&](const std::string& other) {
      return other != name && extension(other) == "shp" && other.substr(0, folder.size()) == folder &&
             other.find('/', folder.size() + 1) == std::string::npos;
    };
    const bool several =
        extension(name) == "shp" && std::any_of(names.begin(), names.end(), same_folder_shapefile);
    out.insert(several ? folder : name);
  }
  return out;
}

}  // namespace

bool is_database_string(const std::string& file) {
  const auto is_word = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; };
  const auto end = std::find_if_not(file.begin(), file.end(), is_word);
  // A single letter would be a drive.
  return end != file.end() && *end == ':' && end - file.begin() >= 2 && !exists(file);
}

bool is_folder(const std::string& name) {
  VSIStatBufL status;
  return VSIStatExL(name.c_str(), &status, VSI_STAT_EXISTS_FLAG | VSI_STAT_NATURE_FLAG) == 0 &&
         VSI_ISDIR(status.st_mode);
}

std::string shown_name(const std::string& file) {
  std::string out = file;
  const std::string key = "password=";
  for (std::size_t at = lower_case(out).find(key); at != std::string::npos;
       at = lower_case(out).find(key, at + key.size())) {
    const std::size_t start = at + key.size();
    const char closing = start < out.size() && out[start] == '\'' ? '\'' : ' ';
    const std::size_t end = out.find(closing, start + 1);
    const std::size_t stop = end == std::string::npos ? out.size() : closing == ' ' ? end : end + 1;
    out.replace(start, stop - start, "***");
  }
  // postgresql://user:secret@host/…
  const std::size_t user = out.find("://"), host = out.find('@');
  if (user == std::string::npos || host == std::string::npos) return out;
  const std::size_t colon = out.find(':', user + 3);
  if (colon < host) out.replace(colon + 1, host - colon - 1, "***");
  return out;
}

std::vector<std::string> locate_datasets(const std::string& file) {
  if (file.empty()) throw bad_input("no field file was named; give the path of a vector file");
  if (is_database_string(file) || file.rfind("/vsi", 0) == 0) return {file};
  const GdalMessages silence;
  if (!exists(file)) throw bad_input(fmt::format("there is no file '{}'; check the path", file));
  if (extension(file) == "gz") {
    expanded_size("/vsigzip/" + file, file);
    return {"/vsigzip/" + file};
  }
  if (extension(file) != "zip") return {file};

  const std::string zip = "/vsizip/{" + file + "}";
  const std::vector<std::string> names = members(zip);
  if (names.empty())
    throw bad_input(fmt::format(
        "'{}' cannot be read as a zip file; it is empty or was cut off, so fetch it again", file));
  const std::set<std::string> datasets = datasets_among(names);
  refuse_endless(zip, datasets, file);
  std::vector<std::string> out;
  for (const std::string& name : datasets)
    out.push_back(name.empty() ? zip : fmt::format("{}/{}", zip, name));
  if (out.empty())
    throw bad_input(fmt::format(
        "'{}' holds no vector file; found {}", file,
        fmt::join(names.begin(), names.begin() + std::min<std::ptrdiff_t>(5, std::ssize(names)), ", ")));
  return out;
}

}  // namespace tramline::io
