#pragma once
// Writes the coverage file beside the measuring.

#include <sys/types.h>

#include <functional>
#include <string>

namespace tramline::app {

/// A copy of the process writes, while this one goes on: what it sees is the drive as it was at start().
class CoverageSaver {
 public:
  CoverageSaver() = default;
  CoverageSaver(const CoverageSaver&) = delete;
  CoverageSaver& operator=(const CoverageSaver&) = delete;
  ~CoverageSaver() { stop(); }

  bool busy() const { return child_ > 0; }
  /// `write` runs in the copy. Nothing happens while one is busy.
  void start(const std::function<void()>& write);
  /// Where a copy has ended: true, and why it failed, "" where it did not.
  bool ended(std::string& fault);
  /// Ends a copy that is busy.
  void stop();

 private:
  pid_t child_ = -1;
  int pipe_ = -1;
};

}  // namespace tramline::app
