#pragma once
// What of a pass is worth driving: ground that would be left otherwise against ground that is worked again.

#include <vector>

#include "tramline/headland/headland.h"

namespace tramline {

/// Ground that is left counts as much as five times the area worked again, as the default prices have it.
inline constexpr double kMissedToDoubled = 5;
/// A pass that is begun, or interrupted, counts as much as so much ground worked again, m²: at the default
/// prices a stop.
inline constexpr double kEndsOfPass_m2 = 250;

/// Ground that passes are there to work.
struct GroundToWork {
  const Region& ground;
  const Region& passable;  ///< land where the work is interrupted: to drive there costs nothing
  double width_m = 0;
};

/// The parts of a path, in their order, that are worth driving once the ground of the passes before is
/// worked: of a path that ends where it begins the whole, or what remains without stretches that work nearly
/// nothing for the first time, where what these work in vain is more than an interruption. (It may be the
/// whole of a small ring that works little for the first time: somebody asked for it.) Of one with two ends
/// its best parts. Parts are looked at in steps of a quarter of the width; none is shorter than
/// `least_length_m`.
/// O(s·(m + n)) for s steps, m segments of passes and n corners of the ground, less where most is worth it.
std::vector<Path> worth_driving(const Path& path, const GroundToWork& to_work,
                                const std::vector<HeadlandPass>& before, double least_length_m);

/// What all these parts are worth, m² of ground worked again: what they work for the first time, five times,
/// less what they work again or elsewhere, less their ends.
double worth_m2(const std::vector<Path>& parts, const GroundToWork& to_work,
                const std::vector<HeadlandPass>& before);

}  // namespace tramline
