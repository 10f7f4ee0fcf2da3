#include "tramline/planner/given/given_search.h"

#include <cassert>
#include <optional>
#include <utility>

#include "tramline/decomposition/cells.h"
#include "tramline/planner/curved/curved_candidate.h"
#include "tramline/planner/curved/curved_search.h"
#include "tramline/planner/given/part_problem.h"
#include "tramline/planner/search/best_along.h"
#include "tramline/planner/search/straight_search.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

using Lined = std::vector<LinedSubfield>;

/// The part with tracks along a given line: its straight line is the border of two swaths.
LinedSubfield lined_along(const SearchTask& whole, const Polygon& shape, const std::vector<Point>& guide) {
  if (guide.size() == 2) {
    const Direction along = Direction::along(guide.front(), guide.back());
    return {{shape, along}, TrackFrame(along).to_track(guide.front()).x};
  }
  const auto subfield = subfield_along(whole, shape, reference_along(whole, guide, 0));
  assert(subfield);  // Unmoved, the reference keeps the radii it was smoothed to.
  return {*subfield, 0};
}

/// Without tracks a search may not even say what the subfields are.
Lined lined_or_bare(const SearchTask& task, const Candidate& candidate) {
  if (!candidate.subfields.empty()) return lined_subfields_of(candidate);
  Lined out;
  for (const Polygon& shape : task.ground.plannable) {
    const Subfield subfield{shape, driving_direction(shape.outer, task.settings.cell_direction)};
    out.push_back({subfield, strip_grids(subfield, task.machine.width_m).front().origin_m});
  }
  return out;
}

SearchResult straight_of(const SearchTask& task, const SearchContext& context) {
  if (task.settings.strategy == Strategy::kBest || task.may_divide == MayDivide::kYes)
    return straight_search(task, context);
  SearchResult out;
  const Polygon& shape = task.ground.plannable.front();
  const Direction along = driving_direction(shape.outer, task.settings.cell_direction);
  out.best = candidate_on(task, {best_along(task, {shape, along}, context)});
  out.directions_tried = 1;
  return out;
}

bool is_cheaper(const std::optional<Candidate>& candidate, const Candidate& than) {
  return candidate && candidate->works() && (!than.works() || costs_less(candidate->cost(), than.cost()));
}

/// The best tracks on parts without a direction.
Lined searched_for(const SearchTask& task, const SearchContext& context, int& directions_tried) {
  const TrackShape shape = task.settings.shape;
  const bool divides = task.may_divide == MayDivide::kYes;
  if (shape == TrackShape::kCurved) {
    const std::optional<Candidate> curved =
        divides ? curved_search(task, context) : along_best_edge(task, context);
    if (curved && curved->works()) return lined_subfields_of(*curved);
  }
  SearchResult straight = straight_of(task, context);
  directions_tried += straight.directions_tried;
  if (shape != TrackShape::kAuto) return lined_or_bare(task, straight.best);
  Candidate best = straight.best;
  if (std::optional<Candidate> curved = along_best_edge(task, context); is_cheaper(curved, best))
    best = std::move(*curved);
  if (std::optional<Candidate> mixed; divides && straight.best.works()) {
    mixed = mixed_search(task, straight, context);
    if (is_cheaper(mixed, best)) best = std::move(*mixed);
  }
  return lined_or_bare(task, best);
}

class GivenSearch {
 public:
  GivenSearch(const PlanningProblem& problem, const PreparedField& prepared, const SearchContext& context)
      : problem_(problem), prepared_(prepared), task_(problem, prepared), context_(context) {}

  SearchResult run() {
    const std::vector<LandPart>& parts = prepared_.given.parts;
    const int total = static_cast<int>(parts.size());
    Region free;
    for (const LandPart& part : parts) {
      if (is_free(part))
        free.push_back(part.shape);
      else
        add(lined(part), part.given_by);
      context_.count(total - static_cast<int>(&parts.back() - &part), total);
    }
    if (!free.empty()) {
      const PartProblem rest(problem_, prepared_, free, MayDivide::kYes);
      add(searched_for(rest.task(), context_.uncounted(), out_.directions_tried), "");
    }
    out_.best = candidate_on(task_, lined_);
    return std::move(out_);
  }

 private:
  bool is_free(const LandPart& part) const {
    return part.given_by.empty() && problem_.settings.guide.empty();
  }

  Lined lined(const LandPart& part) {
    const PartProblem alone(problem_, prepared_, {part.shape}, MayDivide::kNo);
    const SearchTask task = alone.task();
    if (!part.guide.empty()) return {lined_along(task_, part.shape, part.guide)};
    if (part.direction) {
      ++out_.directions_tried;
      return {best_along(task, {part.shape, *part.direction}, context_.uncounted())};
    }
    if (!problem_.settings.guide.empty()) return {lined_along(task_, part.shape, problem_.settings.guide)};
    return searched_for(task, context_.uncounted(), out_.directions_tried);
  }

  void add(Lined more, const std::string& given_by) {
    for (LinedSubfield& subfield : more) {
      subfield.subfield.given_by = given_by;
      lined_.push_back(std::move(subfield));
    }
  }

  const PlanningProblem& problem_;
  const PreparedField& prepared_;
  SearchTask task_;
  SearchContext context_;
  SearchResult out_;
  Lined lined_;
};

}  // namespace

SearchResult given_search(const PlanningProblem& problem, const PreparedField& prepared,
                          const SearchContext& context) {
  assert(!prepared.given.parts.empty());
  return GivenSearch(problem, prepared, context).run();
}

}  // namespace tramline
