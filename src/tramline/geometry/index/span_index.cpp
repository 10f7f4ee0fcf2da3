#include "tramline/geometry/index/span_index.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline {

SpanIndex::SpanIndex(const std::vector<Interval>& spans) : first_(3, 0) {
  if (spans.empty()) return;
  double high = -std::numeric_limits<double>::infinity(), sum = 0;
  low_ = -high;
  for (const Interval& span : spans) {
    low_ = std::min(low_, span.from);
    high = std::max(high, span.to);
    sum += span.length();
  }
  // As many buckets as spans, except where the spans are long and would be put into too many.
  constexpr double kMostEntriesPerSpan = 8;
  const auto most = static_cast<double>(spans.size());
  const double extent = high - low_;
  const double count =
      extent > 0 ? std::clamp(std::floor(kMostEntriesPerSpan * most * extent / sum), 1.0, most) : 1;
  buckets_per_unit_ = extent > 0 ? count / extent : 0;
  first_.assign(static_cast<std::size_t>(count) + 2, 0);

  // Entries of bucket b are counted two places on, so that first_[b + 1] is where it begins, and becomes
  // where it ends once they have been put there.
  for (const Interval& span : spans)
    for (std::size_t b = bucket_of(span.from), last = bucket_of(span.to); b <= last; ++b) ++first_[b + 2];
  for (std::size_t b = 2; b < first_.size(); ++b) first_[b] += first_[b - 1];
  numbers_.resize(first_.back());
  for (std::size_t i = 0; i < spans.size(); ++i)
    for (std::size_t b = bucket_of(spans[i].from), last = bucket_of(spans[i].to); b <= last; ++b)
      numbers_[first_[b + 1]++] = static_cast<std::uint32_t>(i);
}

std::span<const std::uint32_t> SpanIndex::near(double value) const {
  const std::size_t bucket = bucket_of(value);
  return {numbers_.data() + first_[bucket], first_[bucket + 1] - first_[bucket]};
}

std::size_t SpanIndex::bucket_of(double value) const {
  // Grows with the value, rounding and all: a value within a span never falls into a bucket outside it.
  const double place = (value - low_) * buckets_per_unit_;
  return static_cast<std::size_t>(std::clamp(place, 0.0, static_cast<double>(first_.size() - 3)));
}

}  // namespace tramline
