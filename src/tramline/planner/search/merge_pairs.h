#pragma once
// Subfields joined two by two, the pair that saves most first.

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// Two subfields that share a border, as one; nullopt where they only touch or lie apart.
std::optional<Polygon> merged_shape(const Polygon& a, const Polygon& b);

/// Two of several subfields, by their places, the first before the second.
using PairPlaces = std::pair<std::size_t, std::size_t>;

/// A subfield that takes the place of two.
template <class Priced>
struct MergedPair {
  PairPlaces places;
  Priced whole;
  double saving = 0;  ///< negative: it costs more than the two
};

/// Joins the pair that saves most, and again, as long as one costs no more than its two; of pairs that save
/// as much the one found first. `look(subfields, places)` gives those of the pairs that may be joined. It is
/// asked once about each pair. O(n²) looks for n subfields.
template <class Priced, class Look>
std::vector<Priced> merge_pairs(std::vector<Priced> subfields, const Look& look) {
  std::vector<MergedPair<Priced>> pairs;
  const auto look_at = [&](const std::vector<PairPlaces>& places) {
    for (std::optional<MergedPair<Priced>>& pair : look(subfields, places))
      if (pair) pairs.push_back(std::move(*pair));
  };
  std::vector<PairPlaces> all;
  for (std::size_t a = 0; a < subfields.size(); ++a)
    for (std::size_t b = a + 1; b < subfields.size(); ++b) all.emplace_back(a, b);
  look_at(all);
  std::vector<bool> gone(subfields.size(), false);
  while (!pairs.empty()) {
    const auto best = std::max_element(pairs.begin(), pairs.end(),
                                       [](const auto& a, const auto& b) { return a.saving < b.saving; });
    if (best->saving < 0) break;
    const auto [a, b] = best->places;
    subfields[a] = std::move(best->whole);
    gone[b] = true;
    std::erase_if(pairs, [first = a, second = b](const auto& pair) {
      const auto& [one, other] = pair.places;
      return one == first || other == first || one == second || other == second;
    });
    std::vector<PairPlaces> next;
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
