#pragma once

#include <functional>

namespace tramline {

/// What whoever asked for a plan wants of the search.
enum class Demand {
  kGoOn,
  kEnd  ///< with the best plan there is, or as soon as there is one
};

/// How far a search has come. Called from worker threads, one at a time, also when nothing has changed. What
/// it throws ends the search without a plan.
using Progress = std::function<Demand(int done, int total)>;

}  // namespace tramline
