#include "tramline/planner/sweep_search.h"

#include <mutex>

#include "tramline/decomposition/candidate_directions.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

/// The best candidate so far, whatever the order in which candidates arrive.
class Incumbent {
 public:
  Incumbent(int total, const Progress& progress) : total_(total), progress_(progress) {}

  void offer(Candidate candidate, std::size_t index) {
    const std::lock_guard lock(mutex_);
    const bool better = best_index_ == kNone || candidate.cost() < best_.cost() ||
                        (candidate.cost() == best_.cost() && index < best_index_);
    if (better) {
      best_ = std::move(candidate);
      best_index_ = index;
    }
    ++done_;
    if (progress_) progress_(done_, total_);
  }

  Candidate take() { return std::move(best_); }

 private:
  static constexpr std::size_t kNone = static_cast<std::size_t>(-1);
  std::mutex mutex_;
  Candidate best_;
  std::size_t best_index_ = kNone;
  int done_ = 0;
  int total_;
  const Progress& progress_;
};

}  // namespace

SweepResult sweep_search(const SearchTask& task, int threads, const Progress& progress) {
  const std::vector<Direction> directions = candidate_directions(task.field);
  const int total = static_cast<int>(directions.size());
  Incumbent incumbent(total, progress);
  for_each_index(directions.size(), threads,
                 [&](std::size_t i) { incumbent.offer(evaluate(task, directions[i]), i); });
  return {incumbent.take(), total};
}

}  // namespace tramline
