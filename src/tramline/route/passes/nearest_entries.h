#pragma once
// Places to enter passes at, in the order of the time it takes to get there.

#include <cstddef>
#include <functional>
#include <queue>
#include <utility>
#include <vector>

#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/passes/pass_entries.h"

namespace tramline {

struct EntryChoice {
  std::size_t pass = 0;  ///< index into Headland::passes
  const PassEntry* entry = nullptr;
  double least_s = 0;  ///< no way forward takes less
};

/// Choices, those that take least by a way forward first, of equal ones the first given. What they take is
/// computed only of those that the straight line does not put behind the ones asked for.
class NearestEntries {
 public:
  /// `least` and the entries outlive the object. `all` without their times. O(n) for n choices.
  NearestEntries(const Pose& left, const LeastSeconds& least, std::vector<EntryChoice> all);

  std::size_t size() const { return all_.size(); }
  /// O(log n) for each up to the rank. Precondition: rank < size().
  const EntryChoice& at(std::size_t rank);

 private:
  using Timed = std::pair<double, std::size_t>;
  using Soonest = std::priority_queue<Timed, std::vector<Timed>, std::greater<>>;
  void add_next();

  Pose left_;
  const LeastSeconds* least_;
  std::vector<EntryChoice> all_;
  Soonest waiting_{}, measured_{};
  std::vector<std::size_t> ranked_{};
};

}  // namespace tramline
