#include "tramline/planner/search/best_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "tramline/decomposition/sweep_directions.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/prove/ground_prices.h"
#include "tramline/planner/search/any_plan_bound.h"
#include "tramline/planner/search/split_and_merge.h"
#include "tramline/planner/search/sweep_search.h"

namespace tramline {
namespace {

constexpr std::size_t kHinderedTries = 5;  ///< grids of either ranking that are tried with detours

/// The most cells of a sweep that each get their best grid and are joined where that pays, since every pair
/// of them is tried. More cells are kept as the sweep made them.
constexpr std::size_t kMostRegridded = 64;

constexpr double kNoPrice = std::numeric_limits<double>::infinity();

LinedSubfield gridded(const Polygon& shape, const PricedGrid& grid) {
  return {{shape, grid.direction}, grid.origin_m};
}

std::vector<LinedSubfield> gridded(const std::vector<PricedSubfield>& subfields) {
  std::vector<LinedSubfield> out;
  for (const PricedSubfield& subfield : subfields) out.push_back(gridded(subfield.shape, subfield.grid));
  return out;
}

/// The cost of a plan less the sum of the costs of its parts: the first track needs no turn, and the first
/// subfield is free.
double beside_the_parts(const SearchTask& task) {
  const double given_up_m2 = std::max(0.0, task.body_m2 - area(task.ground.plannable));
  const Objective& price = task.objective;
  return price.uncovered * given_up_m2 - price.turn - price.subfield;
}

/// Each part of the land is a further subfield, or stays uncovered.
double least_of_part(const SearchTask& task, const Polygon& part, double bound) {
  return std::min(bound + task.objective.subfield, std::max(bound, task.objective.uncovered * area(part)));
}

using Grounds = std::vector<LinedSubfield>;

struct Tried {
  Grounds lined_subfields;
  Candidate candidate;
};

/// One connected part of the land, by itself.
struct PartResult {
  Tried whole;        ///< undivided
  Grounds divided;    ///< empty where that does not pay
  Grounds shortlist;  ///< the part on each of the grids that looked good, best first; not empty
  double bound = 0;   ///< of undivided plans
  int boxes = 0;
};

class BestSearch {
 public:
  BestSearch(const SearchTask& task, const SearchContext& context, double no_more_than)
      : task_(task), context_(context), no_more_than_(no_more_than) {
    if (context.wants_sweep()) swept();
  }

  SearchResult run() {
    search_parts();
    const bool wanted = context_.wants_bound() && !context_.has_to_end();
    if (!best_.works() || wanted) try_swept();
    if (!undivided_) out_.proof.one_direction_cost = best_.cost();
    if (undivided_ && best_.subfields.size() > task_.ground.plannable.size())
      out_.undivided = std::move(*undivided_);
    out_.proof.one_direction_bound =
        std::clamp(out_.proof.one_direction_bound, 0.0, out_.proof.one_direction_cost);
    if (context_.wants_bound()) prove_any_plan();
    const std::size_t directions = swept_ ? swept_->size() : sweep_directions(task_.field).size();
    out_.directions_tried = static_cast<int>(directions) + boxes_;
    out_.best = std::move(best_);
    if (swept_) out_.swept = std::move(*swept_);
    return std::move(out_);
  }

 private:
  /// The candidates of the sweep, found when they are first asked for.
  const std::vector<SweptCandidate>& swept() {
    if (!swept_) swept_ = swept_candidates(task_, context_);
    return *swept_;
  }

  /// A plan that divides the land has a further subfield at least.
  void prove_any_plan() {
    double least = least_cost_of_any_plan(task_);
    if (task_.settings.prove && best_.works() && !context_.wants_layout_only()) {
      out_.proof.prices = proven_prices(task_, best_.subfields.front().direction, context_);
      const double given_up_m2 = std::max(0.0, task_.body_m2 - area(task_.ground.plannable));
      least = std::max(least, out_.proof.prices.bound + task_.objective.uncovered * given_up_m2);
    }
    out_.proof.bound = std::min(out_.proof.one_direction_bound, least + task_.objective.subfield);
  }

  void try_swept() {
    const std::size_t cells = hopeful_sweep().lined_subfields.size();
    if (cells > task_.ground.plannable.size() && cells <= kMostRegridded)
      try_plan(regridded(hopeful_sweep().lined_subfields));
    const double known =
        best_.works() ? std::min(best_.cost(), just_above(no_more_than_)) : just_above(no_more_than_);
    if (std::optional<Candidate> sweep = cheapest_swept(task_, swept(), known, context_)) {
      if (sweep->subfields.size() == task_.ground.plannable.size()) see_undivided(*sweep);
      keep(std::move(*sweep));
    }
  }

  void search_parts() {
    Grounds whole, chosen;
    double bound = beside_the_parts(task_);
    bool divided = false;
    std::vector<Grounds> shortlists;
    const std::size_t parts = task_.ground.plannable.size();
    for (std::size_t i = 0; i < parts; ++i) {
      PartResult found = search_part(i);
      const Grounds& better = found.divided.empty() ? found.whole.lined_subfields : found.divided;
      whole.insert(whole.end(), found.whole.lined_subfields.begin(), found.whole.lined_subfields.end());
      chosen.insert(chosen.end(), better.begin(), better.end());
      divided = divided || !found.divided.empty();
      bound += parts == 1 ? found.bound + task_.objective.subfield
                          : least_of_part(task_, task_.ground.plannable[i], found.bound);
      boxes_ += found.boxes;
      shortlists.push_back(std::move(found.shortlist));
      if (parts == 1) best_ = std::move(found.whole.candidate);
    }
    if (parts != 1) best_ = laid_out(whole);
    see(best_);
    see_undivided(best_);
    out_.proof.one_direction_bound = bound;
    if (divided) try_plan(chosen);
    out_.shortlist = across_parts(shortlists);
  }

  /// The best of each part's list together, the second best, and so on; a part whose list ends stays with its
  /// best.
  static std::vector<Grounds> across_parts(const std::vector<Grounds>& shortlists) {
    std::size_t longest = 0;
    for (const Grounds& list : shortlists) longest = std::max(longest, list.size());
    std::vector<Grounds> out(longest);
    for (std::size_t i = 0; i < longest; ++i)
      for (const Grounds& list : shortlists) out[i].push_back(list[i < list.size() ? i : 0]);
    return out;
  }

  PartResult search_part(std::size_t index) {
    const Polygon& part = task_.ground.plannable[index];
    const SearchEffort effort = effort_for(part);
    std::vector<PricedSubfield> divided;
    Direction along;
    const Rival divide = [&](const PricedGrid& best) {
      along = best.direction;
      divided = divided_from({part, best});
      // Where detours are possible, the costs of parts with all tracks cut say little.
      return divided.size() < 2 || !task_.ground.hazards.empty() ? kNoPrice : price(task_, divided);
    };
    const BranchAndBoundResult found = branch_and_bound(task_, part, effort, context_, divide);
    const bool hindered = !found.unhindered.empty();
    std::vector<Grounds> ways{{gridded(part, found.grids.front())}};
    if (hindered) append_hindered_ways(index, found, ways);
    // Where detours are possible, an untried plan may be cheaper than it looks, so it is not a runner-up.
    Grounds shortlist;
    if (hindered)
      for (const Grounds& way : ways) shortlist.push_back(way.front());
    else
      for (const PricedGrid& grid : found.grids) shortlist.push_back(gridded(part, grid));
    PartResult out{cheapest_of(std::move(ways)), {}, std::move(shortlist), found.bound, found.boxes};
    if (hindered) {
      slide(out.whole);
      const LinedSubfield& lined = out.whole.lined_subfields.front();
      const ProvenBound proven =
          bound_of_grids(task_, part, effort, context_,
                         {price_alone(part, out.whole.candidate), lined.subfield.direction, lined.origin_m});
      out.bound = proven.bound;
      out.boxes += proven.boxes;
    }

    const PricedGrid& best = hindered ? found.unhindered.front() : found.grids.front();
    if (angle_between(best.direction, along) > Angle::degrees(1)) {
      std::vector<PricedSubfield> again = divided_from({part, best});
      if (divided.size() < 2 || (again.size() > 1 && price(task_, again) < price(task_, divided)))
        divided = std::move(again);
    }
    if (divided.size() < 2 || context_.has_to_end()) return out;
    Grounds apart = gridded(divided);
    if (is_better(laid_out(apart).avoided, out.whole.candidate.avoided)) out.divided = std::move(apart);
    return out;
  }

  /// What the part costs by itself with the tracks of a plan of this part alone.
  double price_alone(const Polygon& part, const Candidate& laid) const {
    if (!laid.works()) return kNoPrice;
    return laid.cost() + task_.objective.turn -
           task_.objective.uncovered * std::max(0.0, task_.body_m2 - area(part));
  }

  /// The land divided, each part with its best grid; one part where division does not pay.
  std::vector<PricedSubfield> divided_from(const PricedSubfield& ground) const {
    if (task_.may_divide == MayDivide::kNo) return {ground};
    std::vector<PricedSubfield> out = split_where_it_pays(task_, ground, context_);
    if (out.size() > 1) out = merge_where_it_pays(task_, std::move(out), context_);
    return out;
  }

  /// A grid takes time in proportion to corners, tracks and how often the boundary meets tracks: the more
  /// there are, the fewer are looked at. A boundary that goes round the part a few times at most counts with
  /// the tracks.
  SearchEffort effort_for(const Polygon& part) const {
    constexpr double kCornersAndTracks = 2e6;  // of all grids that are bounded
    const Box box = bounds(part);
    constexpr double kPlainRounds = 8;  // boundary to diagonal
    constexpr double kWinding = 2000;   // widths; more is no field's, but a comb's or a star's
    const double across_m = std::hypot(box.width(), box.height());
    double boundary_m = perimeter(part.outer);
    for (const Ring& hole : part.holes) boundary_m += perimeter(hole);
    const double winding_m = std::max(0.0, boundary_m - kPlainRounds * across_m);
    const double one =
        static_cast<double>(vertex_count({part})) + (across_m + winding_m) / task_.machine.width_m;
    SearchEffort effort;
    effort.tolerance = task_.settings.direction_tolerance;
    effort.most_boxes = std::min(effort.most_boxes, 200 + static_cast<int>(kCornersAndTracks / one));
    effort.scanned = std::min(effort.scanned, 20 + static_cast<int>(0.1 * kCornersAndTracks / one));
    if (winding_m > kWinding * task_.machine.width_m) {
      effort.most_edges = 16;
      effort.polished = 1;
      effort.exact_offset = false;
    }
    if (!context_.wants_bound()) effort.most_boxes = 0;
    return effort;
  }

  /// The plans to try with detours: the best with detours need not be the best with all tracks cut nor the
  /// best with free stops, so the best few of either are tried, and the sweep's.
  void append_hindered_ways(std::size_t part, const BranchAndBoundResult& found, std::vector<Grounds>& ways) {
    const Polygon& shape = task_.ground.plannable[part];
    for (std::size_t i = 0; i < kHinderedTries; ++i) {
      if (i > 0 && i < found.grids.size()) ways.push_back({gridded(shape, found.grids[i])});
      if (i < found.unhindered.size()) ways.push_back({gridded(shape, found.unhindered[i])});
    }
    if (task_.ground.plannable.size() != 1) return;
    std::vector<const SweptCandidate*> undivided;
    for (const SweptCandidate& one : swept())
      if (one.lined_subfields.size() == 1) undivided.push_back(&one);
    std::stable_sort(
        undivided.begin(), undivided.end(),
        [](const SweptCandidate* a, const SweptCandidate* b) { return a->outlook.soft < b->outlook.soft; });
    if (!undivided.empty()) ways.push_back(undivided.front()->lined_subfields);
  }

  Tried cheapest_of(std::vector<Grounds> ways) const {
    std::vector<Candidate> candidates(ways.size());
    const std::vector<bool> made = for_each_index_until_end(
        ways.size(), context_, [&](std::size_t i) { candidates[i] = candidate_on(task_, ways[i]); });
    std::size_t best = 0;
    for (std::size_t i = 1; i < ways.size(); ++i)
      if (made[i] && is_better(candidates[i].avoided, candidates[best].avoided)) best = i;
    return {std::move(ways[best]), std::move(candidates[best])};
  }

  /// The same direction with the grid at other offsets: the position of tracks relative to an obstacle
  /// determines the cost of detours.
  void slide(Tried& tried) const {
    constexpr int kSteps = 8;
    if (context_.has_to_end()) return;
    std::vector<Grounds> ways;
    for (int i = 1; i < kSteps; ++i) {
      ways.push_back(tried.lined_subfields);
      ways.back().front().origin_m += task_.machine.width_m * i / kSteps;
    }
    Tried other = cheapest_of(std::move(ways));
    if (is_better(other.candidate.avoided, tried.candidate.avoided)) tried = std::move(other);
  }

  /// The sweep's candidate that looks best before the ways past obstacles are known.
  const SweptCandidate& hopeful_sweep() {
    return *std::min_element(
        swept().begin(), swept().end(),
        [](const SweptCandidate& a, const SweptCandidate& b) { return a.outlook.soft < b.outlook.soft; });
  }

  /// Its subfields, each with the best grid, and joined where that pays.
  Grounds regridded(const Grounds& lined_subfields) const {
    Region shapes;
    for (const LinedSubfield& ground : lined_subfields) shapes.push_back(ground.subfield.shape);
    std::vector<PricedSubfield> joined =
        merge_where_it_pays(task_, priced(task_, shapes, context_), context_);
    return gridded(joined);
  }

  Candidate laid_out(const Grounds& lined_subfields) const {
    context_.report();
    return candidate_on(task_, lined_subfields);
  }

  void try_plan(const Grounds& lined_subfields) { keep(laid_out(lined_subfields)); }

  void keep(Candidate candidate) {
    see(candidate);
    if (is_better(candidate.avoided, best_.avoided)) best_ = std::move(candidate);
  }

  void see_undivided(const Candidate& candidate) {
    if (!candidate.works()) return;
    double& least = out_.proof.one_direction_cost;
    if (undivided_ && candidate.cost() >= least) return;
    least = candidate.cost();
    undivided_ = lined_subfields_of(candidate);
  }

  void see(const Candidate& candidate) { out_.seen.push_back(seen_plan(candidate)); }

  const SearchTask& task_;
  SearchContext context_;
  double no_more_than_;
  std::optional<std::vector<SweptCandidate>> swept_{};
  SearchResult out_;
  Candidate best_;
  std::optional<Grounds> undivided_;  ///< of the cheapest plan with undivided parts that has been seen
  int boxes_ = 0;
};

}  // namespace

SearchResult best_search(const SearchTask& task, const SearchContext& context, double no_more_than) {
  return BestSearch(task, context, no_more_than).run();
}

}  // namespace tramline
