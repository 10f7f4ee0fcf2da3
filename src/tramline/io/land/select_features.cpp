#include "tramline/io/land/select_features.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/number_text.h"

namespace tramline::io {
namespace {

/// A filter such as id = 'PFD1': the key in small letters, and the value.
struct EqualsFilter {
  std::string key;
  std::string value;
};

/// nullopt for other filters. A quotation mark in the value is written twice.
std::optional<EqualsFilter> equals_filter(std::string_view where) {
  const std::size_t equals = where.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  std::string_view quoted = trimmed(where.substr(equals + 1));
  if (quoted.size() < 2 || quoted.front() != '\'' || quoted.back() != '\'') return std::nullopt;
  quoted = quoted.substr(1, quoted.size() - 2);
  EqualsFilter out{lower_case(trimmed(where.substr(0, equals))), {}};
  while (!quoted.empty()) {
    const bool mark = quoted.front() == '\'';
    if (mark && !quoted.starts_with("''")) return std::nullopt;
    out.value += quoted.front();
    quoted.remove_prefix(mark ? 2 : 1);
  }
  return out;
}

/// What the feature has under this key; empty where it has nothing.
std::string value_of(const RawFeature& feature, const std::string& key) {
  if (key == "id") return feature.id;
  const auto at = feature.attributes.find(key);
  return at == feature.attributes.end() ? "" : at->second;
}

bool is_one_of(const std::string& key, std::initializer_list<const char*> keys) {
  return std::find(keys.begin(), keys.end(), key) != keys.end();
}

}  // namespace

void select_features(RawLayer& layer, const VectorQuery& query) {
  if (!query.where.empty()) {
    const auto wanted = equals_filter(query.where);
    if (!wanted || !is_one_of(wanted->key, {"id", "code", "designator"}))
      throw bad_input(fmt::format("--where \"{}\" is not understood for '{}'; write for example id='{}'",
                                  query.where, query.file,
                                  layer.features.empty() ? "PFD1" : layer.features.front().id));
    std::erase_if(layer.features,
                  [&](const RawFeature& feature) { return value_of(feature, wanted->key) != wanted->value; });
  }
  if (query.fid) {
    std::erase_if(layer.features, [&](const RawFeature& feature) { return feature.fid != *query.fid; });
    if (layer.features.empty())
      throw bad_input(fmt::format("layer '{}' of '{}' has no feature with number {}", layer.name, query.file,
                                  *query.fid));
  }
  layer.matching = std::ssize(layer.features);
  if (query.limit >= 0 && std::ssize(layer.features) > query.limit)
    layer.features.resize(static_cast<std::size_t>(query.limit));
}

void select_guides(RawLayer& layer, const VectorQuery& query) {
  const auto wanted = equals_filter(query.where);
  if (!wanted || !is_one_of(wanted->key, {"id", "name"}))
    throw bad_input(
        fmt::format("--guide-where \"{}\" is not understood for '{}'; write for example name='AB 1'",
                    query.where, query.file));
  std::string names;
  for (const RawFeature& feature : layer.features)
    names += (names.empty() ? "" : ", ") + value_of(feature, wanted->key);
  std::erase_if(layer.features,
                [&](const RawFeature& feature) { return value_of(feature, wanted->key) != wanted->value; });
  if (layer.features.empty())
    throw bad_input(fmt::format("no line of '{}' matches --guide-where \"{}\"; there are {}", query.file,
                                query.where, names));
}

}  // namespace tramline::io
