#pragma once
// Places to enter passes at, in the order of the time it takes to get there and on from there.

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
  double least_s = 0;  ///< a way forward takes no less, with what lies ahead where that is asked for
};

/// Choices, those first that take least by a way forward and with what lies ahead, of equal ones the first
/// given. What they take is computed only of those that the straight line does not put behind the ones asked
/// for.
class NearestEntries {
 public:
  /// What lies ahead once the pass of a choice is worked takes, s: not negative. The choice by its place.
  using Ahead = std::function<double(std::size_t)>;

  /// `least` and the entries outlive the object. `all` without their least times. Without `ahead` nothing
  /// lies ahead. O(n) for n choices.
  NearestEntries(const Pose& left, const LeastSeconds& least, std::vector<EntryChoice> all, Ahead ahead = {});

  std::size_t size() const { return all_.size(); }
  /// O(log n) for each up to the rank. Precondition: rank < size().
  const EntryChoice& at(std::size_t rank);
  /// The place of that in what was given.
  std::size_t place_at(std::size_t rank) const { return ranked_[rank]; }

 private:
  using Timed = std::pair<double, std::size_t>;
  using Soonest = std::priority_queue<Timed, std::vector<Timed>, std::greater<>>;
  void add_next();

  Pose left_;
  const LeastSeconds* least_;
  std::vector<EntryChoice> all_;
  Ahead ahead_;
  Soonest waiting_{}, measured_{};
  std::vector<std::size_t> ranked_{};
};

}  // namespace tramline
