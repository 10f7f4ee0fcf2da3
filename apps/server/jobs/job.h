#pragma once
// A job: work that takes longer than a request should.

#include <nlohmann/json.hpp>
#include <string>

#include "server/http/http_error.h"

namespace tramline::server {

enum class JobState { kQueued, kRunning, kDone, kFailed, kCancelled };
const char* name(JobState state);  ///< queued, running, done, failed, cancelled
inline bool is_over(JobState state) { return state != JobState::kQueued && state != JobState::kRunning; }

/// The state of a job at one moment.
struct JobStatus {
  std::string id;
  std::string kind;  ///< plan, compare, evaluate, repair, check
  JobState state = JobState::kQueued;
  std::string what;   ///< for people: "planning mill field"
  std::string field;  ///< id of the field that it works on; empty: of none, or not known
  int done = 0;
  int total = 0;
  double seconds = 0;             ///< since it began to run
  nlohmann::ordered_json result;  ///< null until it is done
  Answer problem;                 ///< of a failed one
  unsigned version = 0;           ///< grows with every change
};

/// The object of the API.
nlohmann::ordered_json job_json(const JobStatus& status);

/// Thrown within a job that has been cancelled; nothing else is to catch it.
class JobCancelled {};

/// The interface of a job for its work. May be used by several threads at once.
class JobRun {
 public:
  virtual ~JobRun() = default;
  /// Throws JobCancelled where the job is to stop.
  virtual void progress(int done, int total) = 0;
  virtual void step(const std::string& what) = 0;
  /// progress() without progress.
  virtual void check() = 0;
};

}  // namespace tramline::server
