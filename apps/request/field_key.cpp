#include "request/field_key.h"

#include <fmt/format.h>

namespace tramline::app {
namespace {

/// "mill" itself, or "mill#" and a number.
bool is_part_of(const std::string& id, const std::string& whole) {
  if (id == whole) return true;
  const std::string rest = id.starts_with(whole + "#") ? id.substr(whole.size() + 1) : "";
  return !rest.empty() && rest.find_first_not_of("0123456789") == std::string::npos;
}

}  // namespace

std::string field_key(const std::string& layer, long long fid, int part) {
  return fmt::format("{}:{}{}", layer, fid, part > 0 ? fmt::format("#{}", part + 1) : "");
}

bool is_named(const Field& field, const std::string& id) { return field.id == id || field_key(field) == id; }

bool may_be_named(const std::string& feature_id, const std::string& layer, long long fid,
                  const std::string& id) {
  return is_part_of(id, feature_id) || is_part_of(id, field_key(layer, fid));
}

}  // namespace tramline::app
