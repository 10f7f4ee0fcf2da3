#pragma once
// Straight tracks of one direction that are laid on other grids behind the same passes.

#include <cstddef>
#include <vector>

#include "tramline/planner/search_context.h"
#include "tramline/planner/whole/route_layouts.h"

namespace tramline {

/// The tracks of a layout, all in one direction, moved by eighths of their width and turned by up to three
/// degrees about the middle of the land: the `most` grids whose routes cost least at the least
/// (route_floor()), in this order. The cost of tracks does not know of ends without a way off. Among
/// obstacles they are chosen of the grids whose floors are lowest with all tracks cut, eight times as many.
/// None for others. Deterministic for any number of threads, as what follows.
std::vector<LaidOut> beside(const LaidOut& laid, std::size_t most, const SearchContext& context);

/// The same for grids behind the passes of a layout in directions all round that are three degrees apart,
/// those whose floor lies above `no_more_than` left out as far as that is known without looking for stops,
/// EUR.
std::vector<LaidOut> all_round_the_compass(const LaidOut& laid, std::size_t most, double no_more_than,
                                           const SearchContext& context);

}  // namespace tramline
