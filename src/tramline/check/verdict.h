#pragma once
// What the verifier has to say about a plan.

#include <string>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/model/tally.h"

namespace tramline::check {

/// One way in which a plan is not what it says.
struct Violation {
  std::string rule;   ///< shapes, pieces, headland, body, subfields, swaths, clearance, drivable, ends,
                      ///< parallel, length, stops, crossings, encounters, tally, layers, field
  std::string what;   ///< one sentence with the numbers
  Point at;           ///< a place where it shows, local metres
  double amount = 0;  ///< how much, in the unit named by `what`
};

struct Verdict {
  Tally recomputed;   ///< of tracks and headland passes, by polygon booleans
  Tally track_tally;  ///< the same of the tracks alone, against the body
  std::vector<Violation> violations;
  /// False where shapes or pieces are so wrong that nothing else could be looked at: `recomputed` is
  /// empty then.
  bool complete = false;

  bool holds() const { return complete && violations.empty(); }
};

}  // namespace tramline::check
