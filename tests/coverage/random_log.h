#pragma once
// Logs with whatever goes wrong in logs.

#include <random>

#include "tramline/model/work_log.h"

namespace tramline::testing_logs {

/// Up and down over about 60 m, and whatever goes wrong in logs: each fault in some of them only. 2 to 160
/// fixes, without headings.
WorkLog random_log(std::mt19937_64& random);

}  // namespace tramline::testing_logs
