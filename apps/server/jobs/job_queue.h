#pragma once
// Runs jobs in the background: some at once, the others queued; the last finished ones are remembered.

#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "server/jobs/job.h"

namespace tramline::server {

/// Does the work and gives its result.
using Work = std::function<nlohmann::ordered_json(JobRun&)>;

class JobQueue {
 public:
  /// The numbers of jobs that run at once, that may wait, and that are remembered after their end.
  explicit JobQueue(int at_once, std::size_t most_waiting = 100, std::size_t remembered = 50);
  JobQueue(const JobQueue&) = delete;
  JobQueue& operator=(const JobQueue&) = delete;
  ~JobQueue() { stop(); }

  /// `what`: for people; `field`: the id of the field that it works on. Throws HttpError(kBusy) where too
  /// many wait already.
  JobStatus submit(const std::string& kind, const std::string& what, Work work,
                   const std::string& field = "");
  std::optional<JobStatus> find(const std::string& id) const;
  /// Unfinished ones first, then those that are over, the latest first.
  std::vector<JobStatus> list() const;
  /// A job that is over stays as it is. nullopt: there is no such job.
  std::optional<JobStatus> cancel(const std::string& id);
  /// Waits until the job has changed since `version`, or `most` has passed.
  std::optional<JobStatus> wait(const std::string& id, unsigned version,
                                std::chrono::milliseconds most) const;
  /// Cancels everything and waits for it.
  void stop();

 private:
  class Entry;
  void work();
  void run(const std::shared_ptr<Entry>& entry);
  std::shared_ptr<Entry> entry(const std::string& id) const;
  JobStatus status(const Entry& entry) const;
  void forget_old();

  const std::size_t most_waiting_, remembered_;
  mutable std::mutex mutex_;
  mutable std::condition_variable changed_;
  std::condition_variable wanted_;
  std::deque<std::shared_ptr<Entry>> entries_;  ///< in the order they came
  bool stopping_ = false;
  std::vector<std::thread> workers_;
};

}  // namespace tramline::server
