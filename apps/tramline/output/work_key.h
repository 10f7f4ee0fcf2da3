#pragma once
// The space key, by which a driver says that the work goes on or off.

#include <termios.h>

namespace tramline::app {

/// Where keys come from.
enum class KeySource {
  kStdin,
  kTerminal,  ///< the terminal itself: standard input is the log
};

/// Keys come one by one, and are not shown, until it is gone. Does nothing where there is no terminal, or
/// where this program runs in the background.
class WorkKey {
 public:
  explicit WorkKey(KeySource source);
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
