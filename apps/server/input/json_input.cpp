#include "server/input/json_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "tramline/geometry/error.h"

namespace tramline::server {
namespace {

using nlohmann::ordered_json;

constexpr std::size_t kLongestName = 200;
/// More points than anybody draws.
constexpr std::size_t kMostPoints = 100'000;

}  // namespace

JsonInput::JsonInput(const ordered_json& json, std::string place, std::span<const char* const> known)
    : json_(json), place_(std::move(place)) {
  if (!json.is_object())
    throw bad_input(fmt::format("{} has to be an object in braces", place_.empty() ? "the request" : place_));
  for (const auto& item : json.items())
    if (const std::string& key = item.key();
        std::none_of(known.begin(), known.end(), [&](const char* name) { return key == name; }))
      throw bad_input(fmt::format("'{}' is not a known key; the keys are {}", place_of(key.c_str()),
                                  fmt::join(known.begin(), known.end(), ", ")));
}

std::string JsonInput::place_of(const char* key) const { return place_.empty() ? key : place_ + "." + key; }

bool JsonInput::has(const char* key) const {
  const auto found = json_.find(key);
  return found != json_.end() && !found->is_null();
}

const ordered_json& JsonInput::value(const char* key) const {
  static const ordered_json nothing;
  const auto found = json_.find(key);
  return found == json_.end() ? nothing : *found;
}

double JsonInput::number(const char* key) const {
  const ordered_json& found = value(key);
  if (!found.is_number()) throw bad_input(fmt::format("{} has to be a number", place_of(key)));
  return found.get<double>();
}

std::optional<double> JsonInput::number_if(const char* key) const {
  if (!has(key)) return std::nullopt;
  return number(key);
}

std::optional<long long> JsonInput::whole_if(const char* key) const {
  if (!has(key)) return std::nullopt;
  const double found = number(key);
  // Exact as a double.
  if (std::floor(found) != found || std::abs(found) > 9e15)
    throw bad_input(fmt::format("{} has to be a whole number", place_of(key)));
  return static_cast<long long>(found);
}

std::string JsonInput::text(const char* key) const {
  const ordered_json& found = value(key);
  if (!found.is_string()) throw bad_input(fmt::format("{} has to be a text", place_of(key)));
  return found.get<std::string>();
}

std::string JsonInput::text_or_none(const char* key) const { return has(key) ? text(key) : std::string(); }

std::optional<bool> JsonInput::flag_if(const char* key) const {
  if (!has(key)) return std::nullopt;
  if (!value(key).is_boolean()) throw bad_input(fmt::format("{} has to be true or false", place_of(key)));
  return value(key).get<bool>();
}

const ordered_json& JsonInput::list(const char* key) const {
  static const ordered_json none = ordered_json::array();
  if (!has(key)) return none;
  if (!value(key).is_array()) throw bad_input(fmt::format("{} has to be a list", place_of(key)));
  return value(key);
}

Point position_of(const ordered_json& json, const std::string& place) {
  const bool whole = json.is_array() && json.size() >= 2 && json[0].is_number() && json[1].is_number();
  if (!whole) throw bad_input(fmt::format("{} has to be a point, [longitude, latitude]", place));
  const Point p{json[0].get<double>(), json[1].get<double>()};
  if (!(std::abs(p.x) <= 180 && std::abs(p.y) <= 90))
    throw bad_input(
        fmt::format("{} is ({:g}, {:g}), which is not a longitude and latitude", place, p.x, p.y));
  return p;
}

std::vector<Point> positions_of(const ordered_json& json, const std::string& place) {
  if (!json.is_array()) throw bad_input(fmt::format("{} has to be a list of points", place));
  if (json.size() > kMostPoints)
    throw bad_input(
        fmt::format("{} has {} points; at most {} are accepted", place, json.size(), kMostPoints));
  std::vector<Point> out;
  for (const ordered_json& item : json) out.push_back(position_of(item, place));
  return out;
}

std::string name_of(const JsonInput& input, const char* key) {
  std::string out = input.text_or_none(key);
  if (out.size() > kLongestName)
    throw bad_input(
        fmt::format("{} is longer than {} letters; choose a shorter one", input.place_of(key), kLongestName));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c >= 0 && c < ' '; }, ' ');
  return out;
}

}  // namespace tramline::server
