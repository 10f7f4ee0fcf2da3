#pragma once
// Random cases, each from a seed of its own that is printed with every failure.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "properties/random_field.h"

namespace tramline::testing {

/// Calls `check(random, number)` for case_count(standard) cases, until one fails.
template <class Check>
void for_each_seed(int standard, Check check) {
  const int cases = case_count(standard);
  for (int i = 0; i < cases; ++i) {
    const auto seed = base_seed() + static_cast<unsigned long long>(i);
    SCOPED_TRACE("TRAMLINE_SEED=" + std::to_string(seed) + " TRAMLINE_CASES=1");
    std::mt19937_64 random(seed);
    check(random, i);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace tramline::testing
