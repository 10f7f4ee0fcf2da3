#pragma once
// The parts of the land that a machine cannot drive between.

#include <cstddef>

#include "tramline/model/plan.h"

namespace tramline::check {

/// Two parts are joined only by land narrower than the machine and its implement. Passable obstacles are
/// land.
class LandParts {
 public:
  explicit LandParts(const Plan& plan);

  std::size_t count() const { return places_.size(); }
  /// The part on which an axle is, or the nearest; 0 where there are none. O(corners).
  std::size_t part_of(Point axle) const;

 private:
  Region places_;  ///< of the axle
};

}  // namespace tramline::check
