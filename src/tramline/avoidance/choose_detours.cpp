#include "tramline/avoidance/choose_detours.h"

#include <algorithm>

#include "tramline/avoidance/detour_decisions.h"
#include "tramline/cost/detour_cover.h"
#include "tramline/cost/strip_tally.h"

namespace tramline {
namespace {

Avoided tallied(const AvoidanceTask& task, std::vector<SubfieldTracks> tracks) {
  Avoided out{std::move(tracks), {}, 0};
  const double by_detours_m2 = covered_by_detours_m2(task.ground.body, out.tracks);
  out.tally = tally_of(task.subfields, out.tracks, task.body_m2, by_detours_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

Avoided all_cut(const AvoidanceTask& task) {
  std::vector<SubfieldTracks> tracks;
  for (const Strips& strips : task.strips) tracks.push_back(cut_pieces(strips, min_length_m(task.machine)));
  return tallied(task, std::move(tracks));
}

}  // namespace

Avoided choose_detours(const AvoidanceTask& task) {
  Avoided cut = all_cut(task);
  if (task.settings.avoid == Avoidance::kCut) return cut;
  DetourDecisions decisions(task);
  if (decisions.nothing_to_decide()) return cut;
  const bool paper_differs = decisions.take_paper_ways();
  if (task.settings.avoid == Avoidance::kPaper)
    return paper_differs ? tallied(task, decisions.tracks()) : cut;

  Avoided start = std::move(cut);
  if (paper_differs) {
    Avoided paper = tallied(task, decisions.tracks());
    if (paper.cost < start.cost)
      start = std::move(paper);
    else
      decisions.cut_all();
  }
  if (!decisions.improve()) return start;
  Avoided improved = tallied(task, decisions.tracks());
  return improved.cost < start.cost ? improved : start;
}

std::vector<Encounter> encounters_in(const AvoidanceTask& task, const Avoided& avoided) {
  DetourDecisions decisions(task);
  decisions.take_from(avoided.tracks);
  return decisions.encounters();
}

}  // namespace tramline
