#include "tramline/cost/bound/joined_intervals.h"

#include <algorithm>

namespace tramline {

Intervals joined(Intervals all) {
  std::sort(all.begin(), all.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals out;
  for (const Interval& one : all) append_joining(out, one);
  return out;
}

}  // namespace tramline
