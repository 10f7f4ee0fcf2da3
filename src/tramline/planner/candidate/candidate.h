#pragma once
// One candidate of the search: a decomposition with its tracks and their cost.

#include <optional>

#include "tramline/avoidance/choose_detours.h"
#include "tramline/planner/candidate/search_task.h"
#include "tramline/tracks/laid_pieces.h"

namespace tramline {

struct Candidate {
  std::vector<Subfield> subfields;
  std::vector<TrackFamily> families;  ///< by subfield
  Avoided avoided;                    ///< the tracks, their tally and cost
  bool numbered_from_line_0 = false;  ///< straight tracks keep the numbers of their strips
  std::optional<Region> worked{};     ///< with Zhou's tracks: the union of their swaths

  double cost() const { return avoided.cost; }
  bool works() const { return avoided.tally.pieces > 0; }
};

/// A subfield with the lines of its tracks: the parallels of its reference or, where it has none, the strips
/// of a grid.
struct LinedSubfield {
  Subfield subfield;
  double origin_m = 0;  ///< for a grid: coordinate of line 0 across the tracks, in the turned plane
};

/// All tracks of a subfield.
TrackFamily tracks_on(const SearchTask& task, const LinedSubfield& ground);

/// The lined subfields from which candidate_on() makes the same candidate.
std::vector<LinedSubfield> lined_subfields_of(const Candidate& candidate);

/// Costs that are known of a candidate before ways past the obstacles are searched for.
struct Outlook {
  double cut = 0;   ///< cost with all tracks cut at obstacles
  double soft = 0;  ///< the same with stops priced no higher than turns, as if most obstacles had a way round
  double least = 0;  ///< lower bound of the cost, whatever ways past obstacles are chosen
};
Outlook outlook_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields);

/// The candidate with tracks on the given lines, with ways past the obstacles chosen, and tallied. Pure.
Candidate candidate_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields);

/// The same with all tracks cut at obstacles: much sooner, and no plan to be driven where a way round pays.
Candidate cut_candidate_on(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields);

/// Sets the tally and the cost of its tracks anew, after some of them were left out.
void settle_cost(const SearchTask& task, Candidate& candidate);

/// The cost with Versleijen's one construction at obstacles as it is printed, whatever the settings say.
double cost_by_rule(const SearchTask& task, const std::vector<LinedSubfield>& lined_subfields);

/// Versleijen §2.2.5: decompose, merge, lay tracks. Pure; safe to call from several threads, as are all
/// functions here.
std::vector<LinedSubfield> swept(const SearchTask& task, Direction sweep);

/// Whether the tracks of any of the subfields follow a line.
bool follow_curves(const std::vector<Subfield>& subfields);

/// The choices made where its tracks reach obstacles, in the form of encounters_in().
std::vector<PlacedEncounter> encounters_of(const SearchTask& task, const Candidate& candidate);

/// The number within its family of the track that becomes track 0 of a subfield: the first that is driven or
/// reaches an obstacle; along curves, and where strips keep their numbers, the one at the line itself.
int first_track(const Candidate& candidate, std::size_t subfield);

}  // namespace tramline
