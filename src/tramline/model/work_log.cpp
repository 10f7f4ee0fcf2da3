#include "tramline/model/work_log.h"

#include <cmath>
#include <utility>

namespace tramline {

const char* name(AmountUnit unit) {
  switch (unit) {
    case AmountUnit::kLitres:
      return "l";
    case AmountUnit::kKilograms:
      return "kg";
    case AmountUnit::kSeeds:
      return "seeds";
    case AmountUnit::kUnknown:
      break;
  }
  return "";
}

void SkippedRecords::add(std::size_t record, std::string why) {
  ++count;
  if (listed.size() < kListed) listed.push_back({record, std::move(why)});
}

void SkippedRecords::add(const SkippedRecords& others) {
  count += others.count;
  for (const SkippedRecord& other : others.listed)
    if (listed.size() < kListed) listed.push_back(other);
}

bool MachineCounters::any() const {
  return !(std::isnan(area_m2) && std::isnan(distance_m) && std::isnan(seconds));
}

void MachineCounters::add(const MachineCounters& next) {
  for (double MachineCounters::*counter :
       {&MachineCounters::area_m2, &MachineCounters::distance_m, &MachineCounters::seconds})
    if (std::isnan(this->*counter))
      this->*counter = next.*counter;
    else if (!std::isnan(next.*counter))
      this->*counter += next.*counter;
}

}  // namespace tramline
