#pragma once

#include <functional>

namespace tramline {

/// How far a search has come. Called from worker threads, one at a time, also when nothing has changed; what
/// it throws ends the search (pulse.h).
using Progress = std::function<void(int done, int total)>;

}  // namespace tramline
