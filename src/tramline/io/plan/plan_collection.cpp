#include "tramline/io/plan/plan_collection.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tramline/geometry/error.h"
#include "tramline/io/field/field_values.h"
#include "tramline/io/geopackage/gdal_errors.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/plan_layers.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr int kVersion = 1;

LocalFrame frame_from(const std::string& text, const fs::path& path) {
  const json value = json::parse(text, nullptr, false);
  try {
    if (value.at("format_version").get<int>() != kVersion)
      throw bad_input(
          fmt::format("{}: this file of many plans is of version {}; read it with the tramline that "
                      "wrote it",
                      path.string(), value.at("format_version").dump()));
    LocalFrame out;
    out.geodetic = value.at("geodetic").get<bool>();
    out.origin_lon_deg = value.at("origin_lon_deg").get<double>();
    out.origin_lat_deg = value.at("origin_lat_deg").get<double>();
    return out;
  } catch (const json::exception&) {
    throw bad_input(fmt::format("{}: table metadata, {} is of another form; write the plans again",
                                path.string(), kCollectionKey));
  }
}

std::string listed(const std::vector<FieldNames>& fields) {
  constexpr std::size_t kListed = 20;
  std::string out;
  for (std::size_t i = 0; i < fields.size() && i < kListed; ++i)
    out += fmt::format("{}{} ({})", i > 0 ? ", " : "", fields[i].key, fields[i].id);
  if (fields.size() > kListed) out += fmt::format(" and {} more", fields.size() - kListed);
  return out;
}

}  // namespace

std::string collection_text(const LocalFrame& common) {
  return json{{"format_version", kVersion},
              {"geodetic", common.geodetic},
              {"origin_lon_deg", common.origin_lon_deg},
              {"origin_lat_deg", common.origin_lat_deg}}
      .dump();
}

std::optional<LocalFrame> collection_frame(Rows& file, const fs::path& path) {
  std::optional<LocalFrame> out;
  file.each(kMetadataTable, [&](const Row& row) {
    if (!out && row.has(kFieldKey) && row.text("key") == kCollectionKey)
      out = frame_from(row.text("value"), path);
  });
  return out;
}

LocalFrame frame_of_layers(const fs::path& path, const LocalFrame& field) {
  GdalErrors errors;
  Rows file(path, kPlanFile, errors);
  return collection_frame(file, path).value_or(field);
}

bool is_plan_file(const fs::path& path) {
  try {
    GdalErrors errors;
    Rows file(path, kPlanFile, errors);
    if (!file.has(kMetadataTable) || !file.has(plan_layers::kTracks)) return false;
    bool found = false;
    file.each(kMetadataTable, [&](const Row& row) {
      if (!row.has("key") || !row.has("value")) return;
      found = found || (row.text("key") == "format" && row.text("value") == kPlanFile.writer);
    });
    return found;
  } catch (const Error&) {
    return false;
  }
}

std::vector<FieldNames> fields_in(const fs::path& path) {
  GdalErrors errors;
  Rows file(path, kPlanFile, errors);
  std::vector<FieldNames> out;
  file.each(plan_layers::kField, [&](const Row& row) {
    if (row.has(kFieldKey)) out.push_back({row.text(kFieldKey), row.text(kFieldId)});
  });
  return out;
}

std::map<std::string, LocalFrame, std::less<>> frames_in(const fs::path& path) {
  GdalErrors errors;
  Rows file(path, kPlanFile, errors);
  std::map<std::string, Metadata> tables;
  file.each(kMetadataTable, [&](const Row& row) {
    const std::string field = row.has(kFieldKey) ? row.text(kFieldKey) : std::string();
    if (row.text("key").starts_with("frame.")) tables[field][row.text("key")] = row.text("value");
  });
  std::map<std::string, LocalFrame, std::less<>> out;
  for (const auto& [field, table] : tables) {
    const KeyReader read(table, path, kPlanFile);
    each_frame_value(out[field], read);
  }
  return out;
}

FieldNames chosen_field(const std::vector<FieldNames>& fields, const std::string& asked,
                        const fs::path& path) {
  if (asked.empty() && fields.size() == 1) return fields.front();
  std::vector<FieldNames> found;
  for (const FieldNames& field : fields)
    if (field.key == asked || field.id == asked) found.push_back(field);
  if (found.size() == 1) return found.front();
  if (found.size() > 1)
    throw bad_input(fmt::format("{}: {} fields are called '{}'; name one by its key: {}", path.string(),
                                found.size(), asked, listed(found)));
  throw bad_input(fmt::format("{}: {}; there are {}", path.string(),
                              asked.empty() ? "the file holds several plans: name a field with --id"
                                            : fmt::format("there is no plan of a field '{}'", asked),
                              listed(fields)));
}

}  // namespace tramline::io
