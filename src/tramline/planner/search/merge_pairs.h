#pragma once
// Joins subfields two by two, the pair that saves most first.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// The union of two subfields that share a border; nullopt where they only touch or lie apart.
std::optional<Polygon> merged_shape(const Polygon& a, const Polygon& b);

/// The indices of two subfields, the smaller first.
using IndexPair = std::pair<std::size_t, std::size_t>;

/// A subfield that replaces two.
template <class Priced>
struct MergedPair {
  IndexPair indices;
  Priced whole;
  double saving = 0;  ///< negative: it costs more than the two
};

/// Repeatedly joins the pair that saves most, as long as the union costs no more than the two; of equal
/// savings the pair found first. `look(subfields, pairs)` returns, for the given pairs of indices, those that
/// may be joined. It is called once for each pair. O(n²) pairs for n subfields.
template <class Priced, class Look>
std::vector<Priced> merge_pairs(std::vector<Priced> subfields, const Look& look) {
  std::vector<MergedPair<Priced>> pairs;
  const auto look_at = [&](const std::vector<IndexPair>& indices) {
    for (std::optional<MergedPair<Priced>>& pair : look(subfields, indices))
      if (pair) pairs.push_back(std::move(*pair));
  };
  std::vector<IndexPair> all;
  for (std::size_t a = 0; a < subfields.size(); ++a)
    for (std::size_t b = a + 1; b < subfields.size(); ++b) all.emplace_back(a, b);
  look_at(all);
  std::vector<bool> gone(subfields.size(), false);
  while (!pairs.empty()) {
    const auto best = std::max_element(pairs.begin(), pairs.end(),
                                       [](const auto& a, const auto& b) { return a.saving < b.saving; });
    if (best->saving < 0) break;
    const auto [a, b] = best->indices;
    subfields[a] = std::move(best->whole);
    gone[b] = true;
    std::erase_if(pairs, [first = a, second = b](const auto& pair) {
      const auto& [one, other] = pair.indices;
      return one == first || other == first || one == second || other == second;
    });
    std::vector<IndexPair> next;
    for (std::size_t i = 0; i < subfields.size(); ++i)
      if (i != a && !gone[i]) next.emplace_back(std::min(a, i), std::max(a, i));
    look_at(next);
  }
  std::vector<Priced> out;
  for (std::size_t i = 0; i < subfields.size(); ++i)
    if (!gone[i]) out.push_back(std::move(subfields[i]));
  return out;
}

}  // namespace tramline
