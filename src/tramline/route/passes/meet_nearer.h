#pragma once
// Places that follow one another along a pass, of which most are too far off to matter.

#include <algorithm>
#include <cstddef>

namespace tramline {

/// Calls `meet(i, off)` for the places i from `first` to before `end` of which `off(i)`, how far they are
/// off, is less than `enough()`, which may fall meanwhile. One place is no more than `apart` farther off or
/// nearer than the next, in the unit of both: so many that follow one far off are passed over in a leap.
/// O(end − first)
template <typename Off, typename Enough, typename Meet>
void meet_nearer(std::size_t first, std::size_t end, double apart, const Off& off, const Enough& enough,
                 const Meet& meet) {
  for (std::size_t i = first; i < end;) {
    const double off_here = off(i);
    if (off_here < enough()) meet(i, off_here);
    const double leap = apart > 0 ? std::max(0.0, (off_here - enough()) / apart) : 0;
    i += std::max<std::size_t>(1, static_cast<std::size_t>(std::min(leap, static_cast<double>(end - i))));
  }
}

}  // namespace tramline
