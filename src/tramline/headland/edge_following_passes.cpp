#include "tramline/headland/edge_following_passes.h"

#include <algorithm>

#include "tramline/headland/closed_path.h"
#include "tramline/headland/drivable_rings.h"
#include "tramline/headland/driven_on.h"
#include "tramline/headland/ring_groups.h"
#include "tramline/headland/rolling_circle_path.h"

namespace tramline {
namespace {

/// The first centre line of each ring of the offset line that follows a boundary with such a pass.
std::vector<std::size_t> rings_to_follow(const std::vector<CentreLine>& centre_lines,
                                         const std::vector<Boundary>& boundaries, int number) {
  std::vector<std::size_t> out;
  for (std::size_t first = 0, last = 0; first < centre_lines.size(); first = last) {
    bool own = false;
    do {
      own = own || boundaries[centre_lines[last].offset_boundary].passes >= number;
      ++last;
    } while (last < centre_lines.size() && centre_lines[last - 1].next == last);
    if (own) out.push_back(first);
  }
  return out;
}

/// Whether the path turns round a corner in this segment, to the left.
bool is_corner(const PathSegment& segment) { return segment.curvature > 0 && turning(segment) > kCorner_rad; }

/// The path without a corner close to the end and what follows it: nothing requires the turn, and straight on
/// the swath reaches as far.
Path without_hook(Path path, double shortest_m) {
  double behind_m = 0;
  for (std::size_t i = path.size(); i-- > 1 && behind_m < shortest_m; behind_m += length(path[i]))
    if (is_corner(path[i])) {
      path.resize(i);
      break;
    }
  return path;
}

/// The same at the beginning, which is tested in driving direction: reversed, the path would turn to the
/// right.
Path without_first_hook(Path path, double shortest_m) {
  double before_m = 0;
  for (std::size_t i = 0; i + 1 < path.size() && before_m < shortest_m; before_m += length(path[i++]))
    if (is_corner(path[i])) {
      path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(i + 1));
      break;
    }
  return path;
}

}  // namespace

std::vector<std::vector<Path>> edge_following_passes(const std::vector<Boundary>& boundaries,
                                                     const HeadlandTerms& terms, int number) {
  const TurningRoom land = turning_room(boundaries, terms.width_m, number, tightest_turn_m(terms));
  const std::vector<CentreLine> centre_lines = centre_lines_along(offset_lines(land), land.radius_m);
  const ArcFits fits = [&](Point centre, Point before, Point after) {
    return keeps_off(turn_about(centre, land.radius_m, before, after), land.offset_boundaries);
  };
  std::vector<SwathLimit> limits;
  for (const Boundary& boundary : boundaries) limits.push_back({boundary.ring, boundary.clearance_m});
  std::vector<std::vector<Path>> out;
  for (const std::size_t start : rings_to_follow(centre_lines, boundaries, number)) {
    const RollingCirclePaths ways =
        rolling_circle_paths(centre_lines, start, fits, land.radius_m + terms.width_m);
    if (ways.closed && can_be_driven(closed_path(*ways.closed, land.radius_m), land))
      out.push_back({closed_path(*ways.closed, land.radius_m)});
    for (const OffsetRing& way : ways.open) {
      Path path = open_path(way, land.radius_m);
      if (path.empty() || !keeps_off(path, land.offset_boundaries)) continue;
      const double hook_m = land.radius_m + terms.width_m;
      const auto to_the_end = [&](Path part) {
        return driven_to_the_end(std::move(part), limits,
                                 {terms.width_m, land.radius_m, hook_m, Along::kOnTheRight});
      };
      Path straight = without_first_hook(without_hook(path, hook_m), hook_m);
      out.push_back({to_the_end(straight)});
      if (straight.size() < path.size()) out.back().push_back(to_the_end(std::move(path)));
    }
  }
  // The long ones beside an end already work what short ones across it would.
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return length(a.front()) > length(b.front()); });
  return out;
}

}  // namespace tramline
