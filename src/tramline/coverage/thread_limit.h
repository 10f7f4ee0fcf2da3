#pragma once
// Limits the number of threads.

#include <memory>

namespace tramline::coverage {

/// While it exists, this process uses at most this number of threads at once; 0: all. Results do not depend
/// on it. Of several limits the lowest applies.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  struct Held;
  std::unique_ptr<Held> held_;
};

}  // namespace tramline::coverage
