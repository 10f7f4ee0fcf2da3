#include "tramline/io/field/field_values.h"

#include <filesystem>

#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

nlohmann::json to_json(const Repair& repair) {
  return {{"what", repair.what},
          {"where", repair.where},
          {"x", plain_zero(repair.at.x)},
          {"y", plain_zero(repair.at.y)},
          {"area_change_m2", plain_zero(repair.area_change_m2)}};
}

}  // namespace

void leave_folders_out(Metadata& metadata) {
  for (const char* key : {"field.source.file", "field.source.obstacles_file", "field.source.passable_file"})
    metadata[key] = std::filesystem::path(metadata[key]).filename().string();
}

void FieldKeyWriter::operator()(const std::string& key, const std::vector<Repair>& repairs) const {
  nlohmann::json list = nlohmann::json::array();
  for (const Repair& repair : repairs) list.push_back(to_json(repair));
  out()[key] = dumped(list);
}

void FieldKeyReader::operator()(const std::string& key, std::vector<Repair>& repairs) const {
  parse(key, [&](const nlohmann::json& json) {
    for (const nlohmann::json& item : json)
      repairs.push_back({item.at("what").get<std::string>(),
                         item.at("where").get<std::string>(),
                         {item.at("x").get<double>(), item.at("y").get<double>()},
                         item.at("area_change_m2").get<double>()});
  });
}

}  // namespace tramline::io
