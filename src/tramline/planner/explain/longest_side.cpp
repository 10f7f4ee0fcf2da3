#include "tramline/planner/explain/longest_side.h"

#include <utility>
#include <vector>

#include "tramline/geometry/polygon/significant_vertices.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/tracks/strip_origin.h"

namespace tramline {
namespace {

constexpr int kPlacesOfGrid = 8;  ///< of a grid across a track

/// The origins that are tried for one part of the ground.
std::vector<double> origins_of(const Subfield& part, double width_m) {
  std::vector<double> out;
  for (const StripGrid& grid : strip_grids(part, width_m)) out.push_back(grid.origin_m);
  const double first_m = out.front();
  for (int k = 1; k < kPlacesOfGrid; ++k) out.push_back(first_m + width_m * k / kPlacesOfGrid);
  return out;
}

}  // namespace

Direction longest_side(const Field& field, double width_m) {
  const std::vector<std::size_t> corners = significant_vertices(field.outer, 0.5 * width_m);
  Point longest{0, 0};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point side = field.outer[corners[(i + 1) % corners.size()]] - field.outer[corners[i]];
    if (dot(side, side) > dot(longest, longest)) longest = side;
  }
  return Direction::along({0, 0}, longest);
}

Candidate along_longest_side(const SearchTask& task, const SearchContext& context) {
  const Direction along = longest_side(task.field, task.machine.width_m);
  std::vector<std::vector<LinedSubfield>> ways;
  for (const Polygon& shape : task.ground.plannable) {
    const Subfield part{shape, along};
    const std::vector<double> origins = origins_of(part, task.machine.width_m);
    if (ways.size() < origins.size())
      ways.resize(origins.size(), ways.empty() ? std::vector<LinedSubfield>{} : ways.front());
    for (std::size_t i = 0; i < ways.size(); ++i)
      ways[i].push_back({part, origins[i < origins.size() ? i : 0]});
  }
  std::vector<Candidate> candidates(ways.size());
  for_each_index(ways.size(), context, [&](std::size_t i) { candidates[i] = candidate_on(task, ways[i]); });
  std::size_t best = 0;
  for (std::size_t i = 1; i < candidates.size(); ++i)
    if (is_better(candidates[i].avoided, candidates[best].avoided)) best = i;
  return std::move(candidates[best]);
}

}  // namespace tramline
