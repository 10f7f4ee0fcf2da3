#pragma once
// Unites obstacles that overlap.

#include <vector>

#include "tramline/admission/repair_log.h"
#include "tramline/model/field.h"

namespace tramline {

/// Unites obstacles whose interiors overlap by more than kNoArea_m2 (their origins are joined with " + "),
/// until all are disjoint; obstacles that only touch stay apart. With a repair_log each union is noted as a
/// repair: the overlap had been counted twice, so the workable area grows by it. A united obstacle takes the
/// position of its last member in the list. O(n²) box tests.
std::vector<Obstacle> unite_obstacles(std::vector<Obstacle> obstacles, RepairLog* repair_log);

}  // namespace tramline
