#pragma once
// What the verifier has to say about a plan.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/point.h"
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

}  // namespace tramline::check
