#pragma once
// Which cross-sections of a strip may be driven, under each end rule (DESIGN: end rule).

#include "tramline/model/objective.h"
#include "tramline/model/plan.h"
#include "tramline/tracks/track_profile.h"

namespace tramline {

/// Cross-sections shorter than this count as none, and ones short of the full width by no more as
/// full, m: ten times what the precision grid can move an edge that should lie on a strip line, so that
/// such an edge neither cuts a row nor makes one.
inline constexpr double kWidthTolerance = 1e-5;

/// An end rule made ready for one objective and width: a cross-section may be driven where the centre
/// line is inside the subfield, or where at least `least_width_m` of the width is.
struct EndCriterion {
  bool by_centre_line = false;
  double least_width_m = 0;
};

/// centre: the centre line; cover: any width at all; inside: the full width; cheapest: the share
/// λo/(λo+λu) at which running on stops to pay, since dS/dy = λo(w − m) − λu·m (ALGORITHMS §0.1).
EndCriterion end_criterion(EndRule rule, const Objective& objective, double width_m);

/// Where a track may be driven by the end rule alone.
Intervals allowed_by(const EndCriterion& criterion, const TrackProfile& subfield);
/// The same for a strip of which no track is made.
Intervals allowed_by(const EndCriterion& criterion, const StripProfile& subfield);

}  // namespace tramline
