#pragma once
// The space key, by which a driver says that the work goes on or off.

#include <termios.h>

namespace tramline::app {

/// Keys come one by one, and are not shown, until it is gone. Does nothing where there is no terminal, or
/// where this program runs in the background.
class WorkKey {
 public:
  /// `stdin_taken`: the log comes from there; keys then come from the terminal itself.
  explicit WorkKey(bool stdin_taken);
  WorkKey(const WorkKey&) = delete;
  WorkKey& operator=(const WorkKey&) = delete;
  ~WorkKey();

  /// -1: no terminal.
  int descriptor() const { return terminal_; }
  /// How often space was pressed since; waits for nothing.
  int pressed();

 private:
  int terminal_ = -1;
  bool own_ = false;
  termios before_{};
};

}  // namespace tramline::app
