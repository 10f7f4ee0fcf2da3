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

}  // namespace tramline
