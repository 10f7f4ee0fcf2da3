#include "tramline/coverage/thread_limit.h"

#include <tbb/global_control.h>

#include <cstddef>

namespace tramline::coverage {

struct ThreadLimit::Held {
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0)
    held_.reset(new Held{tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                             static_cast<std::size_t>(threads))});
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace tramline::coverage
