#pragma once
// The fishtail: turn, reverse, turn.

#include <optional>
#include <vector>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// Two turns to one side, forward, each less than half a circle, and a line between them driven in reverse;
/// between poses whose headings differ by more than a quarter circle, level or staggered. To each side where
/// it exists, the shorter one first. Between antiparallel poses side by side, s < 2r apart, these are quarter
/// turns; length π r + 2r − s, depth r, two changes of gear (Sabelhaus et al. 2013). With clothoids the
/// wheels are straight ahead at both changes of gear, and it exists up to the distance at which the U begins.
/// Metres; ends in `to` within 1e-9. Precondition: radius_m > 0.
std::vector<Manoeuvre> fishtails(const Pose& from, const Pose& to, const TurnCurves& curves);

/// The shorter of them.
std::optional<Manoeuvre> fishtail(const Pose& from, const Pose& to, double radius_m);
std::optional<Manoeuvre> fishtail(const Pose& from, const Pose& to, const TurnCurves& curves);

}  // namespace tramline
