#include "tramline/route/passes/pass_tour.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <utility>

#include "tramline/route/passes/best_places.h"
#include "tramline/route/passes/next_pass.h"

namespace tramline {
namespace {

std::vector<WorkedPass> one_after_another(const PassTask& task, SteeredPath left, Foresight foresight) {
  NextPass next(task, foresight);
  std::vector<WorkedPass> out;
  while (out.size() < task.passes.size()) {
    out.push_back(left.empty() ? next.first() : next.after(left).pass);
    const WorkedPass& last = out.back();
    next.work(last.pass);
    left = driven_forward(
        left, last.before,
        axle_path(task.headland.passes[last.pass], last.entry, task.connector.ground().machine().turning));
  }
  return out;
}

bool leads_forward(const WorkedPass& worked) {
  return worked.before.has_room() && !worked.before.backs_out && !worked.before.backs_in;
}

/// How many ways lack room, and what all cost, that to the gate included, s.
std::pair<std::ptrdiff_t, double> effort_of(const std::vector<WorkedPass>& tour, const PassTask& task) {
  std::pair<std::ptrdiff_t, double> out{0, to_gate_s(task, tour.back().entry.left)};
  for (const WorkedPass& worked : tour) {
    if (!worked.before.has_room()) ++out.first;
    out.second += worked.before.cost_s;
  }
  return out;
}

/// The first, unless the other lacks room less often or takes less.
std::vector<WorkedPass> better(std::vector<WorkedPass> first, std::vector<WorkedPass> other,
                               const PassTask& task) {
  if (effort_of(other, task) < effort_of(first, task)) return other;
  return first;
}

constexpr std::array kBothSequences = {PassSequence::kOutwards, PassSequence::kInwards};

/// The tour, or one outwards or inwards that has room more often, or takes less.
std::vector<WorkedPass> with_more_room(std::vector<WorkedPass> tour, const PassTask& task,
                                       const SteeredPath& left) {
  if (task.sequence != PassSequence::kAny) return tour;
  for (const PassSequence sequence : kBothSequences) {
    PassTask ordered = task;
    ordered.sequence = sequence;
    tour = better(std::move(tour), one_after_another(ordered, left, Foresight::kAhead), task);
  }
  return tour;
}

/// What lies ahead is foreseen along straight lines: where land lies between that nobody drives over, the
/// nearest pass may be the better choice.
std::vector<WorkedPass> with_foresight_or_without(const PassTask& task, const SteeredPath& left) {
  std::vector<WorkedPass> tour = one_after_another(task, left, Foresight::kAhead);
  if (task.passes.size() < 2) return tour;
  return better(std::move(tour), one_after_another(task, left, Foresight::kNone), task);
}

bool all_along_one_boundary(const std::vector<std::size_t>& order, const Headland& headland) {
  return std::ranges::all_of(order, [&](std::size_t pass) {
    return along_one_boundary(headland.passes[order.front()], headland.passes[pass]);
  });
}

/// By number, the innermost first or last; those of one number as in `order`.
std::vector<std::size_t> by_number(std::vector<std::size_t> order, PassSequence sequence,
                                   const Headland& headland) {
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const int first = headland.passes[a].number, second = headland.passes[b].number;
    return sequence == PassSequence::kInwards ? first < second : first > second;
  });
  return order;
}

/// Less is not worth other places, s.
constexpr double kLeastSaved_s = 0.1;

/// The tour, or one in its order, outwards or inwards that enters its passes at better places.
std::vector<WorkedPass> at_better_places(std::vector<WorkedPass> tour, const PassTask& task,
                                         const SteeredPath& left) {
  std::vector<std::size_t> order;
  for (const WorkedPass& worked : tour) order.push_back(worked.pass);
  if (!all_along_one_boundary(order, task.headland)) return tour;
  std::vector<std::vector<std::size_t>> orders{order};
  if (task.sequence == PassSequence::kAny)
    for (const PassSequence sequence : kBothSequences)
      if (std::vector<std::size_t> other = by_number(order, sequence, task.headland); other != orders.front())
        orders.push_back(std::move(other));
  // Where the search with the gate comes to no end, places that take least up to the last pass may do.
  PassTask anywhere = task;
  anywhere.gate.reset();
  for (const std::vector<std::size_t>& passes : orders) {
    const double limit_s = effort_of(tour, task).second - kLeastSaved_s;
    auto better = at_best_places(task, passes, left, limit_s);
    if (!better && task.gate) better = at_best_places(anywhere, passes, left, limit_s);
    if (better && effort_of(*better, task).second < limit_s) tour = std::move(*better);
  }
  return tour;
}

}  // namespace

std::vector<WorkedPass> pass_tour(const PassTask& task, const SteeredPath& left) {
  assert(!task.passes.empty());
  std::vector<WorkedPass> tour = with_foresight_or_without(task, left);
  // What works behind the axle swings over the edge where the machine turns off a pass beside it: that pass
  // is best worked last, or before all others.
  return std::ranges::all_of(tour, leads_forward) ? at_better_places(std::move(tour), task, left)
                                                  : with_more_room(std::move(tour), task, left);
}

}  // namespace tramline
