#pragma once
// Sets of positions on a line as sorted, disjoint intervals.

#include <vector>

namespace tramline {

struct Interval {
  double from = 0;
  double to = 0;
  double length() const { return to - from; }
  friend bool operator==(const Interval& a, const Interval& b) = default;
};

/// Sorted, with gaps between them.
using Intervals = std::vector<Interval>;

/// Appends an interval that starts no earlier than the last one; joins it where they meet.
void append_joining(Intervals& set, Interval next);
/// The rest of `set` without the inside of `cuts`. O(n + m).
Intervals without(const Intervals& set, const Intervals& cuts);
/// The parts in both. O(n + m).
Intervals common(const Intervals& a, const Intervals& b);
/// Everything in [from, to] outside `set`.
Intervals complement(const Intervals& set, Interval whole);

}  // namespace tramline
