#pragma once
// The U: turn, line, turn to one side.

#include <optional>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// Two equal turns to one side and a line between them, between poses whose headings differ by more than a
/// quarter circle. Between antiparallel poses side by side, s apart, these are quarter turns: s ≥ 2r, length
/// π r + s − 2r, depth r (Sabelhaus et al. 2013). Nothing between other poses: see unequal_arcs().
///
/// With clothoids (TurnCurve) two turns without a line need a little more than one turn by both angles: where
/// the poses are between these two, the one turn is driven with a wider arc, whose radius is found by
/// bisection to rounding. Metres; ends in `to` within 1e-9. Precondition: radius_m > 0.
std::optional<Manoeuvre> u_turn(const Pose& from, const Pose& to, double radius_m);
std::optional<Manoeuvre> u_turn(const Pose& from, const Pose& to, const TurnCurve& curve);

}  // namespace tramline
