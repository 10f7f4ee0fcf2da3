#pragma once
// What people call a field, by the attributes of its feature.

#include <map>
#include <string>

#include "server/uploads/uploads.h"
#include "tramline/model/raw_feature.h"

namespace tramline::server {

/// The value of the attribute that names the feature, in the languages of common registers and programs; else
/// of one that numbers it there; empty where there is none. Names of attributes are compared whatever their
/// case. O(attributes).
std::string feature_name(const std::map<std::string, std::string>& attributes);

/// The value of the attribute that says what grows there, likewise.
std::string feature_crop(const std::map<std::string, std::string>& attributes);

/// As feature_name() of the feature with number `fid` of a file, whose only layer it is where `layer` is
/// empty; else the id of the feature; empty where it has neither. Throws bad_input where the file has no such
/// feature. O(size of the file).
std::string name_in_file(const std::string& file, const std::string& layer, long long fid);

/// What people call a feature of an upload: as name_in_file(), else after its layer ("mill field"), with its
/// number where there are `in_layer` > 1 features ("mill field, field 3").
std::string name_in_upload(const Upload& upload, const std::string& layer, const RawFeature& feature,
                           long long in_layer);
/// The same, of the feature with number `fid`. Throws as name_in_file().
std::string name_in_upload(const Upload& upload, const std::string& layer, long long fid);

/// The sentence of admission about a feature, "farm.gpkg, feature 'parcels:3': …", with its name in the
/// quotes; other sentences as they are.
std::string with_name(std::string sentence, const std::string& name);

}  // namespace tramline::server
