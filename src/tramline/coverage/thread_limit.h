#pragma once
// How many threads put regions together.

#include <memory>

namespace tramline::coverage {

/// While it lives, this process works by as many threads at once; 0: by all there are. What comes of the work
/// is the same. Of several limits the lowest holds.
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
