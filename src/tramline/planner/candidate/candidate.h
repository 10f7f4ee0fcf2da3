#pragma once
// One candidate of the search: a decomposition with its tracks and what it costs.

#include <optional>

#include "tramline/avoidance/choose_detours.h"
#include "tramline/planner/candidate/search_task.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

struct Candidate {
  std::vector<Subfield> subfields;
  std::vector<TrackFamily> families;  ///< by subfield
  Avoided avoided;                    ///< the tracks, their tally and cost
  bool numbered_from_line_0 = false;  ///< straight tracks carry the numbers of their strips
  std::optional<Region> worked{};     ///< with S2's tracks: the union of their swaths

  double cost() const { return avoided.cost; }
  bool works() const { return avoided.tally.pieces > 0; }
};

/// A subfield with the lines that its tracks lie along: the parallels of its reference or, where it has none,
/// the strips of a grid.
struct LinedSubfield {
  Subfield subfield;
  double origin_m = 0;  ///< of a grid: coordinate across of line 0, in the turned plane
};

/// All tracks of a subfield.
TrackFamily tracks_on(const SearchTask& task, const LinedSubfield& ground);

/// What candidate_on() makes the candidate of again.
std::vector<LinedSubfield> grounds_of(const Candidate& candidate);

/// What is known of a candidate before the ways past the obstacles are looked for.
struct Outlook {
  double cut = 0;    ///< cost with all tracks cut at obstacles
  double soft = 0;   ///< the same with a stop no dearer than a turn: as if most obstacles had a way round
  double least = 0;  ///< whatever is done about obstacles, it costs no less
};
Outlook outlook_on(const SearchTask& task, const std::vector<LinedSubfield>& grounds);

/// Tracks on the given grids, got past the obstacles and tallied. Pure.
Candidate candidate_on(const SearchTask& task, const std::vector<LinedSubfield>& grounds);

/// S1.19: decompose, merge, lay tracks. Pure; safe to call from several threads, as is all of this.
std::vector<LinedSubfield> swept(const SearchTask& task, Direction sweep);

/// What was decided where its tracks meet obstacles; as encounters_in() gives it.
std::vector<PlacedEncounter> encounters_of(const SearchTask& task, const Candidate& candidate);

/// The number, among the tracks of its family, of the one that is track 0 of a subfield: the first that is
/// driven or meets an obstacle; along curves, and where strips keep their numbers, that at the line itself.
int first_track(const Candidate& candidate, std::size_t subfield);

}  // namespace tramline
