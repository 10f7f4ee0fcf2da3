#include "server/jobs/job.h"

namespace tramline::server {

const char* name(JobState state) {
  switch (state) {
    case JobState::kQueued:
      return "queued";
    case JobState::kRunning:
      return "running";
    case JobState::kDone:
      return "done";
    case JobState::kFailed:
      return "failed";
    case JobState::kCancelled:
      return "cancelled";
  }
  return "failed";
}

nlohmann::ordered_json job_json(const JobStatus& status) {
  nlohmann::ordered_json error;
  if (status.state == JobState::kFailed)
    error = {{"code", word_of(status.problem.fault)}, {"message", status.problem.sentence}};
  return {{"id", status.id},       {"kind", status.kind},       {"state", name(status.state)},
          {"what", status.what},   {"field", status.field},     {"done", status.done},
          {"total", status.total}, {"seconds", status.seconds}, {"result", status.result},
          {"error", error}};
}

}  // namespace tramline::server
