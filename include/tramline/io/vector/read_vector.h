#pragma once
// Reads any vector file, zip or database that OGR can open, as plain values.

#include <optional>
#include <string>
#include <vector>

#include "tramline/model/raw_feature.h"

namespace tramline::io {

/// The shapes to read from a file. Where no layer is named, layers with other shapes are ignored.
enum class WantedShapes { kPolygons, kLines };

/// What to read. `file` is a path (a .zip may hold the files in folders) or a database string ("PG:…").
struct VectorQuery {
  std::string file;
  std::string layer;                    ///< empty: the one layer with polygons, or with lines
  bool layer_is_hint = false;           ///< if there is no layer of that name, read as if none had been named
  std::string where;                    ///< OGR attribute filter, for example "crop = 'wheat'"; empty: all
  std::optional<long long> fid;         ///< only the feature with this number
  long long limit = -1;                 ///< stop after so many features of a layer; negative: read all
  std::vector<std::string> attributes;  ///< to be read, whatever the case of their names in the file
  bool every_attribute = false;         ///< read all attributes, by their names in the file
  bool all_layers = false;              ///< read every layer, whatever its geometry (obstacle files)
  WantedShapes shapes = WantedShapes::kPolygons;
};

/// Reads the features in file order. Arcs become chords of at most 1 degree (area error below 0.006 %).
/// Throws bad_input, in one sentence, for: a missing file, a file that is not a vector file or is truncated,
/// an unknown layer (naming those found), several layers with such shapes and no choice, a filter OGR does
/// not understand, and a result without any feature. Messages name the options --layer and --where, or, for
/// lines,
/// --lines-layer and --lines-where. Of the layers with lines those without features do not count, and of an
/// export of a plan (layer `tracks` with a column `order`) `tracks` and `headland_passes` are read together.
/// Prints nothing. O(size of the file).
RawDataset read_vector(const VectorQuery& query);

}  // namespace tramline::io
