#include "tramline/planner/headland_choice/relaid.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/interior_point.h"
#include "tramline/geometry/strip/track_frame.h"
#include "tramline/planner/given/part_problem.h"
#include "tramline/planner/search/best_along.h"

namespace tramline {
namespace {

/// Ground smaller than this is no subfield by itself, where it adjoins another one, m²; and as little is
/// rounding, where it adjoins none.
constexpr double kSliver_m2 = 1, kRounding_m2 = 1e-3;

bool same_lines(const Subfield& a, const Subfield& b) {
  return a.direction == b.direction && a.reference == b.reference;
}

const Subfield& nearest_of(const std::vector<Subfield>& layout, const Polygon& part) {
  const Point inside = interior_point(part);
  double least = std::numeric_limits<double>::infinity();
  const Subfield* nearest = &layout.front();
  for (const Subfield& subfield : layout) {
    const double off_m = distance_between({subfield.shape}, line_neighbourhood(inside, inside, 0.01));
    if (off_m >= least) continue;
    least = off_m;
    nearest = &subfield;
  }
  return *nearest;
}

/// Each sliver becomes part of the first subfield that it adjoins along an edge; else one of its own, unless
/// it is rounding.
void join_slivers(std::vector<Subfield> slivers, std::vector<Subfield>& subfields) {
  for (Subfield& sliver : slivers) {
    const bool joined = std::any_of(subfields.begin(), subfields.end(), [&](Subfield& subfield) {
      Region both = unite({subfield.shape}, {sliver.shape});
      if (both.size() != 1) return false;
      subfield.shape = std::move(both.front());
      return true;
    });
    if (!joined && area(sliver.shape) >= kRounding_m2) subfields.push_back(std::move(sliver));
  }
}

/// The parts of the ground with the lines of the subfield that each lies in.
std::vector<Subfield> parts_of(const Region& ground, const std::vector<Subfield>& layout) {
  std::vector<Subfield> out;
  const auto as = [](const Polygon& shape, const Subfield& like) {
    return Subfield{shape, like.direction, like.reference, like.given_by};
  };
  const bool undivided = std::all_of(layout.begin(), layout.end(),
                                     [&](const Subfield& one) { return same_lines(one, layout.front()); });
  if (undivided) {
    for (const Polygon& part : ground) out.push_back(as(part, layout.front()));
    return out;
  }
  std::vector<Subfield> slivers;
  const auto add = [&](const Polygon& part, const Subfield& like) {
    (area(part) >= kSliver_m2 ? out : slivers).push_back(as(part, like));
  };
  Region rest = ground;
  for (const Subfield& subfield : layout) {
    for (const Polygon& part : intersection(ground, {subfield.shape})) add(part, subfield);
    rest = difference(rest, {subfield.shape});
  }
  for (const Polygon& part : rest) add(part, nearest_of(layout, part));
  join_slivers(std::move(slivers), out);
  return out;
}

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
  for (Subfield& part : parts_of(prepared.ground.plannable, layout.subfields)) {
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
