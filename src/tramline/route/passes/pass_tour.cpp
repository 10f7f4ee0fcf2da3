#include "tramline/route/passes/pass_tour.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/route/passes/best_places.h"
#include "tramline/route/passes/nearest_entries.h"

namespace tramline {
namespace {

/// Of the entries of the nearest passes so many are tried for room, the quickest first.
constexpr std::size_t kMostTried = 120;
/// Where none of them has direct room, so many are looked for along the lines of the roadmap; where these
/// have none either, so many of every pass and sense.
constexpr std::size_t kMostSearched = 12;
constexpr std::size_t kSearchedOfEach = 8;

class PassTour {
 public:
  explicit PassTour(const PassTask& task)
      : headland_(task.headland),
        entries_(task.entries),
        sequence_(task.sequence),
        connector_(task.connector),
        least_(task.least),
        passes_(task.passes.size()),
        done_(task.headland.passes.size(), true) {
    for (const std::size_t pass : task.passes) done_[pass] = false;
  }

  std::vector<WorkedPass> from(SteeredPath left) {
    std::vector<WorkedPass> out;
    while (out.size() < passes_) {
      out.push_back(left.empty() ? first() : next(left));
      const WorkedPass& worked = out.back();
      done_[worked.pass] = true;
      left = driven_forward(left, worked.before, axle(worked.pass, worked.entry));
    }
    return out;
  }

  /// The quickest of the direct ways with room; where none of those to the nearest entries has any, the way
  /// of least cost to one of these.
  WorkedPass next(const SteeredPath& left) const {
    NearestEntries all = choices(end_of(left));
    WorkedPass best;
    double best_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(all.size(), kMostTried); ++i) {
      const EntryChoice& one = all.at(i);
      if (one.least_s >= best_s) break;
      std::optional<Way> way = connector_.direct(end_of(left), one.entry->entered);
      if (!way || way->time_s >= best_s) continue;
      best_s = way->time_s;
      best = {one.pass, *one.entry, std::move(*way)};
    }
    return best_s < std::numeric_limits<double>::infinity() ? best : by_search(left, all);
  }

 private:
  SteeredPath axle(std::size_t pass, const PassEntry& entry) const {
    return axle_path(headland_.passes[pass], entry, connector_.ground().machine().turning);
  }

  /// Whether no pass along the same boundary has to come before.
  bool has_its_turn(std::size_t pass) const {
    if (sequence_ == PassSequence::kAny) return true;
    const HeadlandPass& one = headland_.passes[pass];
    for (std::size_t i = 0; i < done_.size(); ++i) {
      if (done_[i] || i == pass || !along_one_boundary(one, headland_.passes[i])) continue;
      const int other = headland_.passes[i].number;
      if (sequence_ == PassSequence::kInwards ? other < one.number : other > one.number) return false;
    }
    return true;
  }

  /// Where nothing came before: the outermost pass, or the innermost where passes go outwards.
  WorkedPass first() const {
    std::size_t best = 0;
    while (done_[best] || !has_its_turn(best)) ++best;
    return {best, entries_[best].front(), {}};
  }

  NearestEntries choices(const Pose& left) const {
    std::vector<EntryChoice> out;
    for (std::size_t pass = 0; pass < done_.size(); ++pass) {
      if (done_[pass] || !has_its_turn(pass)) continue;
      for (const PassEntry& entry : entries_[pass]) out.push_back({pass, &entry});
    }
    return {left, least_, std::move(out)};
  }

  WorkedPass by_search(const SteeredPath& left, NearestEntries& all) const {
    std::vector<EntryChoice> nearest;
    for (std::size_t i = 0; i < std::min(all.size(), kMostSearched); ++i) nearest.push_back(all.at(i));
    WorkedPass out = to_any(left, nearest);
    if (out.before.has_room()) return out;
    WorkedPass farther = to_any(left, all_round());
    return farther.before.has_room() ? farther : out;
  }

  /// Entries of every pass whose turn it is, evenly spread.
  std::vector<EntryChoice> all_round() const {
    std::vector<EntryChoice> out;
    for (std::size_t pass = 0; pass < done_.size(); ++pass) {
      if (done_[pass] || !has_its_turn(pass)) continue;
      const std::size_t step = std::max<std::size_t>(1, entries_[pass].size() / (2 * kSearchedOfEach));
      for (std::size_t i = 0; i < entries_[pass].size(); i += step)
        out.push_back({pass, &entries_[pass][i], 0});
    }
    return out;
  }

  WorkedPass to_any(const SteeredPath& left, const std::vector<EntryChoice>& choices) const {
    std::vector<SteeredPath> entered;
    for (const EntryChoice& choice : choices) entered.push_back(axle(choice.pass, *choice.entry));
    Connector::WayToOne found = connector_.to_any(left, entered);
    const EntryChoice& choice = choices[found.chosen];
    return {choice.pass, *choice.entry, std::move(found.way)};
  }

  const Headland& headland_;
  const EntriesByPass& entries_;
  PassSequence sequence_;
  const Connector& connector_;
  const LeastSeconds& least_;
  std::size_t passes_;
  std::vector<bool> done_;  ///< or none of those asked for
};

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

constexpr std::array kBothSequences = {PassSequence::kOutwards, PassSequence::kInwards};

/// The tour, or one outwards or inwards that has room more often, or takes less.
std::vector<WorkedPass> with_more_room(std::vector<WorkedPass> tour, const PassTask& task,
                                       const SteeredPath& left) {
  if (task.sequence != PassSequence::kAny) return tour;
  for (const PassSequence sequence : kBothSequences) {
    PassTask ordered = task;
    ordered.sequence = sequence;
    std::vector<WorkedPass> other = PassTour(ordered).from(left);
    if (effort_of(other, task) < effort_of(tour, task)) tour = std::move(other);
  }
  return tour;
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
  std::vector<WorkedPass> tour = PassTour(task).from(left);
  // What works behind the axle swings over the edge where the machine turns off a pass beside it: that pass
  // is best worked last, or before all others.
  return std::ranges::all_of(tour, leads_forward) ? at_better_places(std::move(tour), task, left)
                                                  : with_more_room(std::move(tour), task, left);
}

WorkedPass nearest_pass(const PassTask& task, const SteeredPath& left) {
  assert(!task.passes.empty() && !left.empty());
  return PassTour(task).next(left);
}

}  // namespace tramline
