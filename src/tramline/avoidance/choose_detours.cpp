#include "tramline/avoidance/choose_detours.h"

#include <utility>

#include "tramline/avoidance/choice/detour_decisions.h"
#include "tramline/avoidance/least_cost_with_detours.h"
#include "tramline/cost/strip_tally.h"
#include "tramline/cost/worked/detour_cover.h"

namespace tramline {
namespace {

/// The tracks as decided at present.
Avoided as_decided(const AvoidanceTask& task, const DetourDecisions& decisions) {
  Avoided out;
  out.tracks = decisions.tracks();
  settle_cost(task, out);
  return out;
}

Avoided paper_plan(const AvoidanceTask& task, const Avoided& cut, DetourDecisions& decisions) {
  decisions.allow(WaysPast::kPaper);
  return decisions.choose_paper_ways() ? as_decided(task, decisions) : cut;
}

/// The better of a plan and its improvement track by track.
Avoided improved(const AvoidanceTask& task, Avoided start, WaysPast ways, DetourDecisions& decisions) {
  decisions.allow(ways);
  decisions.choose_from(start.tracks);
  if (!decisions.improve()) return start;
  Avoided out = as_decided(task, decisions);
  return is_better(out, start) ? out : start;
}

Avoided decided(const AvoidanceTask& task, Avoided cut, DetourDecisions& decisions) {
  Avoided paper = paper_plan(task, cut, decisions);
  if (task.settings.avoid == Avoidance::kPaper) return paper;
  Avoided own = improved(task, std::move(cut), WaysPast::kOwn, decisions);
  return is_better(paper, own) ? improved(task, std::move(paper), WaysPast::kBoth, decisions) : own;
}

}  // namespace

void settle_cost(const AvoidanceTask& task, Avoided& avoided) {
  const double by_detours_m2 = covered_by_detours_m2(task.ground.body, task.families, avoided.tracks);
  avoided.tally = tally_of(task.subfields, avoided.tracks, task.body_m2, by_detours_m2);
  avoided.cost = cost(task.objective, avoided.tally);
}

bool is_better(const Avoided& a, const Avoided& b) {
  const bool a_works = a.tally.pieces > 0, b_works = b.tally.pieces > 0;
  return a_works != b_works ? a_works : a.cost < b.cost;
}

Avoided choose_detours(const AvoidanceTask& task) {
  Avoided cut = all_cut(task);
  if (task.settings.avoid == Avoidance::kCut || !meets_obstacles(task)) return cut;
  DetourDecisions decisions(task);
  Avoided out = decided(task, std::move(cut), decisions);
  out.ways = decisions.ways();
  out.decisions = std::move(decisions).decisions();
  return out;
}

std::vector<PlacedEncounter> encounters_in(const AvoidanceTask& task, const Avoided& avoided) {
  DetourDecisions decisions =
      avoided.decisions.empty() ? DetourDecisions(task) : DetourDecisions(task, avoided.decisions);
  decisions.allow(avoided.ways);
  decisions.choose_from(avoided.tracks);
  return decisions.encounters();
}

}  // namespace tramline
