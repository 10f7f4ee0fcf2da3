#pragma once
// Which of many tallies are worth a look.

#include <cstddef>
#include <vector>

#include "tramline/model/front.h"

namespace tramline {

/// What plans are compared by. Areas in thousandths of a square metre: what is less is the rounding of large
/// sums, and nobody's choice.
struct Criteria {
  long long overlap_milli_m2 = 0;
  long long uncovered_milli_m2 = 0;
  int turns = 0;
  int stops = 0;
  int further_subfields = 0;
  bool operator==(const Criteria&) const = default;
};
Criteria criteria_of(const Tally& tally);

/// Is `a` no worse than `b` in overlap, uncovered land, turns, stops and further subfields, and better in one
/// of them? The last three are compared each by itself, for they have prices of their own: only so is the
/// cheapest of a set among those that none dominates, whatever the prices are.
bool dominates(const Tally& a, const Tally& b);

/// The tallies that none of the others dominates, as indices, ascending in overlap, then in uncovered land,
/// turns, stops and subfields. Of tallies that are equal in all five the first is kept. O(n²), in practice
/// O(n log n + n · kept).
std::vector<std::size_t> undominated(const std::vector<Tally>& tallies);

}  // namespace tramline
