#include "tramline/io/vector/open_dataset.h"

#include <fmt/format.h>

#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/vector/gdal_messages.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

GDALDatasetUniquePtr open(const std::string& name, GdalMessages& messages) {
  // Only the GeoJSON driver knows the option; it keeps whole-number ids apart from counted ones.
  const char* const options[] = {"NATIVE_DATA=YES", nullptr};
  // Some drivers take any folder and pick a file of their kind from it.
  const char* const folder_drivers[] = {"ESRI Shapefile", "OpenFileGDB", nullptr};
  messages.clear();
  return GDALDatasetUniquePtr(GDALDataset::Open(name.c_str(), GDAL_OF_VECTOR | GDAL_OF_READONLY,
                                                is_folder(name) ? folder_drivers : nullptr, options,
                                                nullptr));
}

}  // namespace

GDALDatasetUniquePtr open_dataset(const std::string& path, const std::string& wanted_layer,
                                  GdalMessages& messages) {
  const std::string file = shown_name(path);
  const std::vector<std::string> names = locate_datasets(path);
  if (names.size() > 1) {
    if (!wanted_layer.empty())
      for (const std::string& name : names) {
        GDALDatasetUniquePtr dataset = open(name, messages);
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
  GDALDatasetUniquePtr dataset = open(names.front(), messages);
  if (dataset) return dataset;
  if (is_folder(names.front()))
    throw bad_input(fmt::format("'{}' is a folder without Shapefiles; name a file in it", file));
  if (is_database_string(path))
    throw bad_input(fmt::format("'{}' cannot be opened: {}", file, messages.last()));
  throw bad_input(
      fmt::format("'{}' cannot be read as a vector file{}; give an undamaged GeoJSON, GeoPackage, Shapefile, "
                  "FlatGeobuf, KML or GML file",
                  file, messages.failed() ? " (" + messages.last() + ")" : ""));
}

}  // namespace tramline::io
