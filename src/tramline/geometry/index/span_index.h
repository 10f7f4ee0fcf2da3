#pragma once
// An index of the stretches of a line that contain a value.

#include <cstdint>
#include <span>
#include <vector>

#include "tramline/geometry/interval.h"

namespace tramline {

/// A fixed set of closed stretches, sorted into buckets of equal width. O(n) to build and to store.
class SpanIndex {
 public:
  explicit SpanIndex(const std::vector<Interval>& spans);

  /// The indices of all spans that contain the value, and of some that only come near it; ascending. Mostly
  /// about as many as contain it.
  std::span<const std::uint32_t> near(double value) const;

 private:
  std::size_t bucket_of(double value) const;

  double low_ = 0;
  double buckets_per_unit_ = 0;
  std::vector<std::uint32_t> first_;  ///< start of each bucket, and the end of the last
  std::vector<std::uint32_t> numbers_;
};

}  // namespace tramline
