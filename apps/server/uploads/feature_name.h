#pragma once
// What people call a field, by the attributes of its feature.

#include <map>
#include <string>

namespace tramline::server {

/// The value of the attribute that names the feature, in the languages of common registers and programs; else
/// of one that numbers it there; empty where there is none. Names of attributes are compared whatever their
/// case. O(attributes).
std::string feature_name(const std::map<std::string, std::string>& attributes);

/// The value of the attribute that says what grows there, likewise.
std::string feature_crop(const std::map<std::string, std::string>& attributes);

}  // namespace tramline::server
