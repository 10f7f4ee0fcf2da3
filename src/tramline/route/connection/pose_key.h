#pragma once
// What maps find poses by.

#include <array>
#include <cstddef>
#include <functional>
#include <utility>

#include "tramline/geometry/path/steered_path.h"

namespace tramline {

/// x, y and heading: poses are one where all three are the same to the last bit.
using PoseKey = std::array<double, 3>;
using PosePairKey = std::pair<PoseKey, PoseKey>;

inline PoseKey key_of(const Pose& pose) { return {pose.at.x, pose.at.y, pose.heading.angle().radians()}; }

struct PoseHash {
  std::size_t operator()(const PoseKey& key) const {
    constexpr std::size_t kPrime = 1099511628211U;
    std::size_t out = 0;
    for (const double number : key) out = (out ^ std::hash<double>{}(number)) * kPrime;
    return out;
  }
  std::size_t operator()(const PosePairKey& pair) const {
    constexpr std::size_t kOdd = 31;
    return (*this)(pair.first) * kOdd + (*this)(pair.second);
  }
};

}  // namespace tramline
