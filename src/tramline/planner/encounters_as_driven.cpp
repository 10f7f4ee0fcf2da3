#include "tramline/planner/encounters_as_driven.h"

#include <map>
#include <utility>

namespace tramline {
namespace {

Passing other_side(Passing way) {
  if (way == Passing::kCut) return way;
  return way == Passing::kLeft ? Passing::kRight : Passing::kLeft;
}

}  // namespace

std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const std::vector<TrackPiece>& pieces) {
  std::map<std::pair<int, int>, bool> driven_back;  // by subfield and track
  for (const TrackPiece& piece : pieces) {
    const Point along = candidate.subfields[static_cast<std::size_t>(piece.subfield)].direction.unit();
    driven_back[{piece.subfield, piece.track}] = dot(piece.end - piece.start, along) < 0;
  }
  std::vector<Encounter> out = encounters_of(task, candidate);
  for (Encounter& encounter : out) {
    encounter.track -= first_track(candidate, static_cast<std::size_t>(encounter.subfield));
    const auto found = driven_back.find({encounter.subfield, encounter.track});
    if (found == driven_back.end() || !found->second) continue;
    encounter.chosen = other_side(encounter.chosen);
    std::swap(encounter.left, encounter.right);
  }
  return out;
}

}  // namespace tramline
