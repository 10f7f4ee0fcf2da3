#include "tramline/io/isoxml/logged_rate.h"

#include <fmt/format.h>

#include <algorithm>

namespace tramline::io {
namespace {

bool is_rate(unsigned identifier) {
  return identifier == ddi::kVolumeRate || identifier == ddi::kMassRate || identifier == ddi::kCountRate;
}

/// To amounts a hectare: ISO 11783-11 has 0.01 mm³/m², 1 mg/m² and 0.001 pieces/m².
double rate_factor(unsigned identifier) {
  if (identifier == ddi::kVolumeRate) return 1e-4;
  return identifier == ddi::kMassRate ? 0.01 : 10;
}

}  // namespace

LoggedRate::LoggedRate(const TimeLogHeader& header, const std::vector<DeviceElement>& elements) {
  std::vector<std::size_t> rates, of_machine;
  for (std::size_t i = 0; i < header.values.size(); ++i) {
    if (!is_rate(header.values[i].ddi)) continue;
    rates.push_back(i);
    if (std::any_of(elements.begin(), elements.end(),
                    [&](const DeviceElement& element) { return element.id == header.values[i].element; }))
      of_machine.push_back(i);
  }
  if (!of_machine.empty()) rates = of_machine;
  if (rates.empty()) return;
  const LoggedValue& chosen = header.values[rates.front()];
  ddi_ = chosen.ddi;
  if (chosen.fixed)
    value_ = static_cast<double>(*chosen.fixed);
  else
    index_ = rates.front();
  if (rates.size() > 1)
    note_ = fmt::format("{} applied rates are logged: that of {} counts", rates.size(), chosen.element);
}

void LoggedRate::update(const TimeLogRecord& record) {
  if (!index_) return;
  for (const auto& [index, value] : record.values)
    if (index == *index_) value_ = value;
}

double LoggedRate::per_ha() const {
  if (!value_ || *value_ < 0) return std::numeric_limits<double>::quiet_NaN();
  return *value_ * rate_factor(ddi_);
}

AmountUnit LoggedRate::unit() const {
  if (ddi_ == 0) return AmountUnit::kUnknown;
  if (ddi_ == ddi::kVolumeRate) return AmountUnit::kLitres;
  return ddi_ == ddi::kMassRate ? AmountUnit::kKilograms : AmountUnit::kSeeds;
}

}  // namespace tramline::io
