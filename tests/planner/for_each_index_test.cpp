#include "tramline/planner/for_each_index.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <mutex>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace tramline {
namespace {

TEST(ForEachIndex, CallsEveryIndexOnceOnAnyNumberOfThreads) {
  for (const int threads : {0, 1, 2, 7}) {
    std::vector<int> calls(1000, 0);
    for_each_index(calls.size(), SearchContext(threads), [&](std::size_t i) { ++calls[i]; });
    EXPECT_EQ(calls, std::vector<int>(calls.size(), 1)) << threads << " threads";
  }
}

TEST(SideBySide, CallsBothOnceAndThrowsOn) {
  for (const int threads : {1, 2}) {
    int one = 0, other = 0;
    side_by_side(
        SearchContext(threads), [&] { ++one; }, [&] { ++other; });
    EXPECT_EQ(one, 1);
    EXPECT_EQ(other, 1);
    EXPECT_THROW(side_by_side(
                     SearchContext(threads), [] {}, [] { throw std::runtime_error("no"); }),
                 std::runtime_error);
  }
}

#ifndef __SANITIZE_THREAD__
TEST(ForEachIndex, OnOneThreadLeavesTheOthersToTheirCallers) {
  const auto threads_of_the_process = [] {
    return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  };
  const std::size_t before = threads_of_the_process();
  for_each_index(3, SearchContext(1), [&](std::size_t) { EXPECT_EQ(threads_of_the_process(), before); });
}
#endif

TEST(ForEachIndex, HandsDataToTheBodiesAndBack) {
  for (int round = 0; round < 50; ++round) {
    std::vector<double> in(500);
    std::iota(in.begin(), in.end(), round);
    std::vector<std::vector<double>> out(in.size());
    double sum = 0;
    std::mutex mutex;
    for_each_index(in.size(), SearchContext(4), [&](std::size_t i) {
      out[i] = {in[i], in[in.size() - 1 - i]};
      const std::lock_guard lock(mutex);
      sum += in[i];
    });
    for (std::size_t i = 0; i < in.size(); ++i) EXPECT_EQ(out[i][0] + out[i][1], 2.0 * round + 499.0);
    EXPECT_EQ(sum, 500.0 * round + 499.0 * 250.0);
  }
}

TEST(ForEachIndex, DoesNothingForNothing) {
  for_each_index(0, SearchContext(0), [](std::size_t) { FAIL(); });
}

TEST(ForEachIndex, ThrowsOnWhatABodyThrows) {
  const auto body = [](std::size_t i) {
    if (i == 17) throw std::runtime_error("seventeen");
  };
  EXPECT_THROW(for_each_index(100, SearchContext(2), body), std::runtime_error);
}

}  // namespace
}  // namespace tramline
