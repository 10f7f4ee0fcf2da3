#include "tramline/io/vector/open_dataset.h"

#include <fmt/format.h>

#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_drivers.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/locate_dataset.h"
#include "tramline/io/vector/own_content.h"

namespace tramline::io {
namespace {

/// What the user has typed for GDAL itself, and not the path of a file.
bool is_for_gdal(const std::string& path) { return is_database_string(path) || path.starts_with("/vsi"); }

/// Some drivers take any folder and pick a file of their kind from it.
const char* const* folder_drivers() {
  static const char* const drivers[] = {"ESRI Shapefile", "OpenFileGDB", nullptr};
  return drivers;
}

GDALDatasetUniquePtr open(const std::string& name, const char* const* drivers, GdalMessages& messages) {
  // Only the GeoJSON driver knows the option; it keeps whole-number ids apart from counted ones.
  const char* const options[] = {"NATIVE_DATA=YES", nullptr};
  messages.clear();
  return GDALDatasetUniquePtr(
      GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY, drivers, options, nullptr));
}

GDALDatasetUniquePtr open_file(const std::string& name, const std::string& shown, GdalMessages& messages) {
  require_own_content(name, shown);
  return open(name, is_folder(name) ? folder_drivers() : plain_file_drivers(), messages);
}

}  // namespace

std::unique_ptr<ConnectionsAllowed> connections_for(const std::string& path) {
  return is_for_gdal(path) ? std::make_unique<ConnectionsAllowed>() : nullptr;
}

GDALDatasetUniquePtr open_dataset(const std::string& path, const std::string& wanted_layer,
                                  GdalMessages& messages) {
  const std::string file = shown_name(path);
  if (is_for_gdal(path)) {
    GDALDatasetUniquePtr dataset = open(path, is_folder(path) ? folder_drivers() : nullptr, messages);
    if (dataset) return dataset;
    throw bad_input(fmt::format("'{}' cannot be opened: {}", file, messages.last()));
  }
  const std::vector<std::string> names = locate_datasets(path);
  if (names.size() > 1) {
    if (!wanted_layer.empty())
      for (const std::string& name : names) {
        GDALDatasetUniquePtr dataset = open_file(name, file, messages);
        if (dataset && dataset->GetLayerByName(wanted_layer.c_str()) != nullptr) return dataset;
      }
    std::vector<std::string> inner;
    for (const std::string& name : names) inner.push_back(name.substr(name.find('}') + 1));
    throw bad_input(
        fmt::format("'{}' holds several vector files{}; unpack the one you mean or name its layer with "
                    "--layer: {}",
                    file, wanted_layer.empty() ? "" : ", none with layer '" + wanted_layer + "'",
                    fmt::join(inner, ", ")));
  }
  GDALDatasetUniquePtr dataset = open_file(names.front(), file, messages);
  if (dataset) return dataset;
  if (is_folder(names.front()))
    throw bad_input(fmt::format("'{}' is a folder without Shapefiles; name a file in it", file));
  if (messages.feature_too_large())
    throw bad_input(fmt::format(
        "'{}' has a feature of more than a million corners, more than is read; thin its outline", file));
  throw bad_input(
      fmt::format("'{}' cannot be read as a vector file{}; give an undamaged GeoJSON, GeoPackage, Shapefile, "
                  "FlatGeobuf, KML or GML file",
                  file, messages.failed() ? " (" + messages.last() + ")" : ""));
}

}  // namespace tramline::io
