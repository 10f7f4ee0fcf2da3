#pragma once
// Ground divided where that pays.

#include <vector>

#include "tramline/planner/search/branch_and_bound.h"

namespace tramline {

/// A subfield with the grid of its tracks, and what it costs by itself: its tracks cut at obstacles, a
/// stop no dearer than a turn (BranchAndBoundResult::unhindered), borders taken as plain edges.
struct PricedSubfield {
  Polygon shape;
  PricedGrid grid;
};

/// A grid for each shape, by edges and small steps alone.
std::vector<PricedSubfield> priced(const SearchTask& task, const Region& shapes,
                                   const SearchContext& context);

/// The sum over the subfields, and the price of each after the first.
double price(const SearchTask& task, const std::vector<PricedSubfield>& subfields);

/// Divides the ground in two, the way that saves most, and the parts again, as long as more is saved than a
/// further subfield costs. Every subfield has a track, and is no narrower than w. One subfield where nothing
/// pays.
std::vector<PricedSubfield> split_where_it_pays(const SearchTask& task, const PricedSubfield& ground,
                                                const SearchContext& context);

/// Joins neighbours whose union costs no more than the two, the pair that saves most first; also those
/// that have no track, are narrower than w, or whose directions are nearer to one another than the merge
/// threshold, whatever it costs.
std::vector<PricedSubfield> merge_where_it_pays(const SearchTask& task, std::vector<PricedSubfield> subfields,
                                                const SearchContext& context);

}  // namespace tramline
