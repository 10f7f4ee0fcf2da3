#pragma once
// What the verifier has to say about a plan.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/plan.h"
#include "tramline/model/tally.h"

namespace tramline::check {

/// What a plan is judged by; a function of rules.h each, or several.
enum class Rule : std::uint8_t {
  kBody,
  kClearance,
  kCrossings,
  kDrivable,
  kEncounters,
  kEnds,
  kField,
  kFront,
  kHeadland,
  kLayers,
  kLength,
  kParallel,
  kPieces,
  kProof,
  kShapes,
  kStops,
  kSubfields,
  kSwathOverlap,
  kSwaths,
  kTally,
  kWarnings,
};
/// As reports give it: "body", "swath overlap".
std::string_view name(Rule rule);

/// One way in which a plan is not what it says.
struct Violation {
  Rule rule = Rule::kShapes;
  std::string what;   ///< one sentence with the numbers
  Point at;           ///< a place where it shows, local metres
  double amount = 0;  ///< how much, in the unit named by `what`
};

using Violations = std::vector<Violation>;

struct Verdict {
  Tally recomputed;   ///< of tracks and headland passes, by cells of ground
  Tally track_tally;  ///< the same of the tracks alone, against the body
  std::vector<Violation> violations;
  /// What else the plan says, by key or column: true or not, `violations` would be the same (not_verified.h).
  std::vector<std::string> not_verified;
  /// False where shapes or pieces are so wrong that nothing else could be looked at: `recomputed` is
  /// empty then.
  bool complete = false;

  bool holds() const { return complete && violations.empty(); }
};

/// Judges a plan from its tracks: rebuilds the swaths, recomputes every area from cells between edges (the
/// planner adds up closed forms: this is another road) and looks whether each piece obeys the
/// definitions of the glossary. So it does with headlands: their ground is made again from the boundaries,
/// and the passes are held against it. Areas may differ by 1e-6 of the field's area, and by what chords take
/// from arcs (1e-5 m along detours and passes, 1e-4 m along curved tracks, 1e-3 m along round edges of
/// headlands); lengths by 1 mm, radii by 1 %, headings where segments meet by 1°.
///
/// Violations come in the order of the rules, then of the pieces. Throws Error(kFailure) only where
/// GEOS fails. O(p·v + p log p) for p pieces and v vertices, while detours and curves
/// have few segments.
Verdict verify(const Plan& plan);

}  // namespace tramline::check
