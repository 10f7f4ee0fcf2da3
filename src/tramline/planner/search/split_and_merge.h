#pragma once
// Divides land where that pays, and joins subfields where that pays.

#include <vector>

#include "tramline/planner/search/branch_and_bound.h"

namespace tramline {

/// A subfield with the grid of its tracks and its cost by itself: tracks cut at obstacles, stops priced no
/// higher than turns (BranchAndBoundResult::unhindered), borders counted as plain edges.
struct PricedSubfield {
  Polygon shape;
  PricedGrid grid;
};

/// A grid for each shape, searched only by edges and small steps.
std::vector<PricedSubfield> priced(const SearchTask& task, const Region& shapes,
                                   const SearchContext& context);

/// The sum over the subfields plus the price of each subfield after the first.
double price(const SearchTask& task, const std::vector<PricedSubfield>& subfields);

/// Divides the land in two in the way that saves most, and then the parts, as long as more is saved than a
/// further subfield costs. Every subfield has a track and is at least w wide. Returns one subfield where no
/// division pays.
std::vector<PricedSubfield> split_where_it_pays(const SearchTask& task, const PricedSubfield& ground,
                                                const SearchContext& context);

/// Joins neighbours whose union costs no more than the two, the pair that saves most first. Also joins,
/// whatever it costs, those that have no track, are narrower than w, or whose directions differ by less than
/// the merge threshold.
std::vector<PricedSubfield> merge_where_it_pays(const SearchTask& task, std::vector<PricedSubfield> subfields,
                                                const SearchContext& context);

}  // namespace tramline
