#include "tramline/route/order/land_pattern.h"

#include <algorithm>
#include <cassert>

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

}  // namespace tramline::order
