#pragma once
// The several jobs of a log, each evaluated by itself.

#include <functional>
#include <string>
#include <vector>

#include "report/evaluate_report.h"
#include "request/log_jobs.h"

namespace tramline::app {

/// What is done with a job.
struct JobWork {
  std::function<WorkGround(const io::LogJob&)> ground;
  std::function<Evaluation(WorkLog, WorkGround)> evaluate;
  /// Writes the files of a job; the name tells them from those of the others.
  std::function<void(const Evaluation&, const std::string& name)> write;
};

/// Where results go.
struct JobPrint {
  bool json = false;
  bool quiet = false;
};

/// Evaluates one job after the other and prints each. Jobs that lie nowhere near their ground are left out
/// and told; so is a job that cannot be evaluated, and then the exit code, which is returned, is 3. Throws
/// kBadInput where no job is left, without having printed anything, and whatever else `work` throws.
int evaluate_jobs(std::vector<NumberedJob> jobs, const JobWork& work, JobPrint print);

}  // namespace tramline::app
