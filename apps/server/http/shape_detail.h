#pragma once
// How fine shapes are asked for.

#include "server/http/router.h"

namespace tramline::server {

/// "?detail_m=0.02": how far what is drawn may be from what is; 0 where it is not there. Throws bad_input
/// where it is below 0 or above `coarsest_m`.
double detail_in(const Call& call, double coarsest_m);

}  // namespace tramline::server
