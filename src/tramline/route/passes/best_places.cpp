#include "tramline/route/passes/best_places.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "tramline/route/passes/nearest_entries.h"
#include "tramline/route/passes/passes_ahead.h"

namespace tramline {
namespace {

/// Places of a closed pass, at most so far apart, or so many each way round.
constexpr double kPlaceSpacing_m = 0.5, kMostPlaces = 1000;
/// So many ways are looked for at the most.
constexpr int kMostWays = 500;

/// A* over places of the passes in the order of a tour.
class PlaceSearch {
 public:
  PlaceSearch(const PassTask& task, const std::vector<std::size_t>& order) : task_(task), order_(order) {
    const Turning& turning = task.connector.ground().machine().turning;
    for (const std::size_t i : order) {
      const HeadlandPass& pass = task.headland.passes[i];
      places_.push_back(
          entries_of(pass, std::max(kPlaceSpacing_m, length(pass.path) / kMostPlaces), turning));
      settled_.emplace_back(places_.back().size(), false);
    }
    ahead_s_.assign(order.size() + 1, 0);
    for (std::size_t i = order.size() - 1; i > 0; --i) ahead_s_[i] = ahead_s_[i + 1] + foreseen_s(i);
    ahead_s_[0] = ahead_s_[1];
  }

  /// The tour of least time below the limit, of those that the search finds.
  std::optional<std::vector<WorkedPass>> within(double limit_s, const SteeredPath& left) {
    limit_s_ = limit_s;
    begin(left);
    for (int tried = 0; tried < kMostWays && !events_.empty();) {
      const Event next = events_.top();
      events_.pop();
      if (next.seconds >= limit_s_) break;
      if (next.is_way_on) {
        ++tried;
        try_next_way(next.state);
      } else if (states_[next.state].worked == order_.size()) {
        return tour_to(next.state);
      } else {
        settle(next.state);
      }
    }
    return std::nullopt;
  }

 private:
  /// So many passes are worked, and the machine is where the last of them was entered and left.
  struct State {
    std::size_t worked = 0;
    const PassEntry* entry = nullptr;  ///< of the last; none before the first
    Pose left{};
    double seconds = 0;      ///< of all ways up to there
    std::size_t before = 0;  ///< the state that the way led from
    Way way{};
    std::optional<NearestEntries> onward{};  ///< to the next pass
    std::size_t tried = 0;                   ///< of these
  };

  /// A state, or the next way on from one, which was not looked for yet.
  struct Event {
    double seconds = 0;  ///< up to there, and foreseen from there on
    std::size_t state = 0;
    bool is_way_on = false;
    friend bool operator>(const Event& a, const Event& b) {
      return std::tie(a.seconds, a.state, a.is_way_on) > std::tie(b.seconds, b.state, b.is_way_on);
    }
  };

  /// To a pass from the one before it.
  double foreseen_s(std::size_t at) const {
    const Machine& machine = task_.connector.ground().machine();
    const int lanes = task_.headland.passes[order_[at]].number - task_.headland.passes[order_[at - 1]].number;
    return lane_change_m(std::abs(lanes) * machine.width_m, machine.radius_m) /
           task_.least.turning_speed_mps();
  }

  void begin(const SteeredPath& left) {
    State first;
    if (left.empty()) {
      first.worked = 1;
      first.left = task_.entries[order_.front()].front().left;
    } else {
      first.left = end_of(left);
    }
    reach(std::move(first));
  }

  /// From a pose on once so many passes are worked.
  double ahead_s(std::size_t worked, const Pose& left) const {
    return std::max(ahead_s_[worked], to_gate_s(task_, left));
  }

  void reach(State state) {
    events_.push({state.seconds + ahead_s(state.worked, state.left), states_.size(), false});
    states_.push_back(std::move(state));
  }

  /// Whether the pass was left from there before, by a quicker way.
  bool is_settled(const State& state) const {
    return state.entry != nullptr && settled_[state.worked - 1][place_of(state)];
  }
  std::size_t place_of(const State& state) const {
    return static_cast<std::size_t>(state.entry - places_[state.worked - 1].data());
  }

  /// No way to this state is quicker: others lead on from it.
  void settle(std::size_t at) {
    State& state = states_[at];
    if (is_settled(state)) return;
    if (state.entry != nullptr) settled_[state.worked - 1][place_of(state)] = true;
    const std::size_t next = state.worked;
    const double within_s = limit_s_ - state.seconds - ahead_s_[next + 1];
    std::vector<EntryChoice> near;
    for (const PassEntry& entry : places_[next])
      if (task_.least.crude(state.left, entry.entered) < within_s) near.push_back({order_[next], &entry});
    state.onward.emplace(state.left, task_.least, std::move(near));
    await_next_way(at);
  }

  void await_next_way(std::size_t from) {
    State& state = states_[from];
    if (state.tried == state.onward->size()) return;
    const EntryChoice& next = state.onward->at(state.tried);
    events_.push({state.seconds + next.least_s + ahead_s(state.worked + 1, next.entry->left), from, true});
  }

  void try_next_way(std::size_t from) {
    State next;
    next.worked = states_[from].worked + 1;
    next.entry = states_[from].onward->at(states_[from].tried++).entry;
    await_next_way(from);
    if (is_settled(next)) return;
    std::optional<Way> way = task_.connector.direct(states_[from].left, next.entry->entered);
    if (!way) return;
    next.left = next.entry->left;
    next.seconds = states_[from].seconds + way->time_s;
    next.before = from;
    next.way = std::move(*way);
    reach(std::move(next));
  }

  std::vector<WorkedPass> tour_to(std::size_t last) const {
    std::vector<WorkedPass> out;
    for (const std::size_t pass : order_) out.push_back({pass, task_.entries[pass].front(), {}});
    for (std::size_t at = last; states_[at].entry != nullptr; at = states_[at].before) {
      WorkedPass& worked = out[states_[at].worked - 1];
      worked.entry = *states_[at].entry;
      worked.before = states_[at].way;
    }
    return out;
  }

  const PassTask& task_;
  const std::vector<std::size_t>& order_;
  std::vector<std::vector<PassEntry>> places_{};  ///< by place in the order
  std::vector<std::vector<bool>> settled_{};      ///< of the places
  std::vector<double> ahead_s_{};                 ///< foreseen once so many passes are worked
  double limit_s_ = 0;
  std::vector<State> states_{};
  std::priority_queue<Event, std::vector<Event>, std::greater<>> events_{};
};

}  // namespace

std::optional<std::vector<WorkedPass>> at_best_places(const PassTask& task,
                                                      const std::vector<std::size_t>& order,
                                                      const SteeredPath& left, double limit_s) {
  assert(!order.empty());
  if (left.empty() && order.size() == 1) return std::nullopt;
  return PlaceSearch(task, order).within(limit_s, left);
}

}  // namespace tramline
