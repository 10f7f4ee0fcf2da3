#pragma once
// What holds for every log that a reader gives out, whatever it was fed with.

#include <cmath>
#include <cstdlib>

#include "tramline/model/work_log.h"

namespace tramline::fuzz {

inline void demand(bool holds) {
  if (!holds) std::abort();
}

inline void demand_sound(const WorkLog& log) {
  for (const Fix& fix : log.fixes) {
    demand(std::isfinite(fix.position.x) && std::isfinite(fix.position.y));
    demand(log.positions == Positions::kLocal ||
           (std::abs(fix.position.x) <= 180 && std::abs(fix.position.y) <= 90));
    demand(fix.boom >= -1 && fix.boom < static_cast<int>(log.booms.size()));
    demand(fix.unit >= 0 && fix.record > 0);
    const double heading = fix.heading.degrees();
    demand(std::isnan(heading) || (heading >= 0 && heading < 360));
  }
  for (const Boom& boom : log.booms)
    for (const Section& section : boom) demand(section.left_m >= section.right_m);
  demand(log.skipped.count >= log.skipped.listed.size());
}

}  // namespace tramline::fuzz
