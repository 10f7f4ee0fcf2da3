#pragma once
// Connects a search with its job.

#include <chrono>
#include <optional>

#include "server/jobs/job.h"
#include "tramline/planner/progress.h"

namespace tramline::server {

/// Reports the progress of the search to the job, and ends the search with the job. After `seconds` the
/// search is asked to end with the best plan it has. The job has to outlive it.
inline Progress told_to(JobRun& run, std::optional<double> seconds = {}) {
  return [&run, seconds, start = std::chrono::steady_clock::now()](int done, int total) {
    run.progress(done, total);
    const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start;
    return seconds && passed.count() >= *seconds ? Demand::kEnd : Demand::kGoOn;
  };
}

}  // namespace tramline::server
