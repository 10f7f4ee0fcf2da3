#pragma once

#include <string>
#include <vector>

#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// A ring during admission.
struct WorkRing {
  Ring points;              ///< local metres
  std::vector<int> vertex;  ///< number of each point in the input, from 1
  std::string name;         ///< "outer ring" or "hole 3"

  void erase(std::size_t i) {
    points.erase(points.begin() + static_cast<std::ptrdiff_t>(i));
    vertex.erase(vertex.begin() + static_cast<std::ptrdiff_t>(i));
  }
  std::string place(std::size_t i) const { return name + ", vertex " + std::to_string(vertex[i]); }
};

}  // namespace tramline
