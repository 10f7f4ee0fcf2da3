#include "tramline/io/machine/machine_table.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "tramline/geometry/error.h"
#include "tramline/io/geopackage/rows.h"
#include "tramline/io/geopackage/table.h"
#include "tramline/io/geopackage/write_geopackage.h"
#include "tramline/model/rate_values.h"
#include "tramline/model/turning_values.h"

namespace tramline::io {
namespace {

constexpr FileKind kMachineFile{"list of machines", "tramline serve"};
constexpr const char* kTable = "machines";
// Files from before there were such values lack the columns.
constexpr const char* kTurning = "turning";
constexpr const char* kRates = "rates";

std::string turning_text(const Turning& turning) {
  nlohmann::ordered_json out{{kReverseKey, turning.reverse}, {kImplementKey, name(turning.implement)}};
  for (const TurningNumber& number : kTurningNumbers) out[number.key] = turning.*number.value;
  return out.dump();
}

Turning turning_from_text(const std::string& text, const std::string& place) {
  Turning out;
  try {
    const auto json = nlohmann::json::parse(text);
    out.reverse = json.at(kReverseKey).get<bool>();
    const auto coupling = coupling_named(json.at(kImplementKey).get<std::string>());
    if (!coupling) throw bad_input(fmt::format("{}: implement is neither mounted nor towed", place));
    out.implement = *coupling;
    for (const TurningNumber& number : kTurningNumbers) out.*number.value = json.at(number.key).get<double>();
  } catch (const nlohmann::json::exception&) {
    throw bad_input(
        fmt::format("{}: it is '{}', expected a JSON object of all values for turning", place, text));
  }
  if (const std::string fault = turning_fault(out); !fault.empty())
    throw bad_input(fmt::format("{}: {}", place, fault));
  return out;
}

std::string rates_text(const Rates& rates) {
  nlohmann::ordered_json out{{kOperationKey, name(rates.operation)}};
  for (const RateNumber& number : kRateNumbers)
    if (rates.*number.value >= 0) out[number.key] = rates.*number.value;
  return out.dump();
}

Rates rates_from_text(const std::string& text, const std::string& place) {
  Rates out;
  try {
    const auto json = nlohmann::json::parse(text);
    const auto operation = operation_named(json.at(kOperationKey).get<std::string>());
    if (!operation) throw bad_input(fmt::format("{}: operation is none of {}", place, operation_words()));
    out.operation = *operation;
    for (const RateNumber& number : kRateNumbers)
      if (json.contains(number.key)) out.*number.value = json.at(number.key).get<double>();
  } catch (const nlohmann::json::exception&) {
    throw bad_input(fmt::format("{}: it is '{}', expected a JSON object of rates", place, text));
  }
  if (const std::string fault = rates_fault(out); !fault.empty())
    throw bad_input(fmt::format("{}: {}", place, fault));
  return out;
}

}  // namespace

void write_machines(const std::vector<ListedMachine>& machines, const std::filesystem::path& path) {
  write_geopackage(path, kMachineFile, LocalFrame{}, [&](const Target& target) {
    Table table(target.file, kTable, wkbNone, nullptr,
                {text("id"), text("name"), real("width_m"), real("radius_m"), real("min_length_m"),
                 text(kTurning), text(kRates)});
    for (const auto& [id, machine] : machines)
      table.add(nullptr, {id, machine.name, machine.width_m, machine.radius_m,
                          machine.min_length_m >= 0 ? Cell(machine.min_length_m) : Cell(),
                          machine.turning == Turning{} ? "" : turning_text(machine.turning),
                          machine.rates == Rates{} ? "" : rates_text(machine.rates)});
  });
}

std::vector<ListedMachine> read_machines(const std::filesystem::path& path) {
  GdalErrors errors;
  Rows file(path, kMachineFile, errors);
  std::vector<ListedMachine> out;
  file.each(kTable, [&](const Row& row) {
    Machine machine{row.text("name"), row.number("width_m"), row.number("radius_m")};
    machine.min_length_m = row.number_if_any("min_length_m").value_or(machine.min_length_m);
    if (row.has(kTurning) && !row.text(kTurning).empty())
      machine.turning = turning_from_text(row.text(kTurning), row.place_of(kTurning));
    if (row.has(kRates) && !row.text(kRates).empty())
      machine.rates = rates_from_text(row.text(kRates), row.place_of(kRates));
    out.push_back({row.text("id"), machine});
  });
  return out;
}

}  // namespace tramline::io
