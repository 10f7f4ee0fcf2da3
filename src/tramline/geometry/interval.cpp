#include "tramline/geometry/interval.h"

#include <algorithm>

namespace tramline {

void append_joining(Intervals& set, Interval next) {
  if (!set.empty() && next.from <= set.back().to)
    set.back().to = std::max(set.back().to, next.to);
  else
    set.push_back(next);
}

Intervals without(const Intervals& set, const Intervals& cuts) {
  Intervals out;
  std::size_t c = 0;
  for (const Interval& whole : set) {
    double from = whole.from;
    while (c < cuts.size() && cuts[c].to <= from) ++c;
    for (std::size_t i = c; i < cuts.size() && cuts[i].from < whole.to; ++i) {
      if (cuts[i].from > from) out.push_back({from, cuts[i].from});
      from = std::max(from, cuts[i].to);
    }
    if (from < whole.to) out.push_back({from, whole.to});
  }
  return out;
}

Intervals common(const Intervals& a, const Intervals& b) {
  Intervals out;
  for (std::size_t i = 0, j = 0; i < a.size() && j < b.size();) {
    const double from = std::max(a[i].from, b[j].from), to = std::min(a[i].to, b[j].to);
    if (from < to) out.push_back({from, to});
    if (a[i].to < b[j].to)
      ++i;
    else
      ++j;
  }
  return out;
}

Intervals complement(const Intervals& set, Interval whole) { return without({whole}, set); }

}  // namespace tramline
