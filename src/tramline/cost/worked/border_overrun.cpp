#include "tramline/cost/worked/border_overrun.h"

#include <algorithm>

#include "tramline/cost/tolerances.h"
#include "tramline/geometry/path/newly_covered_area.h"
#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline {
namespace {

/// The swath of a straight part, in field coordinates.
ConvexSet swath_of(const StripGrid& grid, int strip, const Interval& part) {
  const double left = grid.line(strip), right = grid.line(strip + 1);
  return convex_set({grid.frame.to_field({left, part.from}), grid.frame.to_field({right, part.from}),
                     grid.frame.to_field({right, part.to}), grid.frame.to_field({left, part.to})});
}

void append_swaths(const LaidPiece& piece, const StripGrid& grid, std::vector<ConvexSet>& out) {
  for (const Interval& part : parts_on_track(piece)) out.push_back(swath_of(grid, piece.track, part));
}

double straight_length(const LaidPiece& piece) {
  double sum = 0;
  for (const Interval& part : parts_on_track(piece)) sum += part.length();
  return sum;
}

/// The swaths that leave their own subfield.
std::vector<ConvexSet> overrunning(const LaidTracks& tracks) {
  std::vector<ConvexSet> out;
  for (const LaidPiece& piece : tracks.pieces)
    if (tracks.grid.width_m * straight_length(piece) - piece.inside_m2 > kNoOverlap_m2)
      append_swaths(piece, tracks.grid, out);
  return out;
}

std::vector<ConvexSet> all_swaths(const LaidTracks& tracks) {
  std::vector<ConvexSet> out;
  for (const LaidPiece& piece : tracks.pieces) append_swaths(piece, tracks.grid, out);
  return out;
}

/// One visitor's share of the host: host ∩ visitor less the host's own swaths and the later visitors.
double newly_covered(const RingSet& host_inside, const ConvexSet& visitor, const std::vector<ConvexSet>& own,
                     const std::vector<ConvexSet>& visitors, std::size_t next) {
  std::vector<ConvexSet> others;
  // The box of a slanting visitor meets most swaths of the host, and what it has of the host only a few.
  Box reach;
  for (const Ring& ring : host_inside) reach.extend(bounds(ring));
  const auto add = [&](const ConvexSet& other) {
    if (intersects(other.box, visitor.box) && intersects(other.box, reach))
      others.push_back(common(other, visitor));
  };
  for (const ConvexSet& swath : own) add(swath);
  for (std::size_t i = next; i < visitors.size(); ++i) add(visitors[i]);
  return signed_area(host_inside) - area_in_union(host_inside, others);
}

double covered_in(const Polygon& host, const std::vector<ConvexSet>& own,
                  const std::vector<ConvexSet>& visitors) {
  RingSet rings{host.outer};
  rings.insert(rings.end(), host.holes.begin(), host.holes.end());
  double sum = 0;
  for (std::size_t i = 0; i < visitors.size(); ++i) {
    const RingSet inside = clipped(rings, visitors[i]);
    if (!inside.empty()) sum += newly_covered(inside, visitors[i], own, visitors, i + 1);
  }
  return sum;
}

bool follow_curve(const LaidTracks& tracks) {
  return std::any_of(tracks.pieces.begin(), tracks.pieces.end(),
                     [](const LaidPiece& piece) { return !piece.path.empty(); });
}

/// The parts in which the pieces keep to their tracks, in the field's frame.
std::vector<Path> paths_of(const LaidTracks& tracks) {
  const StripGrid& grid = tracks.grid;
  const auto on_field = [&grid](Point p) { return grid.frame.to_field(p); };
  std::vector<Path> out;
  for (const LaidPiece& piece : tracks.pieces) {
    if (!piece.path.empty()) {
      for (const Path& part : paths_on_track(piece)) out.push_back(moved(part, on_field));
      continue;
    }
    const double across = grid.centre(piece.track);
    for (const Interval& part : parts_on_track(piece))
      out.push_back(straight_path(on_field({across, part.from}), on_field({across, part.to})));
  }
  return out;
}

/// The part of every subfield that the swaths of all others cover and its own do not.
double covered_along_curves(const std::vector<Subfield>& subfields, const std::vector<LaidTracks>& tracks) {
  const double width_m = tracks.front().grid.width_m;
  std::vector<std::vector<Path>> lines;
  for (const LaidTracks& subfield : tracks) lines.push_back(paths_of(subfield));
  double sum = 0;
  for (std::size_t host = 0; host < subfields.size(); ++host) {
    const Box land = bounds(subfields[host].shape);
    RisingCurves curves;
    Box window;
    for (std::size_t other = 0; other < subfields.size(); ++other) {
      if (other == host) continue;
      for (const Path& line : lines[other])
        for (const Path& run : runs_near(line, reaches_of(line, width_m), {land})) {
          append_band(run, width_m, Layer::kNew, curves);
          window.extend(reach_of(run, width_m));
        }
    }
    if (curves.empty()) continue;
    for (const Path& line : lines[host])
      for (const Path& run : runs_near(line, reaches_of(line, width_m), {window}))
        append_band(run, width_m, Layer::kCovered, curves);
    for (const Ring& ring : rings_of({subfields[host].shape}))
      append_ring(ring, Layer::kBody, window, curves);
    sum += newly_covered_area(curves);
  }
  return sum;
}

}  // namespace

double covered_by_neighbours_m2(const std::vector<Subfield>& subfields,
                                const std::vector<LaidTracks>& tracks) {
  if (tracks.size() < 2) return 0;
  if (std::any_of(tracks.begin(), tracks.end(), follow_curve)) return covered_along_curves(subfields, tracks);
  std::vector<std::vector<ConvexSet>> leaving;
  for (const LaidTracks& subfield : tracks) leaving.push_back(overrunning(subfield));
  double sum = 0;
  for (std::size_t host = 0; host < subfields.size(); ++host) {
    const Box reach = bounds(subfields[host].shape);
    std::vector<ConvexSet> visitors;
    for (std::size_t other = 0; other < subfields.size(); ++other) {
      if (other == host) continue;
      for (const ConvexSet& swath : leaving[other])
        if (intersects(swath.box, reach)) visitors.push_back(swath);
    }
    if (!visitors.empty()) sum += covered_in(subfields[host].shape, all_swaths(tracks[host]), visitors);
  }
  return sum;
}

}  // namespace tramline
