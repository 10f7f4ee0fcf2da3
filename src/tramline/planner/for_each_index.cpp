#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

/// The body, with a report to the context before each call. Refers to both.
auto reported(const SearchContext& context, const std::function<void(std::size_t)>& body) {
  return [&context, &body](std::size_t i) {
    context.report();
    body(i);
  };
}

}  // namespace
}  // namespace tramline

#ifdef __SANITIZE_THREAD__
// Debian's TBB is not built for the thread sanitizer, which therefore does not see that TBB hands work
// from thread to thread in good order, and reports every use of a task's data as a race. Plain threads
// run the same bodies, so that races of our own are found.
#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace tramline {

void for_each_index(std::size_t count, const SearchContext& context,
                    const std::function<void(std::size_t)>& body) {
  const int threads = context.threads();
  const auto report_and_call = reported(context, body);
  std::atomic<std::size_t> next{0};
  std::exception_ptr first;
  std::mutex first_mutex;
  const auto take_part = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) report_and_call(i);
    } catch (...) {
      const std::lock_guard lock(first_mutex);
      if (!first) first = std::current_exception();
    }
  };
  const std::size_t cores = std::max(1U, std::thread::hardware_concurrency());
  const std::size_t wanted = threads > 0 ? static_cast<std::size_t>(threads) : cores;
  std::vector<std::jthread> crew;
  for (std::size_t i = 0; i < std::min(wanted, count); ++i) crew.emplace_back(take_part);
  crew.clear();
  if (first) std::rethrow_exception(first);
}

}  // namespace tramline

#else

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <optional>

namespace tramline {

void for_each_index(std::size_t count, const SearchContext& context,
                    const std::function<void(std::size_t)>& body) {
  const int threads = context.threads();
  const auto report_and_call = reported(context, body);
  // More threads than cores are the caller's wish; without this TBB warns on stderr. Fewer are the arena's
  // business alone: the limit holds for the whole process, and would slow callers that plan several fields
  // at a time.
  std::optional<tbb::global_control> limit;
  if (threads > tbb::info::default_concurrency())
    limit.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
  tbb::task_arena arena(threads > 0 ? threads : tbb::task_arena::automatic);
  arena.execute([&] { tbb::parallel_for(std::size_t{0}, count, report_and_call); });
}

}  // namespace tramline

#endif

namespace tramline {

void side_by_side(const SearchContext& context, const std::function<void()>& one,
                  const std::function<void()>& other) {
  for_each_index(2, context, [&](std::size_t i) { i == 0 ? one() : other(); });
}

std::vector<bool> for_each_index_until_end(std::size_t count, const SearchContext& context,
                                           const std::function<void(std::size_t)>& body) {
  std::vector<char> called(count, 0);  // bits of one word may not be set by several threads
  for_each_index(count, context, [&](std::size_t i) {
    if (i > 0 && context.has_to_end()) return;
    body(i);
    called[i] = 1;
  });
  return {called.begin(), called.end()};
}

}  // namespace tramline
