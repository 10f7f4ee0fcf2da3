#include "tramline/planner/encounters_as_driven.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "tramline/planner/order/lines.h"

namespace tramline {
namespace {

/// How far off the piece lies from a place on the line of its track, m.
double off_by(const TrackPiece& piece, Point at) {
  const Point along = piece.end - piece.start;
  const double place = dot(at - piece.start, along) / dot(along, along);
  return length(along) * std::max({0.0, -place, place - 1});
}

}  // namespace

std::vector<Encounter> encounters_as_driven(const SearchTask& task, const Candidate& candidate,
                                            const std::vector<TrackPiece>& pieces) {
  std::map<std::pair<int, int>, std::vector<const TrackPiece*>> driven;  // by subfield and track
  for (const TrackPiece& piece : pieces) driven[{piece.subfield, piece.track}].push_back(&piece);
  std::vector<Encounter> out = encounters_of(task, candidate);
  for (Encounter& encounter : out) {
    encounter.track -= first_track(candidate, static_cast<std::size_t>(encounter.subfield));
    const auto found = driven.find({encounter.subfield, encounter.track});
    if (found == driven.end()) continue;
    const TrackPiece& nearest = **std::min_element(
        found->second.begin(), found->second.end(), [&](const TrackPiece* a, const TrackPiece* b) {
          return off_by(*a, encounter.at) < off_by(*b, encounter.at);
        });
    const Point along = candidate.subfields[static_cast<std::size_t>(encounter.subfield)].direction.unit();
    if (dot(nearest.end - nearest.start, along) >= 0) continue;
    encounter.chosen = order::other_side(encounter.chosen);
    std::swap(encounter.left, encounter.right);
  }
  return out;
}

}  // namespace tramline
