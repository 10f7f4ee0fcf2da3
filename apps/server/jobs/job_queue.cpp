#include "server/jobs/job_queue.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <utility>

#include "server/store/new_id.h"

namespace tramline::server {

using Clock = std::chrono::steady_clock;

/// Guarded by the queue's mutex but for `cancelled`.
class JobQueue::Entry : public JobRun {
 public:
  Entry(JobQueue& owner, JobStatus status, Work wanted)
      : work(std::move(wanted)), current(std::move(status)), owner_(owner) {}

  void progress(int done, int total) override {
    check();
    const std::lock_guard lock(owner_.mutex_);
    // Parallel searches count out of order.
    if (total == current.total && done <= current.done) return;
    current.done = done;
    current.total = total;
    touch();
  }
  void step(const std::string& what) override {
    check();
    const std::lock_guard lock(owner_.mutex_);
    current.what = what;
    touch();
  }
  void check() override {
    if (cancelled) throw JobCancelled();
  }

  void touch() {
    ++current.version;
    owner_.changed_.notify_all();
  }

  Work work;
  JobStatus current;
  Clock::time_point start, end;
  std::atomic<bool> cancelled = false;

 private:
  JobQueue& owner_;
};

JobQueue::JobQueue(int at_once, std::size_t most_waiting, std::size_t remembered)
    : most_waiting_(most_waiting), remembered_(remembered) {
  for (int i = 0; i < at_once; ++i) workers_.emplace_back([this] { work(); });
}

JobStatus JobQueue::submit(const std::string& kind, const std::string& what, Work work,
                           const std::string& field) {
  const std::lock_guard lock(mutex_);
  const auto waiting = std::count_if(entries_.begin(), entries_.end(), [](const auto& entry) {
    return entry->current.state == JobState::kQueued;
  });
  if (stopping_ || static_cast<std::size_t>(waiting) >= most_waiting_)
    throw HttpError(Fault::kBusy, "too much work is waiting already; try again when some of it is done");
  JobStatus status;
  status.id = new_id();
  status.kind = kind;
  status.what = what;
  status.field = field;
  entries_.push_back(std::make_shared<Entry>(*this, std::move(status), std::move(work)));
  wanted_.notify_one();
  return entries_.back()->current;
}

std::shared_ptr<JobQueue::Entry> JobQueue::entry(const std::string& id) const {
  for (const auto& entry : entries_)
    if (entry->current.id == id) return entry;
  return nullptr;
}

JobStatus JobQueue::status(const Entry& entry) const {
  JobStatus out = entry.current;
  const bool began = entry.start != Clock::time_point();
  const Clock::time_point until = is_over(out.state) ? entry.end : Clock::now();
  if (began) out.seconds = std::chrono::duration<double>(until - entry.start).count();
  return out;
}

std::optional<JobStatus> JobQueue::find(const std::string& id) const {
  const std::lock_guard lock(mutex_);
  const auto found = entry(id);
  if (!found) return std::nullopt;
  return status(*found);
}

std::vector<JobStatus> JobQueue::list() const {
  const std::lock_guard lock(mutex_);
  std::vector<JobStatus> out;
  for (auto entry = entries_.rbegin(); entry != entries_.rend(); ++entry) out.push_back(status(**entry));
  std::stable_partition(out.begin(), out.end(), [](const JobStatus& job) { return !is_over(job.state); });
  return out;
}

std::optional<JobStatus> JobQueue::cancel(const std::string& id) {
  Work left;  // what it holds is let go of when the mutex is
  const std::lock_guard lock(mutex_);
  const auto found = entry(id);
  if (!found) return std::nullopt;
  found->cancelled = true;
  if (found->current.state == JobState::kQueued) {
    found->current.state = JobState::kCancelled;
    left = std::exchange(found->work, nullptr);
    found->touch();
    forget_old();
  }
  return status(*found);
}

std::optional<JobStatus> JobQueue::wait(const std::string& id, unsigned version,
                                        std::chrono::milliseconds most) const {
  std::unique_lock lock(mutex_);
  const auto found = entry(id);
  if (!found) return std::nullopt;
  changed_.wait_for(lock, most, [&] { return found->current.version != version || stopping_; });
  return status(*found);
}

void JobQueue::stop() {
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    for (const auto& entry : entries_) entry->cancelled = true;
  }
  wanted_.notify_all();
  changed_.notify_all();
  for (std::thread& worker : workers_)
    if (worker.joinable()) worker.join();
}

void JobQueue::forget_old() {
  const auto over = [](const auto& entry) { return is_over(entry->current.state); };
  auto count = static_cast<std::size_t>(std::count_if(entries_.begin(), entries_.end(), over));
  for (; count > remembered_; --count) entries_.erase(std::find_if(entries_.begin(), entries_.end(), over));
}

void JobQueue::work() {
  for (;;) {
    std::shared_ptr<Entry> next;
    {
      std::unique_lock lock(mutex_);
      const auto queued = [&] {
        return std::find_if(entries_.begin(), entries_.end(),
                            [](const auto& entry) { return entry->current.state == JobState::kQueued; });
      };
      wanted_.wait(lock, [&] { return stopping_ || queued() != entries_.end(); });
      if (stopping_) return;
      next = *queued();
      next->current.state = JobState::kRunning;
      next->start = Clock::now();
      next->touch();
    }
    run(next);
  }
}

void JobQueue::run(const std::shared_ptr<Entry>& entry) {
  JobState state = JobState::kDone;
  nlohmann::ordered_json result;
  Answer problem;
  try {
    result = entry->work(*entry);
  } catch (const JobCancelled&) {
    state = JobState::kCancelled;
  } catch (...) {
    // What was stopped half-way may complain of anything.
    state = entry->cancelled ? JobState::kCancelled : JobState::kFailed;
    problem = answer_to(std::current_exception());
  }
  // What it holds is gone when the job is over.
  entry->work = nullptr;
  const std::lock_guard lock(mutex_);
  entry->end = Clock::now();
  entry->current.state = state;
  entry->current.result = std::move(result);
  entry->current.problem = std::move(problem);
  entry->touch();
  forget_old();
}

}  // namespace tramline::server
