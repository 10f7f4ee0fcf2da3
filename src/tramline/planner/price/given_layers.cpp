#include "tramline/planner/price/given_layers.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "tramline/cost/worked/doubled_ground.h"
#include "tramline/cost/worked/worked_regions.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/kinked_line.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"
#include "tramline/headland/body.h"
#include "tramline/planner/price/given_pieces.h"

namespace tramline {
namespace {

/// Whether thin land is an effect of chords, or as real as all other.
enum class Slivers { kAreLand, kOfChords };

struct Layers {
  Region overlap, uncovered;
};

/// Adds what a part has beside the region; nothing where that is too much for an overlay as well: these are
/// pictures, and figures do not depend on them.
void append_rest(const Polygon& part, Region& out) {
  try {
    for (Polygon& rest : difference({part}, out)) out.push_back(std::move(rest));
  } catch (const Error&) {
    return;
  }
}

/// As unite(), part by part where one overlay of all is too much.
Region united(const Region& parts) {
  try {
    return unite(parts);
  } catch (const Error&) {
    Region out;
    for (const Polygon& part : parts) {
      try {
        out = unite(out, {part});
      } catch (const Error&) {
        append_rest(part, out);
      }
    }
    return out;
  }
}

Layers layers_of(const Region& swaths, const Region& land, Slivers slivers) {
  const Region worked = united(swaths);
  Layers out{common_to_two(swaths), difference(land, worked)};
  if (slivers == Slivers::kOfChords) {
    std::erase_if(out.uncovered, is_sliver);
    std::erase_if(out.overlap, is_sliver);
  }
  for (Polygon& part : difference(worked, land)) out.overlap.push_back(std::move(part));
  out.overlap = united(out.overlap);
  return out;
}

Region moved_by(Region region, Point by) {
  for (Polygon& polygon : region) {
    for (Point& p : polygon.outer) p = p + by;
    for (Ring& hole : polygon.holes)
      for (Point& p : hole) p = p + by;
  }
  return region;
}

/// Lines that cross one another at will are rarely too much for an overlay, and then hardly on the next grid.
constexpr int kMostTries = 5;

}  // namespace

Region swath_grounds(const std::vector<Path>& paths, double width_m, double sagitta_m) {
  Region out;
  for (const Path& path : paths) {
    if (!has_smooth_edges(path)) {
      for (Ring& cell : kinked_cells(path, width_m)) out.push_back({std::move(cell), {}});
      continue;
    }
    for (const PathSegment& segment : path) {
      Polygon part{band({segment}, width_m, sagitta_m), {}};
      if (!find_invalidity(part))
        out.push_back(std::move(part));
      else  // round an arc of half the width the inner edge shrinks to a point, and chords may fold there
        for (Polygon& sound : made_valid(part)) out.push_back(std::move(sound));
    }
  }
  return out;
}

Polygon land_about(const std::vector<const Path*>& paths, double width_m, const Region& land) {
  assert(!paths.empty());
  std::vector<Point> corners;
  for (const Path* path : paths)
    for (const Polygon& part : swath_grounds({*path}, width_m, kLayerSagitta))
      corners.insert(corners.end(), part.outer.begin(), part.outer.end());
  const Region hull = convex_hull(corners);
  Region about = intersection(hull, land);
  if (about.empty()) about = hull;
  return *std::max_element(about.begin(), about.end(),
                           [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
}

void add_layers_of_lines(const std::vector<Path>& tracks, const std::vector<Path>& passes, Plan& plan) {
  Region swaths = swath_grounds(tracks, plan.machine.width_m, kLayerSagitta);
  for (Polygon& part : swath_grounds(passes, plan.machine.width_m, kLayerSagitta))
    swaths.push_back(std::move(part));
  const bool arcs = std::ranges::any_of(tracks, has_arcs) || std::ranges::any_of(passes, has_arcs);
  const Slivers slivers = arcs ? Slivers::kOfChords : Slivers::kAreLand;
  const Region land = body_of(plan.field);
  for (int tries = 1;; ++tries) {
    // Another grid: coordinates that lie otherwise between its points are rounded otherwise.
    const Point by = (tries - 1) * Point{0.37 * kGridSize, 0.23 * kGridSize};
    try {
      Layers layers = layers_of(moved_by(swaths, by), moved_by(land, by), slivers);
      plan.overlap = moved_by(std::move(layers.overlap), -1.0 * by);
      plan.uncovered = moved_by(std::move(layers.uncovered), -1.0 * by);
      return;
    } catch (const Error&) {
      if (tries == kMostTries) throw;
    }
  }
}

}  // namespace tramline
