#include "tramline/planner/search/split_and_merge.h"

#include <algorithm>
#include <limits>
#include <optional>

#include "tramline/decomposition/divisions.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/search/merge_pairs.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kGlancedAt = 20;      ///< divisions that are glanced at twice …
constexpr std::size_t kLookedAt = 4;        ///< … and that are looked at closely
constexpr double kHope = 0.5;               ///< relative; a closer look does not make up for more
constexpr double kLeastShare = 0.01;        ///< of the cost of the whole; ground that costs less stays whole
constexpr std::size_t kMostSubfields = 24;  ///< made of one piece of ground

/// The number of edges, of grids at each edge, and of the best of these grids that are improved by small
/// steps.
SearchEffort effort(std::size_t edges, std::size_t offsets, std::size_t polished) {
  SearchEffort out;
  out.most_edges = edges;
  out.edge_offsets = offsets;
  out.polished = polished;
  out.scanned = out.most_boxes = 0;
  out.tolerance = Angle::degrees(0.02);
  out.cut_too = out.exact_offset = false;
  return out;
}

// From one effort to the next, for divisions that promise more.
SearchEffort first_glance() { return effort(2, 2, 0); }
SearchEffort glance() { return effort(4, 4, 0); }
SearchEffort closer_look() { return effort(16, 4, 2); }

PricedSubfield priced_with(const SearchTask& task, const Polygon& shape, const SearchEffort& effort,
                           const SearchContext& context) {
  const BranchAndBoundResult found = branch_and_bound(task, shape, effort, context);
  return {shape, found.unhindered.empty() ? found.grids.front() : found.unhindered.front()};
}

/// The highest quickly estimated cost at which a division may still pay.
double not_worth_a_closer_look(double cost) { return cost + kHope * std::abs(cost); }

double least_width(const Ring& ring) {
  const Box box = bounds(TrackFrame(across_least_width(ring)).to_track(ring));
  return box.width();
}

bool is_workable(const SearchTask& task, const PricedSubfield& subfield) {
  if (least_width(subfield.shape.outer) < task.machine.width_m) return false;
  const TrackFamily family =
      tracks_on(task, {{subfield.shape, subfield.grid.direction}, subfield.grid.origin_m});
  return !cut_pieces(family, min_length_m(task.machine)).pieces.empty();
}

/// Two directions that differ by less than the merge threshold are not worth driving separately.
bool too_alike(const SearchTask& task, const PricedSubfield& a, const PricedSubfield& b) {
  return angle_between(a.grid.direction, b.grid.direction) < task.settings.merge_threshold;
}

std::vector<PricedSubfield> priced_parts(const SearchTask& task, const Region& parts,
                                         const SearchEffort& effort, const SearchContext& context) {
  std::vector<PricedSubfield> out;
  for (const Polygon& part : parts) out.push_back(priced_with(task, part, effort, context));
  return out;
}

bool too_alike(const SearchTask& task, const std::vector<PricedSubfield>& parts) {
  for (std::size_t a = 0; a < parts.size(); ++a)
    for (std::size_t b = a + 1; b < parts.size(); ++b)
      if (too_alike(task, parts[a], parts[b])) return true;
  return false;
}

/// The division that saves most, or nothing.
std::optional<std::vector<PricedSubfield>> best_division(const SearchTask& task, const PricedSubfield& ground,
                                                         const SearchContext& context) {
  const double width_m = task.machine.width_m;
  const SearchContext each = context.on_one_thread();
  std::vector<Region> ways = divisions(ground.shape, {0.5 * width_m, 8, 4, ground.grid.direction});
  std::erase_if(ways, [&](const Region& parts) {
    return std::any_of(parts.begin(), parts.end(),
                       [&](const Polygon& part) { return area(part) < width_m * width_m; });
  });
  std::vector<double> sums;
  const auto keep_cheapest = [&](std::size_t most, double below, const SearchEffort& looking) {
    sums.assign(ways.size(), 0);
    for_each_index_until_end(ways.size(), context, [&](std::size_t i) {
      sums[i] = price(task, priced_parts(task, ways[i], looking, each));
    });
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < ways.size(); ++i)
      if (sums[i] <= below) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return sums[a] < sums[b]; });
    if (order.size() > most) order.resize(most);
    std::vector<Region> kept;
    for (const std::size_t i : order) kept.push_back(std::move(ways[i]));
    ways = std::move(kept);
  };
  if (ways.size() > kGlancedAt) keep_cheapest(kGlancedAt, kNever, first_glance());
  if (context.has_to_end()) return std::nullopt;
  keep_cheapest(kLookedAt, not_worth_a_closer_look(ground.grid.cost), glance());

  std::vector<std::vector<PricedSubfield>> looked(ways.size());
  for_each_index_until_end(looked.size(), context, [&](std::size_t i) {
    looked[i] = priced_parts(task, ways[i], closer_look(), each);
  });
  if (context.has_to_end()) return std::nullopt;
  std::optional<std::vector<PricedSubfield>> best;
  double least = ground.grid.cost - kLeastSaving_share * std::abs(ground.grid.cost);
  for (std::vector<PricedSubfield>& parts : looked) {
    const bool workable = std::all_of(parts.begin(), parts.end(),
                                      [&](const PricedSubfield& part) { return is_workable(task, part); });
    if (!workable || too_alike(task, parts) || price(task, parts) >= least) continue;
    least = price(task, parts);
    best = std::move(parts);
  }
  return best;
}

}  // namespace

std::vector<PricedSubfield> priced(const SearchTask& task, const Region& shapes,
                                   const SearchContext& context) {
  const SearchContext each = context.on_one_thread();
  std::vector<PricedSubfield> out(shapes.size());
  for_each_index(out.size(), context,
                 [&](std::size_t i) { out[i] = priced_with(task, shapes[i], closer_look(), each); });
  return out;
}

double price(const SearchTask& task, const std::vector<PricedSubfield>& subfields) {
  double sum = task.objective.subfield * (std::max(1.0, static_cast<double>(subfields.size())) - 1);
  for (const PricedSubfield& subfield : subfields) sum += subfield.grid.cost;
  return sum;
}

std::vector<PricedSubfield> split_where_it_pays(const SearchTask& task, const PricedSubfield& ground,
                                                const SearchContext& context) {
  std::vector<PricedSubfield> open{ground}, done;
  while (!open.empty()) {
    const PricedSubfield next = std::move(open.back());
    open.pop_back();
    std::optional<std::vector<PricedSubfield>> parts;
    const bool worth_it = next.grid.cost > kLeastShare * ground.grid.cost;
    if (worth_it && !context.has_to_end() && open.size() + done.size() < kMostSubfields)
      parts = best_division(task, next, context);
    if (parts)
      open.insert(open.end(), parts->begin(), parts->end());
    else
      done.push_back(next);
  }
  return done;
}

std::vector<PricedSubfield> merge_where_it_pays(const SearchTask& task, std::vector<PricedSubfield> subfields,
                                                const SearchContext& context) {
  using Pair = MergedPair<PricedSubfield>;
  const SearchContext each = context.on_one_thread();
  const auto look = [&](const std::vector<PricedSubfield>& among, const std::vector<IndexPair>& index_pairs) {
    std::vector<std::optional<Pair>> found(index_pairs.size());
    for_each_index_until_end(index_pairs.size(), context, [&](std::size_t i) {
      const PricedSubfield &a = among[index_pairs[i].first], &b = among[index_pairs[i].second];
      const std::optional<Polygon> whole = merged_shape(a.shape, b.shape);
      if (!whole) return;
      const double apart = price(task, {a, b});
      const bool needed = !is_workable(task, a) || !is_workable(task, b) || too_alike(task, a, b);
      if (!needed && priced_with(task, *whole, glance(), each).grid.cost > not_worth_a_closer_look(apart))
        return;
      PricedSubfield one = priced_with(task, *whole, closer_look(), each);
      const double saving = needed ? kNever : apart - one.grid.cost;
      found[i] = Pair{index_pairs[i], std::move(one), saving};
    });
    return found;
  };
  return merge_pairs(std::move(subfields), look);
}

}  // namespace tramline
