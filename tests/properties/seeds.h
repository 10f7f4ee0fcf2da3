#pragma once
// Random cases, each from a seed of its own that is printed with every failure.

#include <gtest/gtest.h>

#include <random>
#include <string>

#include "properties/random_field.h"

namespace tramline::testing {

/// The random numbers of one case. While it lives, every failure tells how to run this case alone.
class SeededRandom : public std::mt19937_64 {
 public:
  explicit SeededRandom(int number) : SeededRandom(base_seed() + static_cast<unsigned long long>(number)) {}

 private:
  explicit SeededRandom(unsigned long long seed)
      : std::mt19937_64(seed),
        trace_("random case", 0, "TRAMLINE_SEED=" + std::to_string(seed) + " TRAMLINE_CASES=1") {}
  ::testing::ScopedTrace trace_;
};

/// Calls `check(random, number)` for case_count(standard) cases, until one fails.
template <class Check>
void for_each_seed(int standard, Check check) {
  const int cases = case_count(standard);
  for (int i = 0; i < cases; ++i) {
    SeededRandom random(i);
    check(random, i);
    if (::testing::Test::HasFailure()) return;
  }
}

}  // namespace tramline::testing
