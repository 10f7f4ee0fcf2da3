#pragma once
// The parts of a pass that are worth driving: ground that would be left otherwise against ground worked
// again.

#include <vector>

#include "tramline/headland/headland.h"
#include "tramline/headland/worth/pass_work.h"

namespace tramline {

/// Ground that is left counts as much as five times the area worked again, as the default prices have it.
inline constexpr double kMissedToDoubled = 5;
/// The start or interruption of a pass counts as this much ground worked again, m²: a stop at the default
/// prices.
inline constexpr double kEndsOfPass_m2 = 250;

/// The parts of a path, in their order, that are worth driving once the ground of the passes before is
/// worked: of a closed path the whole, or the rest without stretches that work nearly nothing for the first
/// time, where these work more in vain than an interruption costs. (It may be the whole of a small ring that
/// works little for the first time, since it was asked for.) Of an open path its best parts. Parts are tested
/// in steps of a quarter of the width; none is shorter than `least_length_m`. O(s·(m + n)) for s steps, m
/// segments of passes and n corners of the ground, less where most is worth driving.
std::vector<Path> worth_driving(const Path& path, const GroundToWork& to_work,
                                const std::vector<HeadlandPass>& before, double least_length_m);

/// The value of all these parts, m² of ground worked again: the ground they work for the first time, times
/// kMissedToDoubled, less the area they work again or elsewhere, less their ends.
double worth_m2(const std::vector<Path>& parts, const GroundToWork& to_work,
                const std::vector<HeadlandPass>& before);

}  // namespace tramline
