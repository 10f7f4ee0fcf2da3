#include "tramline/planner/explain/explanation.h"

#include <algorithm>
#include <array>
#include <utility>

#include "tramline/cost/cost_causes.h"
#include "tramline/planner/assembly/whole_figures.h"
#include "tramline/planner/explain/longest_side.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

constexpr std::size_t kRunnerUps = 5;
constexpr double kAlike_deg = 1;       ///< directions no farther apart are one
constexpr std::size_t kAtOnce = 8;     ///< plans that are laid out together, for any number of threads
constexpr std::size_t kMostLaid = 64;  ///< of the sweep's

using Grounds = std::vector<LinedSubfield>;
using Directions = std::vector<Direction>;

bool each_has_like(const Directions& directions, const Directions& others) {
  return std::all_of(directions.begin(), directions.end(), [&others](Direction direction) {
    return std::any_of(others.begin(), others.end(), [direction](Direction other) {
      return angle_between(direction, other).degrees() <= kAlike_deg;
    });
  });
}

bool alike(const Directions& a, const Directions& b) {
  return a.size() == b.size() && each_has_like(a, b) && each_has_like(b, a);
}

Directions directions_of(const Grounds& lined_subfields) {
  Directions out;
  for (const LinedSubfield& ground : lined_subfields) out.push_back(ground.subfield.direction);
  return out;
}

/// Every plan that may be a runner-up.
class Contest {
 public:
  Contest(const SearchTask& task, const Candidate& best, const SearchContext& context)
      : task_(task), best_(seen_plan(best).directions), context_(context) {}

  void enter(SeenPlan plan) {
    if (plan.tally.pieces == 0 || alike(plan.directions, best_)) return;
    const auto at = std::upper_bound(plans_.begin(), plans_.end(), plan,
                                     [](const SeenPlan& a, const SeenPlan& b) { return a.cost < b.cost; });
    plans_.insert(at, std::move(plan));
  }

  void lay_and_enter(const std::vector<const Grounds*>& plans) {
    std::vector<SeenPlan> laid(plans.size());
    for_each_index(plans.size(), context_,
                   [&](std::size_t i) { laid[i] = seen_plan(candidate_on(task_, *plans[i])); });
    for (SeenPlan& plan : laid) enter(std::move(plan));
  }

  /// Whether a plan that costs at least `least` could be among the runner-ups.
  bool is_hopeful(const Grounds& lined_subfields, double least) const {
    const Directions directions = directions_of(lined_subfields);
    if (alike(directions, best_)) return false;
    const std::vector<const SeenPlan*> first = runner_ups();
    if (first.size() == kRunnerUps && first.back()->cost <= least) return false;
    return std::none_of(first.begin(), first.end(), [&](const SeenPlan* plan) {
      return plan->cost <= least && alike(plan->directions, directions);
    });
  }

  /// The cheapest, no two alike.
  std::vector<const SeenPlan*> runner_ups() const {
    std::vector<const SeenPlan*> out;
    for (const SeenPlan& plan : plans_) {
      if (out.size() == kRunnerUps) break;
      const bool new_kind = std::none_of(out.begin(), out.end(), [&](const SeenPlan* other) {
        return alike(other->directions, plan.directions);
      });
      if (new_kind) out.push_back(&plan);
    }
    return out;
  }

 private:
  const SearchTask& task_;
  Directions best_;
  SearchContext context_;
  std::vector<SeenPlan> plans_;  ///< cheapest first
};

/// The sweep's plans have bounds: the lowest bounds first, until no other plan can be a runner-up.
void enter_swept(const std::vector<SweptCandidate>& swept, Contest& contest) {
  std::vector<const SweptCandidate*> waiting;
  for (const SweptCandidate& plan : swept) waiting.push_back(&plan);
  std::stable_sort(waiting.begin(), waiting.end(), [](const SweptCandidate* a, const SweptCandidate* b) {
    return a->outlook.least < b->outlook.least;
  });
  std::size_t laid = 0;
  for (auto next = waiting.begin(); next != waiting.end() && laid < kMostLaid;) {
    std::vector<const Grounds*> batch;
    for (; next != waiting.end() && batch.size() < kAtOnce; ++next)
      if (contest.is_hopeful((*next)->lined_subfields, (*next)->outlook.least))
        batch.push_back(&(*next)->lined_subfields);
    contest.lay_and_enter(batch);
    laid += batch.size();
  }
}

/// Including its headland, as for the chosen plan.
RunnerUp runner_up(const SearchTask& task, const std::vector<Direction>& directions, const Candidate& plan,
                   const Tally& best) {
  const Tally tally = whole_tally_of(task, plan);
  return {directions, tally, cost(task.objective, tally), difference(task.objective, tally, best)};
}

/// What the headland's passes add to the areas of the tracks.
void add_headland(const Objective& objective, const Tally& whole, const Tally& tracks, CostCauses& causes) {
  CausePart& part = causes.parts[static_cast<std::size_t>(Cause::kHeadland)];
  part.overlap_m2 = whole.overlap_m2 - tracks.overlap_m2;
  part.uncovered_m2 = whole.uncovered_m2 - tracks.uncovered_m2;
  part.cost = objective.overlap * part.overlap_m2 + objective.uncovered * part.uncovered_m2;
}

}  // namespace

Explanation explanation_of(const SearchTask& task, const SearchResult& found, const SearchContext& context) {
  const Candidate& best = found.best;
  const Tally& tracks = best.avoided.tally;
  const Tally tally = whole_tally_of(task, best);
  Explanation out{causes_of({best.subfields, best.families, best.avoided.tracks, task.ground.body,
                             task.ground.given_up, task.ground.passable, tracks},
                            task.objective),
                  {},
                  {}};
  add_headland(task.objective, tally, tracks, out.causes);
  Contest contest(task, best, context);
  for (const SeenPlan& plan : found.seen) contest.enter(plan);
  std::vector<const Grounds*> shortlist;
  for (const Grounds& lined_subfields : found.shortlist) shortlist.push_back(&lined_subfields);
  contest.lay_and_enter(shortlist);
  enter_swept(found.swept, contest);
  for (const SeenPlan* plan : contest.runner_ups()) {
    context.report();
    out.runner_ups.push_back(
        runner_up(task, plan->directions, candidate_on(task, plan->lined_subfields), tally));
  }
  const Candidate expected = along_longest_side(task, context);
  out.longest_side = runner_up(task, {longest_side(task.field, task.machine.width_m)}, expected, tally);
  return out;
}

}  // namespace tramline
