#include "tramline/route/passes/passes_ahead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "tramline/route/passes/meet_nearer.h"

namespace tramline {
namespace {

/// Places on a pass, and those of its entries that are compared for the place nearest to another pass.
constexpr std::size_t kMostMeetings = 24, kMostCompared = 48;
/// Places of a pass are so far apart, and a radius.
constexpr double kLeastApart_m = 2;
/// Of passes beside one another, to the next but one.
constexpr double kNear_widths = 2.5;

constexpr std::uint32_t bit(std::size_t place) { return std::uint32_t{1} << place; }

std::vector<bool> members_of(std::uint32_t set, std::size_t count) {
  std::vector<bool> out(count);
  for (std::size_t i = 0; i < count; ++i) out[i] = (set & bit(i)) != 0;
  return out;
}

std::vector<Point> evenly_spread(const std::vector<Point>& all) {
  const std::size_t step = std::max<std::size_t>(1, all.size() / kMostCompared);
  std::vector<Point> out;
  for (std::size_t i = 0; i < all.size(); i += step) out.push_back(all[i]);
  return out;
}

std::pair<Point, Point> nearest_pair(const std::vector<Point>& a, const std::vector<Point>& b) {
  std::pair<Point, Point> out{a.front(), b.front()};
  for (const Point p : a)
    for (const Point q : b)
      if (distance(p, q) < distance(out.first, out.second)) out = {p, q};
  return out;
}

/// Places where passes are nearest to one another, and the gate.
std::vector<Point> meeting_places(const std::vector<std::vector<Point>>& passes,
                                  const std::optional<Point>& gate) {
  std::vector<Point> out;
  if (gate) out.push_back(*gate);
  for (std::size_t i = 0; i < passes.size(); ++i)
    for (std::size_t j = i + 1; j < passes.size(); ++j) {
      const auto [p, q] = nearest_pair(passes[i], passes[j]);
      out.push_back(p);
      out.push_back(q);
    }
  return out;
}

/// No more than kMostMeetings of them: those that are near one that was kept are left out.
std::vector<Point> thinned(const std::vector<Point>& all, double apart_m) {
  for (;; apart_m *= 2) {
    std::vector<Point> out;
    for (const Point p : all)
      if (std::ranges::none_of(out, [&](Point kept) { return distance(p, kept) < apart_m; }))
        out.push_back(p);
    if (out.size() <= kMostMeetings) return out;
  }
}

}  // namespace

bool has_its_turn(const PassTask& task, const std::vector<bool>& worked, std::size_t place) {
  if (task.sequence == PassSequence::kAny) return true;
  const std::vector<HeadlandPass>& all = task.headland.passes;
  const HeadlandPass& one = all[task.passes[place]];
  for (std::size_t i = 0; i < task.passes.size(); ++i) {
    const HeadlandPass& other = all[task.passes[i]];
    if (worked[i] || i == place || !along_one_boundary(one, other)) continue;
    if (task.sequence == PassSequence::kInwards ? other.number < one.number : other.number > one.number)
      return false;
  }
  return true;
}

double lane_change_m(double apart_m, double radius_m) {
  if (apart_m >= 2 * radius_m) return std::numbers::pi * radius_m + apart_m - 2 * radius_m;
  return 2 * radius_m * std::acos(1 - apart_m / (2 * radius_m));
}

PassesAhead::PassesAhead(const PassTask& task)
    : radius_m_(task.connector.ground().machine().radius_m),
      near_m_(kNear_widths * task.connector.ground().machine().width_m),
      speed_mps_(task.least.turning_speed_mps()),
      gate_(task.gate) {
  const auto is_open = [&](std::size_t pass) { return !is_closed(task.headland.passes[pass]); };
  if (task.passes.empty() || task.passes.size() > kMost || std::ranges::any_of(task.passes, is_open)) return;
  find_places(task);
  find_times(task);
}

PassesAhead::ClosePlaces PassesAhead::close_places(const std::vector<PassEntry>& entries) {
  ClosePlaces out;
  for (const PassEntry& entry : entries)
    if (entry.sense == Sense::kAlong) out.all.push_back(entry.entered.at);
  for (std::size_t i = 0; i < out.all.size(); ++i)
    out.apart_m = std::max(out.apart_m, distance(out.all[i], out.all[(i + 1) % out.all.size()]));
  return out;
}

std::optional<std::size_t> PassesAhead::ClosePlaces::nearest(Point to, double within_m) const {
  std::optional<std::size_t> out;
  meet_nearer(
      0, all.size(), apart_m, [&](std::size_t i) { return distance(all[i], to); }, [&] { return within_m; },
      [&](std::size_t i, double off_m) {
        within_m = off_m;
        out = i;
      });
  return out;
}

void PassesAhead::find_places(const PassTask& task) {
  std::vector<std::vector<Point>> spread;
  std::size_t numbered = 0;
  for (const std::size_t pass : task.passes) {
    along_.push_back(close_places(task.entries[pass]));
    first_along_.push_back(numbered);
    numbered += along_.back().all.size();
    spread.push_back(evenly_spread(along_.back().all));
  }
  beside_.resize(numbered);
  std::vector<Point> meeting = meeting_places(spread, gate_);
  if (meeting.empty()) meeting.push_back(spread.front().front());
  meeting = thinned(meeting, std::max(kLeastApart_m, radius_m_));
  for (const ClosePlaces& along : along_) {
    std::vector<Point> places;
    for (const Point p : meeting) {
      const Point at = along.all[*along.nearest(p, std::numeric_limits<double>::infinity())];
      if (std::ranges::find(places, at) == places.end()) places.push_back(at);
    }
    first_node_.push_back(nodes_);
    nodes_ += places.size();
    places_.push_back(std::move(places));
  }
}

void PassesAhead::find_times(const PassTask& task) {
  const std::size_t count = task.passes.size();
  const WorkedSet all = bit(count) - 1;
  in_turn_.assign(all + 1, 0);
  from_s_.assign((all + 1) * nodes_, 0);
  for (WorkedSet worked = all + 1; worked-- > 0;) {
    const std::vector<bool> members = members_of(worked, count);
    for (std::size_t i = 0; i < count; ++i)
      if (!members[i] && has_its_turn(task, members, i)) in_turn_[worked] |= bit(i);
    for (std::size_t last = 0; last < count; ++last) {
      if (!members[last]) continue;
      for (std::size_t k = 0; k < places_[last].size(); ++k)
        at(worked, first_node_[last] + k) = between_places_s(worked, places_[last][k]);
    }
  }
}

double PassesAhead::seconds(Point from, Point to) const {
  return lane_change_m(distance(from, to), radius_m_) / speed_mps_;
}

/// By a place of the next pass.
double PassesAhead::between_places_s(WorkedSet worked, Point left) const {
  if (in_turn_[worked] == 0) return gate_ ? distance(left, *gate_) / speed_mps_ : 0;
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t next = 0; next < places_.size(); ++next) {
    if ((in_turn_[worked] & bit(next)) == 0) continue;
    for (std::size_t k = 0; k < places_[next].size(); ++k)
      out = std::min(out, seconds(left, places_[next][k]) + at(worked | bit(next), first_node_[next] + k));
  }
  return out;
}

/// Or straight aside to a pass that lies beside the last one there. `beside(next)`: the place nearest on it.
template <typename Beside>
double PassesAhead::along_neighbours_s(WorkedSet worked, Point left, const Beside& beside) const {
  double out = between_places_s(worked, left);
  for (std::size_t next = 0; next < places_.size(); ++next) {
    if ((in_turn_[worked] & bit(next)) == 0) continue;
    const std::optional<std::size_t> place = beside(next);
    const double aside_s = place ? seconds(left, along_[next].all[*place]) : out;
    if (aside_s < out) out = std::min(out, aside_s + from_place_s(worked | bit(next), next, *place));
  }
  return out;
}

/// From a place on the last pass. The places beside many others are the same, so each is looked at once.
double PassesAhead::from_place_s(WorkedSet worked, std::size_t last, std::size_t place) const {
  const std::size_t number = first_along_[last] + place;
  const std::uint64_t key = (std::uint64_t{number} << kMost) | worked;
  if (const auto known = from_place_s_.find(key); known != from_place_s_.end()) return known->second;
  const Point left = along_[last].all[place];
  std::vector<std::optional<std::size_t>>& beside = beside_[number];
  if (beside.empty())
    for (const ClosePlaces& along : along_) beside.push_back(along.nearest(left, near_m_));
  const double out = along_neighbours_s(worked, left, [&](std::size_t next) { return beside[next]; });
  from_place_s_.emplace(key, out);
  return out;
}

PassesAhead::WorkedSet PassesAhead::set_of(const std::vector<bool>& worked) {
  WorkedSet out = 0;
  for (std::size_t i = 0; i < worked.size(); ++i)
    if (worked[i]) out |= bit(i);
  return out;
}

double PassesAhead::onward_s(const std::vector<bool>& worked, Point left) const {
  if (places_.empty()) return 0;
  return along_neighbours_s(set_of(worked), left,
                            [&](std::size_t next) { return along_[next].nearest(left, near_m_); });
}

double PassesAhead::least_s(const std::vector<bool>& worked) const {
  if (places_.empty()) return 0;
  const WorkedSet set = set_of(worked);
  double out = std::numeric_limits<double>::infinity();
  for (std::size_t next = 0; next < places_.size(); ++next)
    for (std::size_t k = 0; k < places_[next].size() && (in_turn_[set] & bit(next)) != 0; ++k)
      out = std::min(out, at(set | bit(next), first_node_[next] + k));
  return std::isfinite(out) ? out : 0;
}

}  // namespace tramline
