#pragma once

#include <functional>

namespace tramline {

/// The answer of a progress callback: whether the search is to go on.
enum class Demand {
  kGoOn,
  kEnd  ///< end with the best plan found so far, or as soon as one is found
};

/// A callback that receives the progress of a search. Called from worker threads, one at a time, also when
/// nothing has changed. An exception from it ends the search without a plan.
using Progress = std::function<Demand(int done, int total)>;

}  // namespace tramline
