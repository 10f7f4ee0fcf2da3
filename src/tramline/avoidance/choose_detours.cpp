#include "tramline/avoidance/choose_detours.h"

#include "tramline/avoidance/detour_decisions.h"
#include "tramline/avoidance/least_with_detours.h"
#include "tramline/cost/detour_cover.h"
#include "tramline/cost/strip_tally.h"

namespace tramline {
namespace {

Avoided tallied(const AvoidanceTask& task, std::vector<LaidTracks> tracks, WaysPast ways) {
  Avoided out{std::move(tracks), {}, 0, ways};
  const double by_detours_m2 = covered_by_detours_m2(task.ground.body, task.families, out.tracks);
  out.tally = tally_of(task.subfields, out.tracks, task.body_m2, by_detours_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

Avoided the_papers(const AvoidanceTask& task, Avoided cut) {
  DetourDecisions decisions(task, WaysPast::kPaper);
  if (!decisions.take_paper_ways()) {
    cut.ways = WaysPast::kPaper;
    return cut;
  }
  return tallied(task, decisions.tracks(), WaysPast::kPaper);
}

/// The better of a plan and what comes of it track by track.
Avoided improved(const AvoidanceTask& task, Avoided start, WaysPast ways) {
  // What stays as it was has been chosen from them, too.
  start.ways = ways;
  DetourDecisions decisions(task, ways);
  decisions.take_from(start.tracks);
  if (!decisions.improve()) return start;
  Avoided out = tallied(task, decisions.tracks(), ways);
  return is_better(out, start) ? out : start;
}

}  // namespace

bool is_better(const Avoided& a, const Avoided& b) {
  const bool a_works = a.tally.pieces > 0, b_works = b.tally.pieces > 0;
  return a_works != b_works ? a_works : a.cost < b.cost;
}

Avoided choose_detours(const AvoidanceTask& task) {
  Avoided cut = all_cut(task);
  if (task.settings.avoid == Avoidance::kCut) return cut;
  if (!meets_obstacles(task)) return cut;
  Avoided paper = the_papers(task, cut);
  if (task.settings.avoid == Avoidance::kPaper) return paper;
  Avoided own = improved(task, std::move(cut), WaysPast::kOwn);
  return is_better(paper, own) ? improved(task, std::move(paper), WaysPast::kBoth) : own;
}

std::vector<PlacedEncounter> encounters_in(const AvoidanceTask& task, const Avoided& avoided) {
  DetourDecisions decisions(task, avoided.ways);
  decisions.take_from(avoided.tracks);
  return decisions.encounters();
}

}  // namespace tramline
