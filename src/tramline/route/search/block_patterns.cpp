#include "tramline/route/search/block_patterns.h"

#include <algorithm>
#include <cassert>
#include <numeric>

#include "tramline/route/order/skip_pattern.h"

namespace tramline::order {

std::vector<std::size_t> land_pattern(std::size_t tracks, std::size_t land) {
  assert(land >= 1);
  std::vector<std::size_t> out;
  for (std::size_t first = 0; first < tracks; first += land) {
    std::size_t low = first, high = std::min(first + land, tracks);
    while (low < high) {
      out.push_back(low++);
      if (low < high) out.push_back(--high);
    }
  }
  return out;
}

std::vector<std::vector<std::size_t>> block_patterns(std::size_t tracks, std::size_t best_jump) {
  assert(best_jump >= 1);
  std::vector<std::size_t> adjacent(tracks);
  std::iota(adjacent.begin(), adjacent.end(), 0);
  std::vector<std::vector<std::size_t>> out{adjacent};
  const auto add = [&](std::vector<std::size_t> pattern) {
    if (std::find(out.begin(), out.end(), pattern) == out.end()) out.push_back(std::move(pattern));
  };
  for (std::size_t jump = std::max<std::size_t>(best_jump, 2) - 1; jump <= best_jump + 1; ++jump)
    add(skip_pattern(tracks, jump));
  for (const std::size_t land : {2 * best_jump, 3 * best_jump, tracks})
    if (land > 0) add(land_pattern(tracks, land));
  return out;
}

}  // namespace tramline::order
