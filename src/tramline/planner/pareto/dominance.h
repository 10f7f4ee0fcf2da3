#pragma once
// Dominance among tallies: the Pareto front of a set.

#include <cstddef>
#include <vector>

#include "tramline/model/front.h"

namespace tramline {

/// The criteria by which plans are compared. Areas are in thousandths of a square metre: smaller differences
/// are the rounding of large sums, not a choice.
struct Criteria {
  long long overlap_milli_m2 = 0;
  long long uncovered_milli_m2 = 0;
  int turns = 0;
  int stops = 0;
  int further_subfields = 0;
  bool operator==(const Criteria&) const = default;
};
Criteria criteria_of(const Tally& tally);

/// Whether `a` is no worse than `b` in overlap, uncovered land, turns, stops and further subfields, and
/// better in one of them. The last three are compared separately because they have separate prices: only then
/// is the cheapest of a set among the undominated ones, whatever the prices are.
bool dominates(const Tally& a, const Tally& b);

/// Indices of the tallies that no other dominates, ascending in overlap, then in uncovered land, turns, stops
/// and subfields. Of tallies that are equal in all five the first is kept. O(n²), in practice O(n log n + n ·
/// kept).
std::vector<std::size_t> undominated(const std::vector<Tally>& tallies);

}  // namespace tramline
