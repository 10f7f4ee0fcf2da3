#include "tramline/planner/assembly/encounters_as_driven.h"

#include <algorithm>
#include <limits>
#include <map>
#include <utility>

#include "tramline/avoidance/refusal.h"
#include "tramline/planner/tolerances.h"
#include "tramline/route/order/lines.h"

namespace tramline {
namespace {

/// The distance of the piece from the obstacle that blocks its track.
double off_by(const LaidPiece& piece, const Interval& between) {
  return std::max({0.0, piece.from - between.to, between.from - piece.to});
}

using NumberedTrack = std::pair<std::size_t, int>;  // by subfield and number in its family

/// The driven pieces of each track, in driving order.
std::map<NumberedTrack, std::vector<std::size_t>> by_track(const Candidate& candidate, const Driven& driven) {
  std::map<NumberedTrack, std::vector<std::size_t>> out;
  for (std::size_t i = 0; i < driven.laid.size(); ++i) {
    const LaidIndex& laid = driven.laid[i];
    const LaidPiece& piece = candidate.avoided.tracks[laid.subfield].pieces[laid.piece];
    out[{laid.subfield, piece.track}].push_back(i);
  }
  return out;
}

bool leaves_tracks_out(const Candidate& candidate, const Machine& machine) {
  return std::ranges::any_of(candidate.avoided.tracks, [&](const LaidTracks& tracks) {
    return std::ranges::any_of(tracks.dropped, [&](const LaidPiece& piece) {
      return why_dropped(piece, machine) == DroppedFor::kWay;
    });
  });
}

/// What the tracks cost decided on the ways past obstacles, and what their routes cost on leaving some of
/// them out: the land of these would pay for detours that lead nowhere.
void refuse_cheaper_ways(Encounter& encounter) {
  const auto cost_of = [&](Passing way) {
    if (way == Passing::kCut) return 0.0;
    return way == Passing::kLeft ? encounter.left.cost : encounter.right.cost;
  };
  const double chosen = cost_of(encounter.chosen);
  for (WayPast* way : {&encounter.left, &encounter.right})
    if (way->possible && way->cost < chosen) *way = {false, 0, sentence(Refusal::kNotWorthTheWay)};
}

}  // namespace

std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const Driven& driven) {
  const auto tracks = by_track(candidate, driven);
  const bool some_left_out = leaves_tracks_out(candidate, task.machine);
  std::vector<Encounter> out;
  for (PlacedEncounter& encounter : encounters_of(task, candidate)) {
    double nearest_m = std::numeric_limits<double>::infinity();
    bool back = false;
    if (const auto found = tracks.find({encounter.subfield, encounter.track}); found != tracks.end())
      for (const std::size_t i : found->second) {
        const LaidIndex& laid = driven.laid[i];
        const LaidPiece& piece = candidate.avoided.tracks[laid.subfield].pieces[laid.piece];
        if (piece.branch != encounter.branch) continue;
        const double off_m = off_by(piece, encounter.between);
        if (off_m >= nearest_m - kAsNear_m) continue;
        nearest_m = off_m;
        back = driven.back[i];
      }
    encounter.track -= first_track(candidate, encounter.subfield);
    if (back) {
      encounter.chosen = order::other_side(encounter.chosen);
      std::swap(encounter.left, encounter.right);
    }
    if (some_left_out) refuse_cheaper_ways(encounter);
    out.push_back(std::move(encounter));
  }
  return out;
}

}  // namespace tramline
