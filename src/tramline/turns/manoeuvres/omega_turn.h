#pragma once
// The omega: a turn out, one of more than half a circle, a turn back.

#include <optional>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// LRL or RLR with an equal first and last turn, each less than half a circle, between poses whose headings
/// differ by more than a quarter circle. Between antiparallel poses side by side, s ≤ 2r apart, its length is
/// r (π + 4 acos((r + s/2)/2r)) and its depth r + √(4r² − (r + s/2)²) (Sabelhaus et al. 2013). Of the two to
/// either side the shorter one; nothing where there is none. Metres; ends in `to` within 1e-9.
/// Precondition: radius_m > 0.
std::optional<Manoeuvre> omega_turn(const Pose& from, const Pose& to, double radius_m);
std::optional<Manoeuvre> omega_turn(const Pose& from, const Pose& to, const TurnCurve& curve);

}  // namespace tramline
