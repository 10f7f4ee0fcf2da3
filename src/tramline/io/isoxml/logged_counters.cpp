#include "tramline/io/isoxml/logged_counters.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline::io {
namespace {

bool is_counter(unsigned identifier) {
  return identifier == ddi::kTotalArea || identifier == ddi::kTotalDistance || identifier == ddi::kTotalTime;
}

}  // namespace

LoggedCounters::LoggedCounters(const TimeLogHeader& header, const std::vector<DeviceElement>& elements) {
  std::map<std::size_t, Counter> of_any;
  for (std::size_t i = 0; i < header.values.size(); ++i) {
    const LoggedValue& logged = header.values[i];
    if (!is_counter(logged.ddi) || logged.fixed) continue;
    of_any[i].ddi = logged.ddi;
    if (std::any_of(elements.begin(), elements.end(),
                    [&](const DeviceElement& element) { return element.id == logged.element; }))
      counters_[i].ddi = logged.ddi;
  }
  if (counters_.empty()) counters_ = of_any;
}

void LoggedCounters::update(const TimeLogRecord& record) {
  for (const auto& [index, value] : record.values)
    if (const auto at = counters_.find(index); at != counters_.end()) at->second.total.add(value);
}

double LoggedCounters::largest(unsigned identifier) const {
  double out = std::numeric_limits<double>::quiet_NaN();
  for (const auto& [index, counter] : counters_)
    if (counter.ddi == identifier) out = std::fmax(out, counter.total.total());
  return out;
}

MachineCounters LoggedCounters::totals() const {
  constexpr double kMillimetre = 1e-3;
  return {largest(ddi::kTotalArea), kMillimetre * largest(ddi::kTotalDistance), largest(ddi::kTotalTime)};
}

}  // namespace tramline::io
