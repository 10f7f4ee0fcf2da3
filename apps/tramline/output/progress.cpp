#include "output/progress.h"

#include <unistd.h>

#include <cstdio>

namespace tramline::app {

ProgressLine::ProgressLine(bool quiet) : enabled_(!quiet && isatty(STDERR_FILENO) == 1) {}

void ProgressLine::show(const std::string& what, int done, int total, const char* unit) {
  if (!enabled_) return;
  const auto now = std::chrono::steady_clock::now();
  using namespace std::chrono_literals;
  if (now - start_ < 1s || now - last_ < 100ms) return;
  last_ = now;
  shown_ = true;
  std::fprintf(stderr, "\r%s: %d of %d %s ", what.c_str(), done, total, unit);
  std::fflush(stderr);
}

void ProgressLine::clear() {
  if (shown_) std::fprintf(stderr, "\r%60s\r", "");
  shown_ = false;
}

}  // namespace tramline::app
