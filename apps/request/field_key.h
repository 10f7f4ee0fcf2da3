#pragma once
// Keys that distinguish the fields of a run: ids in files are not always unique.

#include <string>

#include "tramline/model/field.h"

namespace tramline::app {

/// "parcels:17", and "parcels:17#2" for the second part of that feature: layer and feature number, which no
/// two fields of one file share.
std::string field_key(const std::string& layer, long long fid, int part = 0);
inline std::string field_key(const Field& field) {
  return field_key(field.source.layer, field.source.fid, field.source.part);
}

/// Whether `id`, as given by a user, is the field's id or its key.
bool is_named(const Field& field, const std::string& id);

/// Whether `id` could be that of a part of the feature. `feature_id`: the beginning of the ids of its parts.
bool may_be_named(const std::string& feature_id, const std::string& layer, long long fid,
                  const std::string& id);

}  // namespace tramline::app
