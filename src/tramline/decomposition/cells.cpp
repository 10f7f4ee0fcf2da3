#include "tramline/decomposition/cells.h"

#include "tramline/decomposition/cuts.h"
#include "tramline/decomposition/events.h"
#include "tramline/decomposition/tolerances.h"
#include "tramline/geometry/polygon/bounding_rectangle.h"

namespace tramline {
namespace {

/// The parts, or the polygon itself where their areas do not sum to its own: no unforeseen rounding may lose
/// or gain land.
Region divided_or_whole(const Polygon& polygon, const std::vector<Cut>& cuts) {
  Region faces = divided(polygon, cuts);
  const double whole = area(polygon);
  if (std::abs(area(faces) - whole) > kSameArea_share * whole) return {polygon};
  return faces;
}

}  // namespace

Direction driving_direction(const Ring& outer, CellDirection choice) {
  return choice == CellDirection::kRectangle ? long_side_of_smallest_rectangle(outer)
                                             : across_least_width(outer);
}

std::vector<Cell> sweep_cells(const Region& plannable, Direction sweep, Angle threshold, CellDirection choice,
                              double short_edge_m) {
  std::vector<Cell> cells;
  for (const Polygon& polygon : plannable) {
    const auto cuts = cuts_at(polygon, split_events(polygon, threshold, short_edge_m), sweep);
    const Region faces = cuts.empty() ? Region{polygon} : divided_or_whole(polygon, cuts);
    for (const Polygon& face : faces) cells.push_back({face, driving_direction(face.outer, choice)});
  }
  return cells;
}

}  // namespace tramline
