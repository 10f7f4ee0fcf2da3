// Any bytes as a file with fields: the first byte picks the ending of its name, which some drivers go by.

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <string>
#include <string_view>

#include "memory_file.h"
#include "tramline/geometry/error.h"
#include "tramline/io/land/read_fields.h"

namespace {

constexpr std::array kEndings = {"geojson", "kml", "gml", "csv", "zip",  "xml", "shp", "gpkg",
                                 "fgb",     "kmz", "dxf", "mif", "json", "gpx", "tab", "geojson.gz"};

void demand(bool holds) {
  if (!holds) std::abort();
}

/// There is something, and not more than was asked for.
void demand_sound(const tramline::RawDataset& dataset, const tramline::io::VectorQuery& query) {
  std::size_t features = 0;
  for (const tramline::RawLayer& layer : dataset.layers) {
    features += layer.features.size();
    demand(query.limit < 0 || std::ssize(layer.features) <= query.limit);
    demand(layer.matching >= std::ssize(layer.features));
    for (const tramline::RawFeature& feature : layer.features)
      for (const tramline::RawPolygon& polygon : feature.polygons) demand(!polygon.rings.empty());
  }
  demand(features > 0);
}

}  // namespace

/// libkml forgets archives that it could not read.
extern "C" const char* __lsan_default_suppressions() { return "leak:libkml\n"; }

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const tramline::fuzz::MemoryFolder folder;
  if (size == 0) return 0;
  const std::string name = std::string("f.") + kEndings[data[0] % kEndings.size()];
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  for (const bool all_layers : {false, true}) {
    tramline::io::VectorQuery query;
    query.file = folder.write(name, bytes).string();
    query.all_layers = all_layers;
    query.limit = all_layers ? -1 : 3;
    try {
      demand_sound(tramline::io::read_fields(query), query);
    } catch (const tramline::Error&) {
      // A refusal is an answer; any other exception is a fault.
    }
  }
  return 0;
}
