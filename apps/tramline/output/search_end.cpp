#include "output/search_end.h"

#include <csignal>

namespace tramline::app {
namespace {

volatile std::sig_atomic_t interrupted = 0;

void note_interrupt(int) { interrupted = 1; }

}  // namespace

InterruptEndsSearches::InterruptEndsSearches() {
  struct sigaction action = {};
  action.sa_handler = note_interrupt;
  // The handler is gone once it has been called.
  action.sa_flags = SA_RESTART | static_cast<int>(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
}

InterruptEndsSearches::~InterruptEndsSearches() { std::signal(SIGINT, SIG_DFL); }

Demand SearchEnd::demand() const {
  return interrupted != 0 || time_.is_over() ? Demand::kEnd : Demand::kGoOn;
}

}  // namespace tramline::app
