#include "tramline/io/plan/plan_keys.h"

#include <fmt/format.h>

#include <cstdlib>
#include <limits>
#include <nlohmann/json.hpp>

#include "tramline/io/plan/path_text.h"

namespace tramline::io {
namespace {

/// The shortest number of degrees that makes the same angle, to the bit of its radians; where none does,
/// the nearest. 15 degrees in radians and back are 14.999999999999998.
double short_degrees(Angle angle) {
  for (int digits = 1; digits < 17; ++digits) {
    const double degrees = std::strtod(fmt::format("{:.{}g}", angle.degrees(), digits).c_str(), nullptr);
    if (Angle::degrees(degrees) == angle) return degrees;
  }
  return angle.degrees();
}

int count(const nlohmann::json& item) {
  if (!item.is_number_integer() || item.get<long long>() < 0 ||
      item.get<long long>() > std::numeric_limits<int>::max())
    throw nlohmann::json::other_error::create(0, "no count", nullptr);
  return item.get<int>();
}

/// A loop over a number runs once.
void require_list(const nlohmann::json& list) {
  if (!list.is_array()) throw nlohmann::json::other_error::create(0, "no list", nullptr);
}

}  // namespace

void PlanKeyWriter::operator()(const std::string& key, Angle value) const {
  (*this)(key + "_deg", short_degrees(value));
  (*this)(key + "_rad", value.radians());
}

void PlanKeyWriter::operator()(const std::string& key, const std::vector<int>& values) const {
  out()[key] = dumped(nlohmann::json(values));
}

void PlanKeyWriter::operator()(const std::string& key, const std::vector<Point>& line) const {
  out()[key] = points_text(line, offset_);
}

void PlanKeyWriter::operator()(const std::string& key, const Path& path) const {
  out()[key] = path_text_if_any(path, offset_);
}

void PlanKeyWriter::operator()(const std::string& key, const std::vector<Path>& paths) const {
  nlohmann::json texts = nlohmann::json::array();
  for (const Path& path : paths) texts.push_back(path_text_if_any(path, offset_));
  out()[key] = dumped(texts);
}

void PlanKeyReader::operator()(const std::string& key, Angle& value) {
  double radians = 0;
  (*this)(key + "_rad", radians);
  value = Angle::radians(radians);
}

void PlanKeyReader::operator()(const std::string& key, std::vector<int>& values) {
  parse(key, [&](const nlohmann::json& list) {
    require_list(list);
    for (const nlohmann::json& item : list) values.push_back(count(item));
  });
}

void PlanKeyReader::operator()(const std::string& key, std::vector<Point>& line) {
  line = points_from_text(text(key), offset_, place_of(key));
}

void PlanKeyReader::operator()(const std::string& key, Path& path) {
  path = path_from_text_if_any(text(key), offset_, place_of(key));
}

void PlanKeyReader::operator()(const std::string& key, std::vector<Path>& paths) {
  parse(key, [&](const nlohmann::json& list) {
    require_list(list);
    for (const nlohmann::json& item : list)
      paths.push_back(path_from_text_if_any(item.get<std::string>(), offset_, place_of(key)));
  });
}

}  // namespace tramline::io
