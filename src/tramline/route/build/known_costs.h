#pragma once
// What ways between the ends of lines cost, as far as it is known.

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "tramline/route/build/pair_costs.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/connection/connector.h"
#include "tramline/route/connection/least_seconds.h"
#include "tramline/route/search/end_costs.h"
#include "tramline/route/search/neighbours.h"

namespace tramline {

/// Costs of ways between lines: that of the way found, once it has been looked for, and until then what it
/// costs at least where there is room, with what backing out takes at ends without a way off. Symmetric, as
/// searches need it: where machine and implement sweep differently in the two senses, the mean of both. Not
/// for several threads.
class KnownCosts final : public order::EndCosts {
 public:
  /// All outlive the costs.
  KnownCosts(const std::vector<RouteLine>& lines, const Connector& connector, const LeastSeconds& least);

  std::size_t lines() const override { return lines_.size(); }
  double between(order::End a, order::End b) const override;
  double least(order::End a, order::End b) const override {
    return std::min(least_.crude(left_[a], entered_[b]), least_.crude(left_[b], entered_[a]));
  }
  double at_start(order::End entered) const override { return at_start_[entered]; }
  double at_finish(order::End left) const override { return at_finish_[left]; }

  /// The way from one end to another, found when it is first asked for. Precondition: ends of different
  /// lines.
  const Way& way(order::End left, order::End entered);

  /// The way that was found supposes a way before the first line by which the machine does not come there: it
  /// has no room. Precondition: it was looked for, and is Way::supposed.
  void refuse_supposed(order::End left, order::End entered);

  /// From now on a way that was not looked for is expected to cost more where others from its two ends have
  /// been found: a share of what the best of those cost more than at least. Where headlands are shallow for
  /// one way, they are for others; where they are not, only lower bounds lead to the quickest order.
  void expect_more();

  /// For each end the ends that are quickest reached from it, whatever room there is. Those are looked for of
  /// which a cost has changed since it was last asked.
  const order::Neighbours& neighbours();

  /// What the way to a line costs that the route begins with, and that from the line that it ends with, by
  /// the end entered or left; 0 until set.
  void set_start(order::End entered, double cost_s) { at_start_[entered] = cost_s; }
  /// Finds the way to the line that the route begins with.
  using WayToFirst = std::function<Way(order::End entered)>;
  void set_way_to_first(WayToFirst find) { to_first_ = std::move(find); }
  /// The same of the way from the line that it ends with, of which only the cost is kept.
  using WayFromLast = std::function<Way(order::End left)>;
  void set_way_from_last(WayFromLast find) { from_last_ = std::move(find); }
  /// Looks for these, once for each end: what they cost is known from then on. Nothing where no way was set.
  void settle_start(order::End entered);
  void settle_finish(order::End left);
  /// Whether the way to the first line has room, as far as it is settled. (That from the last line may have
  /// it all the same by the way on which the machine comes to that line.)
  bool starts_with_room(order::End entered) const;
  /// Precondition: settled, and a way leads there.
  const Way& way_to_first(order::End entered) const { return ways_to_first_.at(entered); }
  void set_finish(order::End left, double cost_s) { at_finish_[left] = cost_s; }

 private:
  void look_at_nearest();
  double estimate(order::End left, order::End entered) const;
  double one_way(order::End left, order::End entered) const;
  double both_ways(order::End a, order::End b) const;
  /// What a way that was looked for tells of other ways of its ends.
  void learn(order::End left, order::End entered, const Way& way);
  bool is_dead(order::End end) const;
  /// Of one way, or of all.
  void cost_has_changed(order::End left, order::End entered);
  void costs_have_changed();
  std::uint64_t key(order::End left, order::End entered) const {
    return static_cast<std::uint64_t>(left) * 2 * lines_.size() + entered;
  }

  const std::vector<RouteLine>& lines_;
  const Connector& connector_;
  const LeastSeconds& least_;
  double far_m_ = 0;
  std::vector<Pose> left_;
  std::vector<Pose> entered_;
  order::Neighbours looked_at_;
  order::Neighbours neighbours_;   ///< of the ends that are not stale
  std::vector<bool> are_stale_;    ///< by end: its neighbours
  std::vector<double> backing_s_;  ///< by end: what backing out of it or into it takes; 0 with a way off
  bool expects_more_ = false;
  /// By end: the least that a way with room costs more than estimated.
  std::vector<std::optional<double>> more_s_;
  std::vector<int> lacking_;  ///< by end: of its ways to ends that are not dead so many had no room
  std::vector<double> at_start_;
  std::vector<double> at_finish_;
  std::unordered_map<std::uint64_t, Way> ways_;
  WayToFirst to_first_{};
  std::unordered_map<order::End, Way> ways_to_first_{};
  WayFromLast from_last_{};
  std::unordered_set<order::End> settled_finishes_{};
  mutable PairCosts between_;
};

}  // namespace tramline
