#include "output/search_end.h"

#include <csignal>

namespace tramline::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int) { interrupted = 1; }

}  // namespace

void add_seconds_option(CommandOptions& command, std::optional<double>& seconds) {
  command
      .add_option(
          "--seconds", seconds,
          "End the search for a field after this many seconds, with the best plan found so far, which is "
          "marked as cut short; Ctrl-C does the same to the search for a single field.")
      .takes("S")
      .positive()
      .shows_default("no limit");
}

InterruptEndsSearches::InterruptEndsSearches() {
  struct sigaction action = {};
  action.sa_handler = note_interrupt;
  // The handler is gone once it has been called.
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

InterruptEndsSearches::~InterruptEndsSearches() { std::signal(SIGINT, SIG_DFL); }

Demand SearchEnd::demand() const {
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - start_;
  return interrupted != 0 || (seconds_ && passed.count() >= *seconds_) ? Demand::kEnd : Demand::kGoOn;
}

}  // namespace tramline::app
