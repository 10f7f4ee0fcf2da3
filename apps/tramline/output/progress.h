#pragma once
// A line on stderr for work that takes longer than a second.

#include <chrono>
#include <string>

namespace tramline::app {

/// Shows nothing unless stderr is a terminal, `quiet` is false and a second has passed.
class ProgressLine {
 public:
  explicit ProgressLine(bool quiet);
  ~ProgressLine() { clear(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// `unit`: what is counted.
  void show(const std::string& what, int done, int total, const char* unit = "directions");
  void clear();

 private:
  bool enabled_;
  bool shown_ = false;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point last_ = start_;
};

}  // namespace tramline::app
