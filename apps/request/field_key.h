#pragma once
// What tells the fields of a run apart: ids in files are not always unique.

#include <string>

#include "tramline/model/field.h"

namespace tramline::app {

/// "parcels:17", and "parcels:17#2" for the second part of that feature: layer and feature number, which no
/// two fields of one file share.
std::string field_key(const std::string& layer, long long fid, int part = 0);
inline std::string field_key(const Field& field) {
  return field_key(field.source.layer, field.source.fid, field.source.part);
}

/// Is the field meant by a user who says `id`: its id, or its key?
bool is_named(const Field& field, const std::string& id);

/// Could a part of the feature be meant? `feature_id`: as the fields of its parts begin.
bool may_be_named(const std::string& feature_id, const std::string& layer, long long fid,
                  const std::string& id);

}  // namespace tramline::app
