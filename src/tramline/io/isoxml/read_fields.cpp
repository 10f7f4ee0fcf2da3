#include "tramline/io/isoxml/read_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_folder.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/isoxml/task_files.h"
#include "tramline/io/vector/locate_dataset.h"

namespace tramline::io {
namespace {

constexpr std::size_t kLooked = 8192;

bool is_task_set(const std::string& file) {
  if (is_database_string(file) || !TaskFiles::looks_like_one(file)) return false;
  std::error_code error;
  if (std::filesystem::is_directory(file, error) || !lower_case(file).ends_with(".xml")) return true;
  return first_bytes(file, kLooked).find("<ISO11783_TaskData") != std::string::npos;
}

/// A filter such as id = 'PFD1': the key in small letters, and the value.
struct EqualsFilter {
  std::string key;
  std::string value;
};

/// nullopt for other filters.
std::optional<EqualsFilter> equals_filter(std::string_view where) {
  const std::size_t equals = where.find('=');
  if (equals == std::string_view::npos) return std::nullopt;
  const std::string_view value = trimmed(where.substr(equals + 1));
  if (value.size() < 2 || value.front() != '\'' || value.find('\'', 1) != value.size() - 1)
    return std::nullopt;
  return EqualsFilter{lower_case(trimmed(where.substr(0, equals))),
                      std::string(value.substr(1, value.size() - 2))};
}

std::vector<RawLayer> chosen_layers(std::vector<RawLayer> layers, const VectorQuery& query) {
  if (query.all_layers) return layers;
  const auto find = [&](const std::string& name) {
    return std::find_if(layers.begin(), layers.end(),
                        [&](const RawLayer& layer) { return layer.name == name; });
  };
  const bool named = !query.layer.empty();
  auto at = find(named ? query.layer : "partfields");
  if (at == layers.end() && query.layer_is_hint) at = find("partfields");
  if (at == layers.end())
    throw bad_input(
        fmt::format("'{}' has no layer '{}'; a task set has partfields, and obstacles where there are "
                    "some",
                    query.file, query.layer));
  return {std::move(*at)};
}

void select_features(RawLayer& layer, const VectorQuery& query) {
  if (!query.where.empty()) {
    const auto wanted = equals_filter(query.where);
    if (!wanted || wanted->key != "id")
      throw bad_input(fmt::format("--where \"{}\" is not understood for '{}'; write for example id='{}'",
                                  query.where, query.file,
                                  layer.features.empty() ? "PFD1" : layer.features.front().id));
    std::erase_if(layer.features, [&](const RawFeature& feature) { return feature.id != wanted->value; });
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
  if (!wanted || (wanted->key != "id" && wanted->key != "name"))
    throw bad_input(
        fmt::format("--guide-where \"{}\" is not understood for '{}'; write for example name='AB 1'",
                    query.where, query.file));
  std::string names;
  for (const RawFeature& feature : layer.features)
    names += (names.empty() ? "" : ", ") + feature.attributes.at("name");
  std::erase_if(layer.features, [&](const RawFeature& feature) {
    return (wanted->key == "id" ? feature.id : feature.attributes.at("name")) != wanted->value;
  });
  if (layer.features.empty())
    throw bad_input(fmt::format("no line of '{}' matches --guide-where \"{}\"; there are {}", query.file,
                                query.where, names));
}

}  // namespace

RawDataset read_fields(const VectorQuery& query) {
  const auto folder = is_database_string(query.file) ? std::nullopt : FieldFolder::open(query.file);
  if (!folder && !is_task_set(query.file)) return read_vector(query);
  RawDataset out = folder ? field_in(*folder) : read_partfields(query.file);
  if (!folder) out.layers = chosen_layers(std::move(out.layers), query);
  bool any = false;
  for (RawLayer& layer : out.layers) {
    select_features(layer, query);
    any = any || !layer.features.empty();
  }
  if (!any)
    throw bad_input(fmt::format("no {} of '{}' matches --where \"{}\"", folder ? "field" : "partfield",
                                query.file, query.where));
  return out;
}

RawDataset read_guides(const VectorQuery& query) {
  const auto folder = is_database_string(query.file) ? std::nullopt : FieldFolder::open(query.file);
  if (!folder && !is_task_set(query.file)) return read_vector(query);
  RawDataset out = folder ? guides_in(*folder) : read_guidance(query.file);
  if (!query.where.empty()) select_guides(out.layers.front(), query);
  return out;
}

}  // namespace tramline::io
