#pragma once
// How a search follows the job it is a part of.

#include "server/jobs/job.h"
#include "tramline/planner/progress.h"

namespace tramline::server {

/// Tells the job how far the search has come, and ends with the job. The job has to be alive as long.
inline Progress told_to(JobRun& run) {
  return [&run](int done, int total) {
    run.progress(done, total);
    return Demand::kGoOn;
  };
}

}  // namespace tramline::server
