#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tramline/io/mission/route_texts.h"

namespace tramline::io {
namespace {

using nlohmann::ordered_json;

/// "1e-05" is a text to YAML 1.1: it takes no number without a point.
std::string number_text(double value) {
  std::string out = fmt::format("{}", value);
  const std::size_t exponent = out.find('e');
  const std::string digits = out.substr(0, exponent);
  const std::string rest = exponent == std::string::npos ? "" : out.substr(exponent);
  return digits.find('.') == std::string::npos ? digits + ".0" + rest : out;
}

std::string scalar(const ordered_json& json) {
  return json.is_number_float() ? number_text(json.get<double>())
                                : json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

bool has_parts(const ordered_json& json) { return json.is_structured() && !json.empty(); }

void append(const ordered_json& json, std::size_t depth, std::string& out);

/// Behind "key:" or "-".
void append_value(const ordered_json& json, std::size_t depth, std::string& out) {
  if (!has_parts(json)) {
    out += " " + scalar(json) + "\n";
    return;
  }
  out += "\n";
  append(json, depth, out);
}

void append(const ordered_json& json, std::size_t depth, std::string& out) {
  const std::string indent(2 * depth, ' ');
  for (const auto& item : json.items()) {
    out += indent + (json.is_object() ? item.key() + ":" : "-");
    append_value(item.value(), depth + 1, out);
  }
}

}  // namespace

std::string yaml_text(const ordered_json& json) {
  if (!has_parts(json)) return scalar(json) + "\n";
  std::string out;
  append(json, 0, out);
  return out;
}

}  // namespace tramline::io
