#include "tramline/planner/vary/left_out_tracks.h"

#include <algorithm>
#include <cassert>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/planner/whole/dropped_tracks.h"

namespace tramline {
namespace {

/// Tracks are left out of so many plans at the most, and so many runs of them are tried alone.
constexpr std::size_t kDropsOf = 6, kTriedAlone = 3;
/// Tracks that are ordered to that end, in all such routes: as many as six of 250 have, or thirty of 50.
constexpr std::size_t kRoutedForDrops = 1500;

class Drops {
 public:
  explicit Drops(RouteComparison& plans) : plans_(plans) {}

  void drop_tracks_of(std::size_t i) {
    ComparedPlan entry = plans_.plans()[i];
    while (drops_some(entry)) continue;
    if (*entry.price < plans_.least_price()) plans_.take(std::move(entry));
  }

 private:
  /// Drops all runs of tracks at once that are not worth their ways; where that does not save what is worth
  /// it the better half of them, and so on; or else one of the next best. A dearer plan than the best one
  /// that is no cheaper without all of them is left as it is: without fewer it hardly ever is.
  bool drops_some(ComparedPlan& entry) {
    const std::vector<PieceRun> runs = not_worth_their_ways(entry.laid.trial);
    if (expected_without(runs, entry) >= plans_.least_price()) return false;
    for (std::size_t count = runs.size(); count > 0; count /= 2) {
      auto less = routed_without({runs.begin(), runs.begin() + static_cast<std::ptrdiff_t>(count)}, entry);
      if (!less) return false;
      if (takes(*less, entry)) return true;
      if (count == runs.size() && is_dearer(entry) && !is_cheaper(*less)) return false;
    }
    for (std::size_t next = 1; next < std::min(runs.size(), kTriedAlone); ++next)
      if (auto less = routed_without({runs[next]}, entry); less && takes(*less, entry)) return true;
    return false;
  }

  bool is_dearer(const ComparedPlan& plan) const { return *plan.price > plans_.least_price(); }
  bool is_cheaper(const ComparedPlan& plan) const { return *plan.price < plans_.least_price(); }

  /// The same plan without some tracks, with its route; nothing once enough of them were planned.
  std::optional<ComparedPlan> routed_without(const std::vector<PieceRun>& runs, const ComparedPlan& entry) {
    routed_ += entry.plan().pieces.size();
    if (routed_ > kRoutedForDrops || plans_.has_to_end()) return std::nullopt;
    ComparedPlan less = entry;
    less.laid.trial = without(runs, std::move(less.laid.trial));
    plans_.plan_route(less);
    return less;
  }

  /// What saves too little for the land that it leaves is not told of either: it may cost less than the plan.
  bool takes(ComparedPlan& less, ComparedPlan& entry) {
    if (!is_worth_dropping(entry.plan(), less.plan())) return false;
    plans_.tell_of(less);
    entry = std::move(less);
    return true;
  }

  RouteComparison& plans_;
  std::size_t routed_ = 0;  ///< tracks, so far
};

}  // namespace

void leave_out_tracks(RouteComparison& plans) {
  assert(plans.has_best());
  std::vector<Hopeful> hopeful = hopeful_without_tracks(plans.plans(), plans.least_price());
  if (hopeful.size() > kDropsOf) hopeful.resize(kDropsOf);
  Drops drops(plans);
  for (const Hopeful& one : hopeful)
    if (!plans.has_to_end() && one.expected < plans.least_price()) drops.drop_tracks_of(one.plan);
}

}  // namespace tramline
