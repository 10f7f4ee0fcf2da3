#pragma once
// The parcels of a file that has very many, without looking at each for faults.

#include <nlohmann/json.hpp>
#include <string>

#include "server/uploads/uploads.h"
#include "tramline/model/raw_feature.h"

namespace tramline::server {

/// Adds the features of a layer to a list of candidates, with what people choose by: name, attributes, about
/// the area, and a shape of few corners. Whether a field can be planned shows when it is stored. Throws
/// bad_input for faults of the file. O(vertices).
void add_register(const Upload& upload, const std::string& layer, nlohmann::ordered_json& features);

/// What the attributes say of a feature: {name, crop, attributes}; the name is the feature's id or number in
/// its file where nobody gave it one.
nlohmann::ordered_json words_of(const Upload& upload, const std::string& layer, const RawFeature& feature,
                                std::size_t in_layer);

}  // namespace tramline::server
