#pragma once
// Makes fields of uploaded data: a feature of a file, or a drawn shape.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "server/uploads/uploads.h"
#include "tramline/model/field.h"

namespace tramline::server {

struct NewFields {
  std::vector<Field> fields;  ///< the parts of one feature; not empty
  std::vector<Skipped> skipped;
};

/// The feature to read, and the options for reading it.
struct FeatureChoice {
  std::optional<long long> fid;
  std::string layer, crs;
  std::string name;  ///< as its user calls it; empty: as the file does (feature_name.h)
  std::optional<Upload> obstacles;
  std::optional<double> obstacle_size_m;
};
/// Their ids are the name, with " #2" for the second part of the feature. Throws bad_input where it is
/// refused, or several features match.
NewFields fields_from(const Upload& upload, const FeatureChoice& choice);

/// A GeoJSON polygon or multipolygon, longitude and latitude. `name` becomes the field's id. Throws
/// bad_input.
NewFields fields_drawn(const nlohmann::ordered_json& geometry, const std::string& name);

}  // namespace tramline::server
