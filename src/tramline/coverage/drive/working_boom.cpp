#include "tramline/coverage/drive/working_boom.h"

#include <algorithm>

namespace tramline::coverage {
namespace {

bool works(const Fix& fix, std::size_t section, WorkState unknown_work) {
  if (fix.work == WorkState::kOff) return false;
  if (fix.has_sections) return section < kMostSections && fix.sections[section];
  return (fix.work == WorkState::kUnknown ? unknown_work : fix.work) == WorkState::kOn;
}

}  // namespace

Boom working_boom(const Fix& fix, const Boom& boom, WorkState unknown_work) {
  Boom out;
  for (std::size_t i = 0; i < boom.size(); ++i) {
    if (!works(fix, i, unknown_work) || !(boom[i].left_m > boom[i].right_m)) continue;
    const bool adjacent = !out.empty() && out.back().right_m - boom[i].left_m <= kAdjacent_m;
    if (adjacent)
      out.back().right_m = std::min(out.back().right_m, boom[i].right_m);
    else
      out.push_back(boom[i]);
  }
  return out;
}

}  // namespace tramline::coverage
