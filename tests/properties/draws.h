#pragma once

#include <random>

namespace tramline {

inline double uniform(std::mt19937_64& random, double from, double to) {
  return std::uniform_real_distribution<double>(from, to)(random);
}

/// One of the whole numbers from `from` to `to`, both included.
inline int any_of(std::mt19937_64& random, int from, int to) {
  return std::uniform_int_distribution<int>(from, to)(random);
}

}  // namespace tramline
