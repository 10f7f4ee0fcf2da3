#include "tramline/io/land/read_fields.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_folder.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/isoxml/task_files.h"
#include "tramline/io/land/select_features.h"
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

/// What a kind of source calls its layers and its fields.
struct SourceWords {
  const char* usual_layer;  ///< read where none is named
  const char* layers;       ///< a sentence
  const char* field;
};

constexpr SourceWords kTaskSet{"partfields", "a task set has partfields, and obstacles where there are some",
                               "partfield"};
constexpr SourceWords kFieldFolder{"fields", "a field folder of AgOpenGPS has fields", "field"};

std::vector<RawLayer> chosen_layers(std::vector<RawLayer> layers, const VectorQuery& query,
                                    const SourceWords& words) {
  if (query.all_layers) return layers;
  const auto find = [&](const std::string& name) {
    return std::find_if(layers.begin(), layers.end(),
                        [&](const RawLayer& layer) { return layer.name == name; });
  };
  const bool named = !query.layer.empty();
  auto at = find(named ? query.layer : words.usual_layer);
  if (at == layers.end() && query.layer_is_hint) at = find(words.usual_layer);
  if (at == layers.end())
    throw bad_input(fmt::format("'{}' has no layer '{}'; {}", query.file, query.layer, words.layers));
  return {std::move(*at)};
}

std::optional<FieldFolder> field_folder(const std::string& file) {
  return is_database_string(file) ? std::nullopt : FieldFolder::open(file);
}

}  // namespace

RawDataset read_fields(const VectorQuery& query) {
  const auto folder = field_folder(query.file);
  if (!folder && !is_task_set(query.file)) return read_vector(query);
  RawDataset out = folder ? field_in(*folder) : read_partfields(query.file);
  const SourceWords& words = folder ? kFieldFolder : kTaskSet;
  out.layers = chosen_layers(std::move(out.layers), query, words);
  bool any = false;
  for (RawLayer& layer : out.layers) {
    select_features(layer, query);
    any = any || !layer.features.empty();
  }
  if (!any)
    throw bad_input(
        fmt::format("no {} of '{}' matches --where \"{}\"", words.field, query.file, query.where));
  return out;
}

RawDataset read_guides(const VectorQuery& query) {
  const auto folder = field_folder(query.file);
  if (!folder && !is_task_set(query.file)) return read_vector(query);
  RawDataset out = folder ? guides_in(*folder) : read_guidance(query.file);
  if (!query.where.empty()) select_guides(out.layers.front(), query);
  return out;
}

}  // namespace tramline::io
