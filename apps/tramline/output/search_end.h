#pragma once
// When a search ends before it is through: after --seconds, or at Ctrl-C.

#include <optional>

#include "options/search_seconds.h"
#include "tramline/planner/progress.h"

namespace tramline::app {

/// While such an object exists, the first Ctrl-C (SIGINT) asks searches to end, and a second one ends the
/// program as usual. There may be one such object at a time.
class InterruptEndsSearches {
 public:
  InterruptEndsSearches();
  InterruptEndsSearches(const InterruptEndsSearches&) = delete;
  InterruptEndsSearches& operator=(const InterruptEndsSearches&) = delete;
  ~InterruptEndsSearches();
};

/// The demand that one search has to follow. Its time counts from the construction of the object.
class SearchEnd {
 public:
  explicit SearchEnd(std::optional<double> seconds) : time_(seconds) {}
  Demand demand() const;

 private:
  SearchTime time_;
};

}  // namespace tramline::app
