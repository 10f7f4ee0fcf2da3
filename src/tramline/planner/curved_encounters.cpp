#include "tramline/planner/curved_encounters.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "tramline/planner/order/lines.h"

namespace tramline {
namespace {

/// Pieces on both sides of what blocks a track are as near: less is rounding, m.
constexpr double kNearer_m = 1e-3;

/// How far the piece is from what blocks its track.
double off_by(const LaidPiece& piece, const Interval& between) {
  return std::max({0.0, piece.from - between.to, between.from - piece.to});
}

}  // namespace

std::vector<Encounter> encounters_as_driven(const SearchTask& task, const CurvedCandidate& candidate,
                                            const Driven& driven) {
  std::vector<Encounter> out;
  for (const PlacedEncounter& one : candidate.encounters) {
    Encounter encounter = one;
    double nearest = std::numeric_limits<double>::infinity();
    bool back = false;
    const auto look_at = [&](const LaidPiece& piece, auto subfield, bool driven_back) {
      if (piece.track != encounter.track || piece.branch != one.branch) return;
      const double off = off_by(piece, one.between);
      if (off >= nearest - kNearer_m) return;
      nearest = off;
      encounter.subfield = subfield();
      back = driven_back;
    };
    for (std::size_t i = 0; i < candidate.tracks.pieces.size(); ++i)
      look_at(
          candidate.tracks.pieces[i], [&] { return driven.subfields[i]; }, driven.back[i]);
    for (const LaidPiece& piece : candidate.tracks.dropped)
      look_at(
          piece, [&] { return subfield_of(task.ground.plannable, piece, task.machine.width_m); }, back);
    if (back) {
      std::swap(encounter.left, encounter.right);
      encounter.chosen = order::other_side(encounter.chosen);
    }
    out.push_back(std::move(encounter));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Encounter& a, const Encounter& b) { return a.subfield < b.subfield; });
  return out;
}

}  // namespace tramline
