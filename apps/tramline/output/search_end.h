#pragma once
// When a search ends before it is through: after --seconds, or at Ctrl-C.

#include <chrono>
#include <optional>

#include "options/command_options.h"
#include "tramline/planner/progress.h"

namespace tramline::app {

void add_seconds_option(CommandOptions& command, std::optional<double>& seconds);

/// While such an object exists, the first Ctrl-C (SIGINT) asks searches to end, and a second one ends the
/// program as usual. There may be one such object at a time.
class InterruptEndsSearches {
 public:
  InterruptEndsSearches();
  InterruptEndsSearches(const InterruptEndsSearches&) = delete;
  InterruptEndsSearches& operator=(const InterruptEndsSearches&) = delete;
  ~InterruptEndsSearches();
};

/// The demand that one search has to follow. Its time limit counts from the construction of the object.
class SearchEnd {
 public:
  explicit SearchEnd(std::optional<double> seconds) : seconds_(seconds) {}
  Demand demand() const;

 private:
  std::optional<double> seconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace tramline::app
