#pragma once
// One subfield with tracks parallel to a curve, as tried while the curve is searched for.

#include <optional>
#include <vector>

#include "tramline/planner/candidate/candidate.h"
#include "tramline/planner/curved/family_bound.h"
#include "tramline/tracks/curved_tracks.h"

namespace tramline {

/// The curve that tracks run parallel to.
struct Reference {
  std::vector<Point> line;  ///< the line from which it was made
  Path path;                ///< no tighter than the machine turns, not yet extended
  double deviation_m = 0;   ///< largest distance from the given line
  bool round = false;       ///< leads all the way round the land, back to where it began
};

/// The line smoothed to what the machine drives and to `tolerance_m`. Throws kBadInput for a line that
/// smoothed() refuses, and where a line all the way round shrinks to a point.
Reference reference_along(const SearchTask& task, const std::vector<Point>& line, double tolerance_m);

/// The same for a line that the user did not give; nullopt where reference_along() throws.
std::optional<Reference> try_reference_along(const SearchTask& task, const std::vector<Point>& line,
                                             double tolerance_m);

/// The subfield with tracks along the reference moved `right_m` to the right and extended along its end
/// tangents across all the land. nullopt where it cannot be moved so far.
std::optional<Subfield> subfield_along(const SearchTask& task, const Polygon& shape,
                                       const Reference& reference, double right_m = 0);

/// As candidate_on() for this one subfield without ways past obstacles; `ground` belongs to its shape. The
/// candidate's families stay empty. Construction stops, without a track, as soon as the candidate is certain
/// to cost more than the limits.
Candidate plain_candidate(const SearchTask& task, const CurvedGround& ground, const Subfield& subfield,
                          const CostLimits& limits);

/// Whether curved tracks may reach anything that they go round or cross.
bool asks_for_detours(const SearchTask& task);

}  // namespace tramline
