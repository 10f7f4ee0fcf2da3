#include "tramline/route/order/skip_pattern.h"

#include <algorithm>
#include <cassert>

namespace tramline::order {
namespace {

/// Which half of a group comes first. It is the larger one where they differ.
enum class FirstHalf { kLower, kUpper };

/// The tracks of a group of `size` from `first` on, alternately from its lower and its upper half.
void append_group(std::size_t first, std::size_t size, FirstHalf begins, std::vector<std::size_t>& out) {
  const std::size_t upper = begins == FirstHalf::kLower ? (size + 1) / 2 : size / 2;
  for (std::size_t i = 0; i < size; ++i) {
    const bool in_lower = (i % 2 == 0) == (begins == FirstHalf::kLower);
    out.push_back(first + (in_lower ? 0 : upper) + i / 2);
  }
}

}  // namespace

std::vector<std::size_t> skip_pattern(std::size_t tracks, std::size_t jump) {
  assert(jump >= 1);
  std::vector<std::size_t> out;
  if (jump == 1) {
    for (std::size_t i = 0; i < tracks; ++i) out.push_back(i);
    return out;
  }
  const std::size_t groups = std::max<std::size_t>(1, tracks / (2 * jump + 1));
  for (std::size_t group = 0, first = 0; group < groups; ++group) {
    const std::size_t size = tracks / groups + (group < tracks % groups ? 1 : 0);
    // From the last track of a group to the first of the next one is no jump.
    const bool close = !out.empty() && first - out.back() < jump;
    append_group(first, size, close ? FirstHalf::kUpper : FirstHalf::kLower, out);
    first += size;
  }
  return out;
}

}  // namespace tramline::order
