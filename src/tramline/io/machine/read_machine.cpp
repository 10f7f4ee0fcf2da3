#include "tramline/io/machine/read_machine.h"

#include <fmt/format.h>

#include <toml++/toml.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/machine/read_flight.h"
#include "tramline/model/limits.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::io {
namespace {

constexpr std::array<const char*, 4> kKeys = {"name", "width_m", "turning_radius_m", "min_track_length_m"};
// Far above any machine file: what is longer is something else.
constexpr std::size_t kLargestFile = 1 << 20;
// Each dot of a key is a table within a table, and tables are taken apart by a call for each.
constexpr std::ptrdiff_t kMostDots = 64;

struct Source {
  std::string file;
  toml::table table;
};

std::string text_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string text(kLargestFile + 1, '\0');
  file.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (file.bad() || (!file.eof() && file.fail()))
    throw bad_input(fmt::format("machine file {}: it cannot be read", path.string()));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (text.size() > kLargestFile)
    throw bad_input(fmt::format("machine file {}: it is too long for a machine file", path.string()));
  return text;
}

/// Looked at before the text is parsed. Lines end where TOML++ ends them; a comment may be full of dots.
void refuse_deep_keys(std::string_view text, const std::filesystem::path& path) {
  for (int line = 1; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find_first_of("\n\v\f\r"), text.size());
    const std::string_view row = text.substr(0, end);
    const bool comment = row.substr(std::min(row.find_first_not_of(" \t"), row.size())).starts_with('#');
    if (!comment && std::count(row.begin(), row.end(), '.') > kMostDots)
      throw bad_input(fmt::format(
          "machine file {}, line {}: it has more than {} dots; a machine file has no nested tables",
          path.string(), line, kMostDots));
    text.remove_prefix(std::min(end + (text.substr(end).starts_with("\r\n") ? 2 : 1), text.size()));
  }
}

Source parse(const std::filesystem::path& path) {
  const std::string text = text_of(path);
  refuse_deep_keys(text, path);
  try {
    return {path.string(), toml::parse(text)};
  } catch (const toml::parse_error& error) {
    throw bad_input(fmt::format("machine file {}, line {}: it is not valid TOML ({})", path.string(),
                                error.source().begin.line, error.description()));
  }
}

[[noreturn]] void refuse(const Source& source, const toml::source_region& place, const std::string& what) {
  throw bad_input(fmt::format("machine file {}, line {}: {}", source.file, place.begin.line, what));
}

std::vector<std::string_view> known_keys() {
  std::vector<std::string_view> out(kKeys.begin(), kKeys.end());
  out.insert(out.end(), {kReverseKey, kImplementKey, kOperationKey});
  for (const TurningNumber& number : kTurningNumbers) out.emplace_back(number.key);
  for (const RateNumber& number : kRateNumbers) out.emplace_back(number.key);
  out.insert(out.end(), kFlightKeys.begin(), kFlightKeys.end());
  return out;
}

void refuse_unknown_keys(const Source& source) {
  const std::vector<std::string_view> known = known_keys();
  for (const auto& [key, value] : source.table)
    if (std::find(known.begin(), known.end(), key.str()) == known.end())
      refuse(source, key.source(),
             fmt::format("{} is no key of a machine; known are {}", key.str(), fmt::join(known, ", ")));
}

std::optional<double> length_m(const Source& source, std::string_view key, bool zero_allowed) {
  const toml::node* node = source.table.get(key);
  if (node == nullptr) return std::nullopt;
  if (!node->is_number()) refuse(source, node->source(), fmt::format("{} must be a number of metres", key));
  const double value = node->value<double>().value_or(std::nan(""));
  if (!(value >= 0 && value <= kFarthest_m) || (value == 0 && !zero_allowed))
    refuse(source, node->source(),
           fmt::format("{} is {:g}, but must be a length {} 0 m and at most {} m", key, value,
                       zero_allowed ? "of at least" : "above", kFarthest_m));
  return value;
}

/// A number of Turning or of Rates.
template <class Number, class Values>
void take_number(const Source& source, const Number& number, Values& values) {
  const toml::node* node = source.table.get(number.key);
  if (node == nullptr) return;
  if (!node->is_number()) refuse(source, node->source(), fmt::format("{} must be a number", number.key));
  const double value = node->value<double>().value_or(std::nan(""));
  if (const std::string fault = fault_of(number, value); !fault.empty())
    refuse(source, node->source(), fmt::format("{} {}", number.key, fault));
  values.*number.value = value;
}

void take_reverse(const Source& source, Turning& turning) {
  const toml::node* node = source.table.get(kReverseKey);
  if (node == nullptr) return;
  if (!node->is_boolean()) refuse(source, node->source(), "reverse must be true or false, without quotes");
  turning.reverse = node->value<bool>().value_or(false);
}

/// How the implement is coupled, and that its drawbar goes with that.
void take_implement(const Source& source, Turning& turning) {
  const toml::node* node = source.table.get(kImplementKey);
  if (node != nullptr) {
    const auto coupling = coupling_named(node->value<std::string>().value_or(""));
    if (!coupling)
      refuse(source, node->source(), "implement must be \"mounted\" or \"towed\", with the quotes");
    turning.implement = *coupling;
  }
  const std::string fault = drawbar_fault(turning);
  if (fault.empty()) return;
  const toml::node* drawbar = source.table.get(kDrawbarKey);
  refuse(source, (drawbar != nullptr ? drawbar : node)->source(), fmt::format("{} {}", kDrawbarKey, fault));
}

Rates rates_in(const Source& source) {
  Rates out;
  if (const toml::node* node = source.table.get(kOperationKey)) {
    const auto operation = operation_named(node->value<std::string>().value_or(""));
    if (!operation)
      refuse(source, node->source(),
             fmt::format("operation must be one of these, in quotes: {}", operation_words()));
    out.operation = *operation;
  }
  for (const RateNumber& number : kRateNumbers) take_number(source, number, out);
  return out;
}

Turning turning_in(const Source& source, Operation operation) {
  Turning out;
  out.working_speed_mps = usual_speed_mps(operation);
  take_reverse(source, out);
  for (const TurningNumber& number : kTurningNumbers) take_number(source, number, out);
  take_implement(source, out);
  return out;
}

/// A number between two limits; nullopt where the key is missing.
std::optional<double> number_within(const Source& source, const char* key, double least, double most) {
  const toml::node* node = source.table.get(key);
  if (node == nullptr) return std::nullopt;
  const double value = node->is_number() ? node->value<double>().value_or(std::nan("")) : std::nan("");
  if (!(value >= least && value <= most))
    refuse(source, node->source(), fmt::format("{} must be a number from {:g} to {:g}", key, least, most));
  return value;
}

Landing landing_in(const Source& source) {
  const toml::node* node = source.table.get("landing");
  if (node == nullptr) return Landing::kHome;
  const std::string word = node->value<std::string>().value_or("");
  if (word != "home" && word != "end")
    refuse(source, node->source(), "landing must be \"home\" or \"end\", with the quotes");
  return word == "home" ? Landing::kHome : Landing::kEnd;
}

}  // namespace

std::optional<Flight> read_flight(const std::filesystem::path& path) {
  constexpr double kLowest_m = 0.5, kHighest_m = 1500, kServos = 32;
  const Source source = parse(path);
  refuse_unknown_keys(source);
  Flight out;
  out.landing = landing_in(source);
  if (const auto servo = number_within(source, "spray_servo", 1, kServos)) {
    if (*servo != std::floor(*servo))
      refuse(source, source.table.get("spray_servo")->source(), "spray_servo must be a whole number");
    out.spray_servo = static_cast<int>(*servo);
  }
  const auto altitude = number_within(source, "flight_altitude_m", kLowest_m, kHighest_m);
  const auto takeoff = number_within(source, "takeoff_altitude_m", kLowest_m, kHighest_m);
  if (!altitude) return std::nullopt;
  out.altitude_m = *altitude;
  out.takeoff_altitude_m = takeoff.value_or(*altitude);
  return out;
}

Machine read_machine(const std::filesystem::path& path) {
  const Source source = parse(path);
  refuse_unknown_keys(source);
  Machine machine;
  if (const toml::node* name = source.table.get("name")) {
    if (!name->is_string()) refuse(source, name->source(), "name must be a text in quotes");
    machine.name = name->value<std::string>().value_or("");
  }
  const auto width = length_m(source, "width_m", false);
  if (!width)
    throw bad_input(fmt::format("machine file {}: width_m, the working width, is missing", source.file));
  machine.width_m = *width;
  machine.radius_m = length_m(source, "turning_radius_m", true).value_or(machine.radius_m);
  machine.min_length_m = length_m(source, "min_track_length_m", true).value_or(machine.min_length_m);
  machine.rates = rates_in(source);
  machine.turning = turning_in(source, machine.rates.operation);
  return machine;
}

}  // namespace tramline::io
