#pragma once
// The way out of a dead end: back along the track, and then forward to the next.

#include <optional>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// Straight back for `back_m`, and then the shortest of the Dubins words. Also for a machine that otherwise
/// does not reverse between tracks. Nothing where there is no word forward, which only clothoids can cause.
/// Metres; ends in `to` within 1e-9. Precondition: back_m > 0, radius_m > 0.
std::optional<Manoeuvre> back_out(const Pose& from, const Pose& to, double radius_m, double back_m);
std::optional<Manoeuvre> back_out(const Pose& from, const Pose& to, const TurnCurve& curve, double back_m);

}  // namespace tramline
