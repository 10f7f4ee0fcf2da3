#pragma once
// The pieces of a candidate in the order in which they are driven.

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/route/build/planned_route.h"

namespace tramline {

/// The index of a piece before ordering.
struct LaidIndex {
  std::size_t subfield = 0;
  std::size_t piece = 0;  ///< index into LaidTracks::pieces
};

/// The pieces of a candidate in driving order.
struct Driven {
  std::vector<TrackPiece> pieces;
  std::vector<LaidIndex> laid;          ///< by piece: its index before ordering
  order::Tour tour;                     ///< over the lines of the pieces
  std::vector<bool> back;               ///< by piece: whether it is driven against the direction of its track
  std::optional<PlannedRoute> route{};  ///< where the settings ask for it
};

/// The pieces of a candidate by subfield, track and position along it, not in driving order. Curved pieces
/// carry the overlap that they would have by themselves, without detours (overlap_by_piece()).
std::vector<TrackPiece> track_pieces(const SearchTask& task, const Candidate& candidate);

/// The same pieces in the order and directions in which they are driven: along the planned route where the
/// settings ask for one, otherwise as order::best_tour() or order::skip_tour() say.
Driven driven_tracks(const SearchTask& task, const Candidate& candidate);

/// What no route over the tracks of a candidate and the headland passes takes less than. `tour` and `plan`:
/// of driven_tracks() and the plan with its route.
RouteProof proof_of_route(const SearchTask& task, const Candidate& candidate, const order::Tour& tour,
                          const Plan& plan);

/// Why a piece of LaidTracks::dropped is not driven.
DroppedFor why_dropped(const LaidPiece& piece, const Machine& machine);

/// The path of a piece in the field's frame, from one end to the other; without detours for a straight piece.
Path line_of(const LaidPiece& piece, const StripGrid& grid);

}  // namespace tramline
