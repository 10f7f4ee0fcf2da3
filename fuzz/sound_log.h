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
    demand(fix.shape >= -1 && fix.shape < static_cast<int>(log.shapes.size()));
    demand(!std::isinf(fix.rate_per_ha) && !(fix.rate_per_ha < 0));
    const double heading = fix.heading.degrees();
    demand(std::isnan(heading) || (heading >= 0 && heading < 360));
  }
  for (const Boom& boom : log.booms)
    for (const Section& section : boom)
      demand(std::isfinite(section.left_m) && std::isfinite(section.right_m) &&
             section.left_m >= section.right_m);
  for (const double counted : {log.counters.area_m2, log.counters.distance_m, log.counters.seconds})
    demand(std::isnan(counted) || (counted >= 0 && std::isfinite(counted)));
  demand(log.skipped.count >= log.skipped.listed.size());
}

}  // namespace tramline::fuzz
