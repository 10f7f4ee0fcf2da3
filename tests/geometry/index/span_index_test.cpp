#include "tramline/geometry/index/span_index.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace tramline {
namespace {

TEST(SpanIndex, NamesEverySpanThatContainsTheValueInOrder) {
  for (unsigned seed = 0; seed < 200; ++seed) {
    std::mt19937 random(seed);
    const auto between = [&](double a, double b) {
      return std::uniform_real_distribution<double>(a, b)(random);
    };
    std::vector<Interval> spans;
    const double longest = seed % 3 == 0 ? 100 : 2;
    for (int i = static_cast<int>(seed % 40); i > 0; --i) {
      const double from = between(-50, 50);
      spans.push_back({from, seed % 5 == 0 ? from : from + between(0, longest)});
    }
    const SpanIndex index(spans);
    std::vector<double> values{-1000, 1000};
    for (const Interval& span : spans) values.insert(values.end(), {span.from, span.to, between(-60, 160)});
    for (const double value : values) {
      const auto near = index.near(value);
      EXPECT_TRUE(std::is_sorted(near.begin(), near.end()));
      for (std::uint32_t i = 0; i < spans.size(); ++i) {
        if (spans[i].from > value || spans[i].to < value) continue;
        EXPECT_EQ(std::count(near.begin(), near.end(), i), 1) << seed << ": span " << i << " at " << value;
      }
    }
  }
}

// One value in a hundred spans side by side is near to a few of them.
TEST(SpanIndex, LeavesMostOthersOut) {
  std::vector<Interval> spans;
  for (int i = 0; i < 100; ++i) spans.push_back({static_cast<double>(i), i + 1.0});
  EXPECT_LE(SpanIndex(spans).near(50.5).size(), 4u);
}

}  // namespace
}  // namespace tramline
