#pragma once
// Shortens a tour by iterated local search.

#include <cstddef>
#include <vector>

#include "tramline/route/search/end_costs.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::order {

/// How many kicks shortened() gives a tour of so many lines within the time that a plan may take: enough for
/// a few milliseconds at 150 lines and a quarter of a second at 1000.
std::size_t usual_kicks(std::size_t lines);

/// The tour after local search (two or three connections exchanged at a time, twice in a row where only both
/// gain) and `kicks` times a change of four connections near one another and local search about them. The
/// best tour seen: never costs more than the tour given. Deterministic: no clock. Preconditions: the tour has
/// every line of the costs once; neighbours are those of the ends of the same lines.
Tour shortened(const Tour& tour, const EndCosts& costs, const Neighbours& neighbours, std::size_t kicks);

/// The best of several tours, each shortened; half of the kicks are for all of them alike, the rest for the
/// one that is best then. Preconditions: as above, and there is a tour.
Tour shortened_best(const std::vector<Tour>& tours, const EndCosts& costs, const Neighbours& neighbours,
                    std::size_t kicks);

}  // namespace tramline::order
