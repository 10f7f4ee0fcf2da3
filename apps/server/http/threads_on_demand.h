#pragma once
// A thread for each connection, so that none waits for another.

#include <httplib.h>

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace tramline::server {

/// Runs every task at once: on an idle thread, or on a new one, up to `most` threads. A client that sends or
/// reads slowly holds its own thread, and no other client's. Tasks beyond `most` wait for the first thread
/// that is free. Threads stay until shutdown(). Safe for several threads.
class ThreadsOnDemand final : public httplib::TaskQueue {
 public:
  explicit ThreadsOnDemand(std::size_t most) : most_(most) {}
  ~ThreadsOnDemand() override { shutdown(); }

  void enqueue(std::function<void()> task) override;
  /// Returns when all tasks have ended.
  void shutdown() override;

  std::size_t threads() const;

 private:
  void work();

  const std::size_t most_;
  mutable std::mutex mutex_;
  std::condition_variable news_;
  std::deque<std::function<void()>> tasks_;
  std::vector<std::thread> threads_;
  std::size_t idle_ = 0;
  bool stopping_ = false;
};

}  // namespace tramline::server
