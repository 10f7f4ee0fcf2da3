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

/// An encounter lies in the middle between two pieces that end before it: less is rounding, m.
constexpr double kNearer_m = 1e-3;

const TrackPiece& nearest_of(const std::vector<const TrackPiece*>& pieces, Point at) {
  const TrackPiece* nearest = pieces.front();
  for (const TrackPiece* piece : pieces)
    if (off_by(*piece, at) < off_by(*nearest, at) - kNearer_m) nearest = piece;
  return *nearest;
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
    const TrackPiece& nearest = nearest_of(found->second, encounter.at);
    const Point along = candidate.subfields[static_cast<std::size_t>(encounter.subfield)].direction.unit();
    if (dot(nearest.end - nearest.start, along) >= 0) continue;
    encounter.chosen = order::other_side(encounter.chosen);
    std::swap(encounter.left, encounter.right);
  }
  return out;
}

}  // namespace tramline
