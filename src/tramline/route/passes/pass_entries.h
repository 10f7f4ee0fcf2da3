#pragma once
// Where and which way round a headland pass may be entered.

#include <cstddef>
#include <vector>

#include "tramline/model/headland.h"
#include "tramline/model/machine.h"
#include "tramline/route/axle/axle_path.h"

namespace tramline {

enum class Sense { kAlong, kAgainst };

/// A way of working a pass: from its beginning on along its path or against it. A closed pass begins
/// anywhere.
struct PassEntry {
  double entered_m = 0;  ///< of a closed pass, along its path in that sense
  Sense sense = Sense::kAlong;
  Pose entered;  ///< of the axle when the work begins
  Pose left;     ///< of the axle when it ends
};

/// Both ways of an open pass; of a closed one those from places `spacing_m` apart or less, both ways round.
std::vector<PassEntry> entries_of(const HeadlandPass& pass, double spacing_m, const Turning& turning);

/// Those of every pass of a headland, by its index; of closed ones half a radius apart, and 2 m at least.
using EntriesByPass = std::vector<std::vector<PassEntry>>;
EntriesByPass entries_by_pass(const Headland& headland, const Machine& machine);

/// The path of the pass in a sense: of a closed one once round from where it is entered.
Path worked_path(const HeadlandPass& pass, const PassEntry& entry);
/// The way of the axle while it works the pass so.
SteeredPath axle_path(const HeadlandPass& pass, const PassEntry& entry, const Turning& turning);

}  // namespace tramline
