#pragma once
// How a search follows the job it is a part of.

#include <chrono>
#include <optional>

#include "server/jobs/job.h"
#include "tramline/planner/progress.h"

namespace tramline::server {

/// Tells the job how far the search has come, and ends with the job. After so many `seconds` the search is
/// asked to end with the best it has. The job has to be alive as long.
inline Progress told_to(JobRun& run, std::optional<double> seconds = {}) {
  return [&run, seconds, start = std::chrono::steady_clock::now()](int done, int total) {
    run.progress(done, total);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return seconds && passed.count() >= *seconds ? Demand::kEnd : Demand::kGoOn;
  };
}

}  // namespace tramline::server
