#pragma once
// The end rules: which cross-sections of a strip may be driven (glossary: end rule).

#include "tramline/model/objective.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/track_profile.h"

namespace tramline {

/// An end rule evaluated for one objective and width: a cross-section may be driven where the centre line is
/// inside the subfield, or where at least `least_width_m` of the width is.
struct EndCriterion {
  bool by_centre_line = false;
  double least_width_m = 0;
};

/// centre: the centre line; cover: any width at all; inside: the full width; cheapest: the share
/// λo/(λo+λu) at which running on stops to pay, since dS/dy = λo(w − m) − λu·m.
EndCriterion end_criterion(EndRule rule, const Objective& objective, double width_m);

/// The stretches in which a track may be driven by the end rule alone.
Intervals allowed_by(const EndCriterion& criterion, const TrackProfile& subfield);
/// The same for a strip without making a track.
Intervals allowed_by(const EndCriterion& criterion, const StripProfile& subfield);

}  // namespace tramline
