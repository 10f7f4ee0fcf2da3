#pragma once
// JSON of a request as values, with a sentence for every fault.

#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline::server {

/// An object of a request. Every function throws bad_input, one sentence that names the value:
/// "machine.width_m has to be a number". Keeps a reference to the JSON.
class JsonInput {
 public:
  /// `place`: what comes before the keys in messages: "machine"; empty for the body itself. Throws where the
  /// JSON is no object, or has a key that is not among `known`: nothing that was asked for is passed over.
  JsonInput(const nlohmann::ordered_json& json, std::string place, std::initializer_list<const char*> known)
      : JsonInput(json, std::move(place), std::span(known.begin(), known.size())) {}
  JsonInput(const nlohmann::ordered_json& json, std::string place, std::span<const char* const> known);

  /// False for null too.
  bool has(const char* key) const;
  double number(const char* key) const;
  std::optional<double> number_if(const char* key) const;
  /// A whole number.
  std::optional<long long> whole_if(const char* key) const;
  std::string text(const char* key) const;
  /// Empty where it is not there.
  std::string text_or_none(const char* key) const;
  std::optional<bool> flag_if(const char* key) const;
  /// null where it is not there.
  const nlohmann::ordered_json& value(const char* key) const;
  /// An empty list where it is not there.
  const nlohmann::ordered_json& list(const char* key) const;
  /// For messages: "machine.width_m".
  std::string place_of(const char* key) const;

 private:
  const nlohmann::ordered_json& json_;
  std::string place_;
};

/// [longitude, latitude]
Point position_of(const nlohmann::ordered_json& json, const std::string& place);
/// A list of positions.
std::vector<Point> positions_of(const nlohmann::ordered_json& json, const std::string& place);

/// A name for people, at most 200 bytes of UTF-8 in one line. Throws bad_input for what is longer.
std::string name_of(const JsonInput& input, const char* key);

}  // namespace tramline::server
