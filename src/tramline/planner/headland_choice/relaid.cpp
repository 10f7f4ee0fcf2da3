#include "tramline/planner/headland_choice/relaid.h"

#include <cassert>
#include <optional>
#include <utility>

#include "tramline/geometry/strip/track_frame.h"
#include "tramline/planner/given/part_problem.h"
#include "tramline/planner/headland_choice/divided_like.h"
#include "tramline/planner/search/best_along.h"

namespace tramline {
namespace {

/// Coordinate across of a line between tracks of the layout in that direction; nullopt where there are none.
std::optional<double> origin_in(const Plan& layout, const Subfield& part) {
  const TrackFrame frame(part.direction);
  for (const TrackPiece& piece : layout.pieces)
    if (piece.curve.empty() && layout.subfields[piece.subfield].direction == part.direction)
      return frame.to_track(piece.start).x - 0.5 * layout.machine.width_m;
  return std::nullopt;
}

/// Whether straight tracks follow the reference: a line that was given, of any length.
bool is_given_line(const Path& reference) { return reference.size() == 1 && reference.front().straight(); }

LinedSubfield along_given_line(Subfield part) {
  const Path line = std::exchange(part.reference, {});
  part.direction = Direction::along(line.front().from, line.front().to);
  const double origin_m = TrackFrame(part.direction).to_track(line.front().from).x;
  return {std::move(part), origin_m};
}

}  // namespace

SearchResult relaid(const PlanningProblem& problem, const PreparedField& prepared, const Plan& layout,
                    Offset offset, const SearchContext& context) {
  assert(!layout.subfields.empty());
  const SearchTask task(problem, prepared);
  std::vector<LinedSubfield> lined;
  for (Subfield& part : divided_like(prepared.ground.plannable, layout.subfields)) {
    if (is_given_line(part.reference)) {
      lined.push_back(along_given_line(std::move(part)));
      continue;
    }
    if (!part.reference.empty()) {
      lined.push_back({std::move(part), 0});
      continue;
    }
    const std::optional<double> origin_m =
        offset == Offset::kOfLayout ? origin_in(layout, part) : std::nullopt;
    if (origin_m) {
      lined.push_back({std::move(part), *origin_m});
      continue;
    }
    const PartProblem alone(problem, prepared, {part.shape}, MayDivide::kNo);
    const SearchTask alone_task = alone.task();
    lined.push_back(best_along(alone_task, std::move(part), context));
  }
  SearchResult out;
  out.best = candidate_on(task, lined);
  out.directions_tried = 1;
  return out;
}

}  // namespace tramline
