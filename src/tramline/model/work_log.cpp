#include "tramline/model/work_log.h"

#include <utility>

namespace tramline {

void SkippedRecords::add(std::size_t record, std::string why) {
  ++count;
  if (listed.size() < kListed) listed.push_back({record, std::move(why)});
}

}  // namespace tramline
