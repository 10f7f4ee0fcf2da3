#pragma once
// The least that a way takes which backs out of a line before it goes on.

#include <functional>

#include "tramline/route/backing/backed_ways.h"
#include "tramline/route/backing/line_exits.h"

namespace tramline {

/// What a way takes at least from a pose of a line, in either gear, with a stop at each change of it, s. From
/// farther back along the line the machine could first drive on to there.
using LeastOnFrom = std::function<double(const Pose&)>;

/// No way takes less, s, that backs out of the line by some distance, stops, and goes on; into a line
/// likewise, the other way round. The distances are divided until the bound is found to kDivided_s or
/// kDividedShare.
double least_backed_first_s(const BackingTerms& terms, const LineExit& exit, const LeastOnFrom& on_s);

}  // namespace tramline
