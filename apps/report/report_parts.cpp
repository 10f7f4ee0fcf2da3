#include "report/report_parts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "request/field_key.h"
#include "tramline/model/plain_zero.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::app {

using nlohmann::ordered_json;

namespace {

ordered_json with_plain_zeros(ordered_json json) {
  if (json.is_number_float()) return plain_zero(json.get<double>());
  if (json.is_structured())
    for (ordered_json& item : json) item = with_plain_zeros(std::move(item));
  return json;
}

}  // namespace

std::string json_text(const ordered_json& json, int indent) {
  return with_plain_zeros(json).dump(indent, ' ', false, ordered_json::error_handler_t::replace);
}

std::string json_line(const ordered_json& json) { return json_text(json, -1); }

ordered_json versioned(const ordered_json& result) {
  ordered_json out{{"format_version", kJsonVersion}};
  out.update(result);
  return out;
}

ordered_json number_json(double value) { return std::isfinite(value) ? ordered_json(value) : ordered_json(); }

ordered_json repairs_json(const std::vector<Repair>& repairs) {
  ordered_json out = ordered_json::array();
  for (const Repair& repair : repairs)
    out.push_back({{"what", repair.what},
                   {"where", repair.where},
                   {"x", repair.at.x},
                   {"y", repair.at.y},
                   {"area_change_m2", repair.area_change_m2}});
  return out;
}

ordered_json skipped_json(const std::vector<Skipped>& skipped) {
  ordered_json out = ordered_json::array();
  for (const Skipped& item : skipped)
    out.push_back({{"what", item.what}, {"where", item.where}, {"why", item.why}});
  return out;
}

ordered_json with_field_names(const Field& field, const ordered_json& result) {
  const FieldSource& source = field.source;
  ordered_json out{{"field_id", field.id},  {"key", field_key(field)}, {"file", source.file},
                   {"layer", source.layer}, {"feature", source.fid},   {"part", source.part}};
  out.update(result);
  return out;
}

ordered_json refusal_json(const std::string& file, const std::string& layer, const Refusal& refusal) {
  return {{"field_id", refusal.field_id},
          {"key", field_key(layer, refusal.fid)},
          {"file", file},
          {"layer", layer},
          {"feature", refusal.fid},
          {"error", refusal.sentence}};
}

std::string skipped_rows(const std::vector<Skipped>& skipped) {
  std::string out;
  for (const Skipped& item : skipped)
    fmt::format_to(std::back_inserter(out), "skipped      {} ({}): {}\n", item.what, item.where, item.why);
  return out;
}

std::string note_rows(const std::vector<std::string>& warnings) {
  std::string out;
  for (const std::string& warning : warnings) out += fmt::format("note         {}\n", warning);
  return out;
}

std::string csv_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

std::string directions_text(const std::vector<Direction>& directions, std::size_t most) {
  std::vector<std::string> texts;
  for (const Direction& direction : directions) {
    std::string text = fmt::format("{:.2f}°", direction.degrees());
    if (std::find(texts.begin(), texts.end(), text) == texts.end()) texts.push_back(std::move(text));
  }
  const bool all = texts.size() <= most;
  if (!all) texts.resize(most);
  return fmt::format("{}{}", fmt::join(texts, ", "), all ? "" : ", …");
}

std::string prices_text(const Objective& prices) {
  return fmt::format("{:g}·overlap + {:g}·uncovered + {:g}·turns + {:g}·stops + {:g}·further subfields",
                     prices.overlap, prices.uncovered, prices.turn, prices.stop, prices.subfield);
}

ordered_json turning_json(const Turning& turning) {
  ordered_json out{{kReverseKey, turning.reverse}, {kImplementKey, name(turning.implement)}};
  for (const TurningNumber& number : kTurningNumbers) out[number.key] = turning.*number.value;
  return out;
}

ordered_json given_rates_json(const Rates& rates) {
  ordered_json out{{kOperationKey, name(rates.operation)}};
  for (const RateNumber& number : kRateNumbers)
    if (rates.*number.value >= 0) out[number.key] = rates.*number.value;
  return out;
}

ordered_json weights_json(const Objective& prices) {
  return {{"overlap", prices.overlap},
          {"uncovered", prices.uncovered},
          {"turn", prices.turn},
          {"stop", prices.stop},
          {"subfield", prices.subfield}};
}

}  // namespace tramline::app
