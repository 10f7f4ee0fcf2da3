#pragma once
// Turns between ends that are staggered along the tracks, as at oblique borders (P).

#include <optional>

#include "tramline/model/manoeuvre.h"
#include "tramline/turns/manoeuvres/turn_curve.h"

namespace tramline {

/// The shortest of the words LSL, RSR, LRL and RLR with turns of different angle: without a lead, the arcs
/// make up for the ends' stagger (Sabelhaus et al. 2013). Nothing between poses that are level, or whose
/// headings differ by less than a quarter circle. Metres; ends in `to` within 1e-9. Precondition: radius_m >
/// 0.
std::optional<Manoeuvre> unequal_arcs(const Pose& from, const Pose& to, double radius_m);
std::optional<Manoeuvre> unequal_arcs(const Pose& from, const Pose& to, const TurnCurve& curve);

/// A line on at the end that lies back, until both are level, and then the U, or where that does not exist
/// the omega: by the stagger longer than these. Level is, for headings that are not antiparallel, what makes
/// both turns equal. Nothing between poses that are level already, or where neither exists. Kind
/// kUnequalArcs.
std::optional<Manoeuvre> lead_and_turn(const Pose& from, const Pose& to, double radius_m);
std::optional<Manoeuvre> lead_and_turn(const Pose& from, const Pose& to, const TurnCurve& curve);

}  // namespace tramline
