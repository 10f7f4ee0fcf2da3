#include "tramline/avoidance/choose_curved_detours.h"

#include <algorithm>

#include "tramline/avoidance/curved_decisions.h"
#include "tramline/cost/curved_tally.h"

namespace tramline {
namespace {

CurvedAvoided tallied(const CurvedAvoidanceTask& task, std::vector<std::vector<TrackDetour>> detours) {
  const double width_m = task.machine.width_m, least_m = min_length_m(task.machine);
  CurvedAvoided out;
  out.detours = std::move(detours);
  out.tracks.grid = task.family.grid;
  for (std::size_t i = 0; i < task.family.tracks.size(); ++i)
    append_pieces(task.family.tracks[i], out.detours[i], least_m, out.tracks);
  const double by_detours_m2 = covered_by_detours_m2(task.ground.body, task.family, out.tracks, width_m);
  out.tally = curved_tally(out.tracks, width_m, task.body_m2, by_detours_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

bool is_blocked(const Track& track) { return !hard_gaps(track).empty(); }

}  // namespace

CurvedAvoided all_cut(const CurvedAvoidanceTask& task) {
  return tallied(task, std::vector<std::vector<TrackDetour>>(task.family.tracks.size()));
}

CurvedAvoided choose_detours(const CurvedAvoidanceTask& task) {
  CurvedAvoided cut = all_cut(task);
  if (task.settings.avoid != Avoidance::kCheapest) return cut;
  if (std::none_of(task.family.tracks.begin(), task.family.tracks.end(), is_blocked)) return cut;
  CurvedDecisions decisions(task);
  if (!decisions.improve()) return cut;
  CurvedAvoided out = tallied(task, decisions.detours());
  const bool works = out.tally.pieces > 0 || cut.tally.pieces == 0;
  return works && out.cost < cut.cost ? out : cut;
}

std::vector<CurvedEncounter> encounters_in(const CurvedAvoidanceTask& task, const CurvedAvoided& avoided) {
  CurvedDecisions decisions(task);
  decisions.take(avoided.detours);
  return decisions.encounters();
}

}  // namespace tramline
