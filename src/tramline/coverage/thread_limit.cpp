#include "tramline/coverage/thread_limit.h"

#include <tbb/global_control.h>

#include <cstddef>

namespace tramline::coverage {

struct ThreadLimit::Held {
  explicit Held(int threads)
      : control(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)) {}
  tbb::global_control control;
};

ThreadLimit::ThreadLimit(int threads) {
  if (threads > 0) held_ = std::make_unique<Held>(threads);
}

ThreadLimit::~ThreadLimit() = default;

}  // namespace tramline::coverage
