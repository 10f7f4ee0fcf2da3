#include "server/http/threads_on_demand.h"

#include <system_error>
#include <utility>

namespace tramline::server {

void ThreadsOnDemand::enqueue(std::function<void()> task) {
  const std::lock_guard lock(mutex_);
  tasks_.push_back(std::move(task));
  if (tasks_.size() > idle_ && threads_.size() < most_) {
    try {
      threads_.emplace_back([this] { work(); });
    } catch (const std::system_error&) {
      // The system has no more threads: the task waits, unless there is nobody to wait for.
      if (threads_.empty()) throw;
    }
  }
  news_.notify_one();
}

void ThreadsOnDemand::shutdown() {
  std::vector<std::thread> all;
  {
    const std::lock_guard lock(mutex_);
    stopping_ = true;
    all.swap(threads_);
  }
  news_.notify_all();
  for (std::thread& thread : all) thread.join();
}

std::size_t ThreadsOnDemand::threads() const {
  const std::lock_guard lock(mutex_);
  return threads_.size();
}

void ThreadsOnDemand::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    ++idle_;
    news_.wait(lock, [this] { return stopping_ || !tasks_.empty(); });
    --idle_;
    if (tasks_.empty()) return;
    const std::function<void()> task = std::move(tasks_.front());
    tasks_.pop_front();
    lock.unlock();
    task();
    lock.lock();
  }
}

}  // namespace tramline::server
