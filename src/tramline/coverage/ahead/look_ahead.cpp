#include "tramline/coverage/ahead/look_ahead.h"

#include <algorithm>
#include <cassert>

namespace tramline::coverage {
namespace {

/// A machine that stands looks this far ahead: what it stands over.
constexpr double kLeastReach_m = 0.1;

bool within_outline(const Region& field, Point p) {
  return std::any_of(field.begin(), field.end(),
                     [&](const Polygon& polygon) { return contains(polygon.outer, p); });
}

Over over_at(Point p, const Region& field, double need) {
  if (!field.empty() && !contains(field, p))
    return within_outline(field, p) ? Over::kObstacle : Over::kOutside;
  return need >= 0.5 ? Over::kOpen : Over::kWorked;
}

double share_at(const Need& need, double ahead_m) {
  const auto after = std::find_if(need.begin(), need.end(),
                                  [&](const NeedStretch& stretch) { return stretch.to_m > ahead_m; });
  return after == need.end() ? 0 : after->at(ahead_m);
}

}  // namespace

const char* name(Over over) {
  switch (over) {
    case Over::kOpen:
      return "open";
    case Over::kWorked:
      return "worked";
    case Over::kOutside:
      return "outside";
    case Over::kObstacle:
      return "obstacle";
  }
  return "";
}

std::vector<SectionAhead> look_ahead(const TileCoverage& coverage, const Region& field, const Motion& motion,
                                     const Boom& boom, const std::vector<SectionState>& states,
                                     const SwitchRule& rule) {
  assert(states.size() == boom.size());
  const double reach_m = std::max(kLeastReach_m, motion.speed_mps * rule.horizon_s);
  const std::vector<Need> needs = need_ahead(coverage, motion, boom, reach_m);
  const Point ahead = motion.heading.unit(), left{-ahead.y, ahead.x};
  std::vector<SectionAhead> out;
  for (std::size_t i = 0; i < boom.size(); ++i) {
    const double middle_m = 0.5 * (boom[i].left_m + boom[i].right_m);
    const auto over = [&](double ahead_m) {
      const double there_m = ahead_m + kUnderfoot_m;
      return over_at(motion.position + there_m * ahead + middle_m * left, field, share_at(needs[i], there_m));
    };
    SectionAhead section;
    section.on = states[i].on;
    section.need = share_at(needs[i], kUnderfoot_m);
    section.over = over(0);
    section.next = next_switch(needs[i], motion.speed_mps, states[i], rule);
    section.next_over = section.next ? over(section.next->ahead_m) : section.over;
    out.push_back(section);
  }
  return out;
}

}  // namespace tramline::coverage
