#include "tramline/coverage/thread_limit.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

namespace tramline::coverage {
namespace {

std::size_t allowed() {
  return tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
}

TEST(ThreadLimit, HoldsWhileItLives) {
  const std::size_t all = allowed();
  {
    const ThreadLimit none(0);
    EXPECT_EQ(allowed(), all);
    const ThreadLimit four(4);
    EXPECT_EQ(allowed(), 4U);
    {
      const ThreadLimit one(1);
      EXPECT_EQ(allowed(), 1U);
      const ThreadLimit two(2);
      EXPECT_EQ(allowed(), 1U);
    }
    EXPECT_EQ(allowed(), 4U);
  }
  EXPECT_EQ(allowed(), all);
}

}  // namespace
}  // namespace tramline::coverage
