#include "tramline/model/work_log.h"

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

}  // namespace tramline
