#pragma once
// What maps find poses by.

#include <array>
#include <bit>
#include <cstddef>
#include <utility>

#include "tramline/geometry/path/steered_path.h"

namespace tramline {

/// x, y and heading: poses are one where all three are the same to the last bit.
using PoseKey = std::array<double, 3>;
using PosePairKey = std::pair<PoseKey, PoseKey>;

inline PoseKey key_of(const Pose& pose) { return {pose.at.x, pose.at.y, pose.heading.angle().radians()}; }

struct PoseHash {
  std::size_t operator()(const PoseKey& key) const {
    constexpr std::size_t kOdd = 0x9e3779b97f4a7c15U;
    constexpr int kHalf = 32;
    std::size_t out = 0;
    for (const double number : key) {
      out = (out ^ std::bit_cast<std::size_t>(number + 0.0)) * kOdd;  // 0 for -0 too, which equals it
      out ^= out >> kHalf;
    }
    return out;
  }
  std::size_t operator()(const PosePairKey& pair) const {
    constexpr std::size_t kOdd = 31;
    return (*this)(pair.first) * kOdd + (*this)(pair.second);
  }
};

}  // namespace tramline
