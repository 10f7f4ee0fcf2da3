#include "tramline/route/passes/pass_tour.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <limits>
#include <queue>
#include <utility>

namespace tramline {
namespace {

/// Of the entries of the nearest passes so many are tried for room, the quickest first.
constexpr std::size_t kMostTried = 120;
/// Where none of them has direct room, so many are looked for along the lines of the roadmap; where these
/// have none either, so many of every pass and sense.
constexpr std::size_t kMostSearched = 12;
constexpr std::size_t kSearchedOfEach = 8;

struct Choice {
  std::size_t pass = 0;
  const PassEntry* entry = nullptr;
  double least_s = 0;
};

/// Choices, those that take least first, of equal ones the first given. What they take is computed only of
/// those that the straight line does not put behind the ones asked for.
class NearestChoices {
 public:
  NearestChoices(const Pose& left, const LeastSeconds& least, std::vector<Choice> all)
      : left_(left), least_(least), all_(std::move(all)) {
    for (std::size_t i = 0; i < all_.size(); ++i) waiting_.push({crude_s(i), i});
  }

  std::size_t size() const { return all_.size(); }

  const Choice& at(std::size_t rank) {
    while (ranked_.size() <= rank) add_next();
    return all_[ranked_[rank]];
  }

 private:
  using Timed = std::pair<double, std::size_t>;
  using Soonest = std::priority_queue<Timed, std::vector<Timed>, std::greater<>>;

  /// Slightly less than the straight line takes: no more than the bound in spite of rounding.
  double crude_s(std::size_t i) const {
    constexpr double kLess = 1 - 1e-9;
    return kLess * least_.crude(left_, all_[i].entry->entered);
  }

  void add_next() {
    while (!waiting_.empty() && (measured_.empty() || waiting_.top().first <= measured_.top().first)) {
      const std::size_t i = waiting_.top().second;
      waiting_.pop();
      all_[i].least_s = least_.between(left_, all_[i].entry->entered);
      measured_.push({all_[i].least_s, i});
    }
    ranked_.push_back(measured_.top().second);
    measured_.pop();
  }

  Pose left_;
  const LeastSeconds& least_;
  std::vector<Choice> all_;
  Soonest waiting_{}, measured_{};
  std::vector<std::size_t> ranked_{};
};

/// Passes along one boundary: those round the field, or those that name the same obstacles.
bool same_boundary(const HeadlandPass& a, const HeadlandPass& b) {
  if (a.around_field && b.around_field) return true;
  return std::any_of(a.obstacles.begin(), a.obstacles.end(), [&](std::size_t obstacle) {
    return std::binary_search(b.obstacles.begin(), b.obstacles.end(), obstacle);
  });
}

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
    NearestChoices all = choices(end_of(left));
    WorkedPass best;
    double best_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < std::min(all.size(), kMostTried); ++i) {
      const Choice& one = all.at(i);
      if (one.least_s >= best_s) break;
      std::optional<Way> way = connector_.direct(left, axle(one.pass, *one.entry));
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
      if (done_[i] || i == pass || !same_boundary(one, headland_.passes[i])) continue;
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

  NearestChoices choices(const Pose& left) const {
    std::vector<Choice> out;
    for (std::size_t pass = 0; pass < done_.size(); ++pass) {
      if (done_[pass] || !has_its_turn(pass)) continue;
      for (const PassEntry& entry : entries_[pass]) out.push_back({pass, &entry});
    }
    return {left, least_, std::move(out)};
  }

  WorkedPass by_search(const SteeredPath& left, NearestChoices& all) const {
    std::vector<Choice> nearest;
    for (std::size_t i = 0; i < std::min(all.size(), kMostSearched); ++i) nearest.push_back(all.at(i));
    WorkedPass out = to_any(left, nearest);
    if (out.before.has_room()) return out;
    WorkedPass farther = to_any(left, all_round());
    return farther.before.has_room() ? farther : out;
  }

  /// Entries of every pass whose turn it is, evenly spread.
  std::vector<Choice> all_round() const {
    std::vector<Choice> out;
    for (std::size_t pass = 0; pass < done_.size(); ++pass) {
      if (done_[pass] || !has_its_turn(pass)) continue;
      const std::size_t step = std::max<std::size_t>(1, entries_[pass].size() / (2 * kSearchedOfEach));
      for (std::size_t i = 0; i < entries_[pass].size(); i += step)
        out.push_back({pass, &entries_[pass][i], 0});
    }
    return out;
  }

  WorkedPass to_any(const SteeredPath& left, const std::vector<Choice>& choices) const {
    std::vector<SteeredPath> entered;
    for (const Choice& choice : choices) entered.push_back(axle(choice.pass, *choice.entry));
    Connector::WayToOne found = connector_.to_any(left, entered);
    const Choice& choice = choices[found.chosen];
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

/// How many ways lack room, and what all cost, s.
std::pair<std::ptrdiff_t, double> effort_of(const std::vector<WorkedPass>& tour) {
  std::pair<std::ptrdiff_t, double> out{0, 0};
  for (const WorkedPass& worked : tour) {
    if (!worked.before.has_room()) ++out.first;
    out.second += worked.before.cost_s;
  }
  return out;
}

}  // namespace

std::vector<WorkedPass> pass_tour(const PassTask& task, const SteeredPath& left) {
  std::vector<WorkedPass> out = PassTour(task).from(left);
  if (task.sequence != PassSequence::kAny || std::ranges::all_of(out, leads_forward)) return out;
  // What works behind the axle swings over the edge where the machine turns off a pass beside it: that pass
  // is best worked last, or before all others.
  for (const PassSequence sequence : {PassSequence::kOutwards, PassSequence::kInwards}) {
    PassTask ordered = task;
    ordered.sequence = sequence;
    std::vector<WorkedPass> other = PassTour(ordered).from(left);
    if (effort_of(other) < effort_of(out)) out = std::move(other);
  }
  return out;
}

WorkedPass nearest_pass(const PassTask& task, const SteeredPath& left) {
  assert(!task.passes.empty() && !left.empty());
  return PassTour(task).next(left);
}

}  // namespace tramline
