#pragma once

#include <string>

namespace tramline::io {

/// The names that distinguish the rows of one field from those of others in the same layers.
struct FieldNames {
  std::string key;  ///< unique in the file
  std::string id;
};
/// The columns of these names, which come first.
inline constexpr const char* kFieldKey = "field_key";
inline constexpr const char* kFieldId = "field_id";

}  // namespace tramline::io
