#pragma once
// The verifier: checks a plan independently of the planner.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/plan.h"
#include "tramline/model/tally.h"

namespace tramline::check {

/// The rules that a plan is checked against; each is one or more functions of rules.h.
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
  kRouteAreas,
  kRouteBound,
  kRouteDrivenOver,
  kRouteLegs,
  kRouteOrder,
  kRouteRoom,
  kShapes,
  kStops,
  kSubfields,
  kSwathOverlap,
  kSwaths,
  kTally,
  kTurns,
  kWarnings,
  kWholeCost,
};
/// The name used in reports: "body", "swath overlap".
std::string_view name(Rule rule);

/// One contradiction between a plan and a rule.
struct Violation {
  Rule rule = Rule::kShapes;
  std::string what;   ///< one sentence with the numbers
  Point at;           ///< a point where it shows, local metres
  double amount = 0;  ///< its size, in the unit named by `what`
};

using Violations = std::vector<Violation>;

struct Verdict {
  Tally recomputed;   ///< of tracks and headland passes, from cells of land
  Tally track_tally;  ///< the same for the tracks alone, compared with the body
  std::vector<Violation> violations;
  /// What the plan would break were it tramline's own, but does not promise: tracks made as a paper makes
  /// them, and lines of others, may be tighter than the machine's radius, or have kinks; lines of others may
  /// work obstacles. Their areas are verified all the same. Also what a route drives without room, where it
  /// says so, and swaths that leave a soft boundary farther than the machine may turn.
  std::vector<Violation> findings;
  /// Statements of the plan, by key or column, that cannot be verified: `violations` would be the same
  /// whether they are true or not (not_verified.h).
  std::vector<std::string> not_verified;
  /// False where shapes or pieces are so wrong that nothing else could be checked: `recomputed` is empty
  /// then.
  bool complete = false;

  bool holds() const { return complete && violations.empty(); }
};

/// Verifies a plan from its tracks: rebuilds the swaths, recomputes every area from cells between edges
/// (independently of the planner, which adds up closed forms) and checks that each piece obeys the
/// definitions of the glossary. Headlands are verified likewise: their land is recomputed from the
/// boundaries, and the passes are compared with it. Areas may differ by 1e-6 of the field's area, and by the
/// difference between chords and arcs (1e-5 m along detours and passes, 1e-4 m along curved tracks, 1e-3 m
/// along round edges of headlands); lengths by 1 mm, radii by 1 %, headings where segments meet by 1°.
///
/// Of lines of others (PlanOrigin::kLines) only figures and counts are verified, and findings are listed of
/// obstacles, radii and spacing: the rules by which plans are made here do not apply to them.
///
/// Violations come in the order of the rules, then of the pieces. Throws Error(kFailure) only where
/// GEOS fails. O(p·v + p log p) for p pieces and v vertices, while detours and curves
/// have few segments.
Verdict verify(const Plan& plan);

}  // namespace tramline::check
