#include "output/work_key.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>

namespace tramline::app {

WorkKey::WorkKey(KeySource source) {
  const bool stdin_taken = source == KeySource::kTerminal;
  if (stdin_taken && isatty(STDIN_FILENO) == 1) return;  // lines are typed there
  own_ = stdin_taken;
  terminal_ = own_ ? open("/dev/tty", O_RDONLY | O_CLOEXEC | O_NOCTTY) : STDIN_FILENO;
  // Only with someone who looks on: a pipeline of a script is none of ours.
  const bool seen = isatty(STDOUT_FILENO) == 1 || isatty(STDERR_FILENO) == 1;
  if (terminal_ < 0 || !seen || tcgetattr(terminal_, &before_) != 0 || tcgetpgrp(terminal_) != getpgrp()) {
    if (own_ && terminal_ >= 0) close(terminal_);
    terminal_ = -1;
    return;
  }
  termios keys = before_;
  keys.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  keys.c_cc[VMIN] = 1;
  keys.c_cc[VTIME] = 0;
  tcsetattr(terminal_, TCSANOW, &keys);
}

WorkKey::~WorkKey() {
  if (terminal_ < 0) return;
  tcsetattr(terminal_, TCSANOW, &before_);
  if (own_) close(terminal_);
}

int WorkKey::pressed() {
  pollfd wanted{terminal_, POLLIN, 0};
  if (terminal_ < 0 || poll(&wanted, 1, 0) <= 0) return 0;
  std::array<char, 64> keys;
  const ssize_t got = read(terminal_, keys.data(), keys.size());
  if (got <= 0) {
    // The terminal is gone; it is not asked again.
    if (own_) close(terminal_);
    terminal_ = -1;
    return 0;
  }
  return static_cast<int>(std::count(keys.begin(), keys.begin() + got, ' '));
}

}  // namespace tramline::app
