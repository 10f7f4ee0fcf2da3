#include "tramline/route/build/known_costs.h"

#include <algorithm>
#include <cassert>

#include "tramline/route/order/point_grid.h"
#include "tramline/turns/turn_off.h"

namespace tramline {
namespace {

/// A way without room costs as if it were so much longer, s, for each metre that is missing and at all: it is
/// taken where there is no other.
constexpr double kWithoutRoom_s = 1000;
/// A way from the last line may have room by the way on which the machine comes to that line. One without as
/// far as is known costs so much more, s, less than any that has none for sure.
constexpr double kDoubtful_s = 500;
static_assert(kDoubtful_s < kWithoutRoom_s);
/// Backing out of a dead end takes about so many radii there and back.
constexpr double kBacking_radii = 1.5;

/// Ends farther apart than so many widths of a turn are reached along the headland, which is about so much
/// farther.
constexpr double kFar_turns = 3, kRoundAbout = 1.5;

/// What ways cost more than foreseen is due to both of their ends, and less of it to be expected of others.
constexpr double kOfEachEnd = 0.35;

/// An end is dead where so many ways lack room and none has it.
constexpr int kDead = 3;

double cost_of(const Way& way) {
  return way.has_room() ? way.cost_s : way.cost_s + kWithoutRoom_s * (1 + way.missing_m);
}

}  // namespace

KnownCosts::KnownCosts(const std::vector<RouteLine>& lines, const Connector& connector,
                       const LeastSeconds& least)
    : lines_(lines),
      connector_(connector),
      least_(least),
      neighbours_(2 * lines.size()),
      are_stale_(2 * lines.size(), true),
      backing_s_(2 * lines.size(), 0),
      more_s_(2 * lines.size()),
      lacking_(2 * lines.size(), 0),
      at_start_(2 * lines.size(), 0),
      at_finish_(2 * lines.size(), 0),
      between_(2 * lines.size() * order::NeighbourCounts{}.looked_at) {
  const DrivingGround& ground = connector.ground();
  const Turning& turning = ground.machine().turning;
  far_m_ = kFar_turns * 2 * (ground.machine().radius_m + ground.machine().width_m);
  const double back_m = kBacking_radii * std::max(ground.machine().radius_m, ground.machine().width_m);
  for (order::End end = 0; end < 2 * lines.size(); ++end) {
    const RouteLine& line = lines[order::line_of(end)];
    left_.push_back(pose_left_by(line, end));
    entered_.push_back(pose_entered_by(line, end));
    const bool leads_off = std::ranges::any_of(ways_off(left_.back(), ground.machine()),
                                               [&](const SteeredPath& way) { return ground.has_room(way); });
    if (!leads_off)
      backing_s_[end] = connector.terms().stop_s + 2 * turning.gear_change_s +
                        back_m / turning.reverse_speed_mps + back_m / turning.turning_speed_mps;
  }
  look_at_nearest();
}

/// The straight lines from where an end is left to where others are entered decide.
void KnownCosts::look_at_nearest() {
  const std::size_t looked_at = order::NeighbourCounts{}.looked_at;
  std::vector<Point> places;
  for (const Pose& entered : entered_) places.push_back(entered.at);
  const order::PointGrid grid(places);
  for (order::End end = 0; end < left_.size(); ++end) {
    std::vector<std::size_t> nearest = grid.nearest(left_[end].at, looked_at + 2);
    std::erase_if(nearest, [&](std::size_t other) { return order::line_of(other) == order::line_of(end); });
    nearest.resize(std::min(nearest.size(), looked_at));
    looked_at_.push_back(std::move(nearest));
  }
}

double KnownCosts::estimate(order::End left, order::End entered) const {
  const bool far = distance(left_[left].at, entered_[entered].at) > far_m_;
  const double least_s = far ? kRoundAbout * least_.forward(left_[left], entered_[entered])
                             : least_.between(left_[left], entered_[entered]);
  return least_s + backing_s_[left] + backing_s_[entered];
}

double KnownCosts::one_way(order::End left, order::End entered) const {
  const auto found = ways_.find(key(left, entered));
  if (found != ways_.end()) return cost_of(found->second);
  const double least_s = estimate(left, entered);
  if (is_dead(left) || is_dead(entered)) return least_s + kWithoutRoom_s;
  if (!expects_more_) return least_s;
  return least_s + kOfEachEnd * (more_s_[left].value_or(0) + more_s_[entered].value_or(0));
}

double KnownCosts::both_ways(order::End a, order::End b) const {
  const bool there = ways_.contains(key(a, b)), back = ways_.contains(key(b, a));
  if (there == back) return 0.5 * (one_way(a, b) + one_way(b, a));
  return there ? one_way(a, b) : one_way(b, a);
}

double KnownCosts::between(order::End a, order::End b) const {
  return between_.known_or(a, b, [&] { return both_ways(a, b); });
}

const order::Neighbours& KnownCosts::neighbours() {
  const auto cost = [this](std::size_t a, std::size_t b) { return between(a, b); };
  for (order::End end = 0; end < neighbours_.size(); ++end)
    if (are_stale_[end]) neighbours_[end] = order::cheapest_of(end, looked_at_[end], cost);
  are_stale_.assign(are_stale_.size(), false);
  return neighbours_;
}

void KnownCosts::cost_has_changed(order::End left, order::End entered) {
  between_.change(left, entered, both_ways(left, entered));
  are_stale_[left] = are_stale_[entered] = true;
}

void KnownCosts::costs_have_changed() {
  between_.clear();
  are_stale_.assign(are_stale_.size(), true);
}

void KnownCosts::settle_start(order::End entered) {
  if (!to_first_ || ways_to_first_.contains(entered)) return;
  Way way = to_first_(entered);
  at_start_[entered] = cost_of(way);
  ways_to_first_.emplace(entered, std::move(way));
}

void KnownCosts::settle_finish(order::End left) {
  if (!from_last_ || !settled_finishes_.insert(left).second) return;
  const Way way = from_last_(left);
  at_finish_[left] = way.cost_s + (way.has_room() ? 0 : kDoubtful_s);
}

bool KnownCosts::starts_with_room(order::End entered) const {
  const auto first = ways_to_first_.find(entered);
  return first == ways_to_first_.end() || first->second.has_room();
}

const Way& KnownCosts::way(order::End left, order::End entered) {
  assert(order::line_of(left) != order::line_of(entered));
  const auto found = ways_.find(key(left, entered));
  if (found != ways_.end()) return found->second;
  Way way = connector_.between_as_come(lines_[order::line_of(left)].left_by(left).last,
                                       lines_[order::line_of(entered)].entered_by(entered).first);
  const auto ends_are_dead = [&] { return std::pair(is_dead(left), is_dead(entered)); };
  const auto before = ends_are_dead();
  learn(left, entered, way);
  const Way& out = ways_.emplace(key(left, entered), std::move(way)).first->second;
  // What is learnt of an end may count for all of its ways.
  if (expects_more_ || ends_are_dead() != before)
    costs_have_changed();
  else
    cost_has_changed(left, entered);
  return out;
}

void KnownCosts::refuse_supposed(order::End left, order::End entered) {
  Way& way = ways_.at(key(left, entered));
  assert(way.supposed);
  way = connector_.between(lines_[order::line_of(left)].left_by(left).last,
                           lines_[order::line_of(entered)].entered_by(entered).first);
  cost_has_changed(left, entered);
}

void KnownCosts::expect_more() {
  expects_more_ = true;
  costs_have_changed();
}

bool KnownCosts::is_dead(order::End end) const { return !more_s_[end] && lacking_[end] >= kDead; }

void KnownCosts::learn(order::End left, order::End entered, const Way& way) {
  if (way.has_room()) {
    const double more_s = way.cost_s - estimate(left, entered);
    for (const order::End end : {left, entered})
      more_s_[end] = std::min(more_s_[end].value_or(more_s), more_s);
    return;
  }
  const bool left_dead = is_dead(left), entered_dead = is_dead(entered);
  if (!entered_dead) ++lacking_[left];
  if (!left_dead) ++lacking_[entered];
}

}  // namespace tramline
