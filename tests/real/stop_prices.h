#pragma once
// What the price of a stop does to the tracks round many small obstacles.

#include "real/real_fields.h"

namespace tramline::testing {

/// Plans cz/45, a field with 28 pylons, with w = 3 and r = 6 at several prices of a stop, prints a table and
/// verifies the plans. Returns 1 where one fails or where no pylon is driven round at the default price.
int run_stop_prices(const RealFields& fields);

}  // namespace tramline::testing
