#pragma once
// Which stretches of a line contain a value.

#include <cstdint>
#include <span>
#include <vector>

#include "tramline/geometry/interval.h"

namespace tramline {

/// A fixed set of closed stretches, sorted into buckets of equal width. Made in O(n), and O(n) large.
class SpanIndex {
 public:
  explicit SpanIndex(const std::vector<Interval>& spans);

  /// The numbers of all spans that contain the value, and of some that only come near it; ascending.
  /// Mostly about as many as contain it.
  std::span<const std::uint32_t> near(double value) const;

 private:
  std::size_t bucket_of(double value) const;

  double low_ = 0;
  double buckets_per_unit_ = 0;
  std::vector<std::uint32_t> first_;  ///< where each bucket begins, and the end
  std::vector<std::uint32_t> numbers_;
};

}  // namespace tramline
