#include "tramline/planner/gap_lines.h"

#include <algorithm>
#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/bounding_rectangle.h"

namespace tramline {
namespace {

/// The stretch of driveable ground that each piece lies in decides which pieces are one line.
std::vector<GapLine> lines_in(const Strip& strip, const Intervals& wanted, const Intervals& open,
                              double room_m) {
  std::vector<GapLine> out;
  for (const Interval& room : open) {
    if (room.length() < room_m) continue;
    GapLine line;
    for (const Interval& stretch : common(wanted, {room})) {
      if (stretch.length() < kNoPiece_m) continue;
      if (!line.pieces.empty() && stretch.from - line.pieces.back().to < kLeastBreak_m) {
        line.pieces.back().to = stretch.to;
        continue;
      }
      StripPiece piece;
      piece.strip = strip.index;
      piece.from = stretch.from;
      piece.to = stretch.to;
      piece.after_crossing = !line.pieces.empty();
      line.pieces.push_back(piece);
    }
    if (!line.pieces.empty()) out.push_back(std::move(line));
  }
  return out;
}

void measure(const Strip& strip, GapLine& line) {
  for (StripPiece& piece : line.pieces) {
    piece.stop_at_from = stops_at(strip, piece.from, -1);
    piece.stop_at_to = stops_at(strip, piece.to, +1);
    piece.inside_m2 = area_between(strip.subfield, piece.from, piece.to);
    line.length_m += piece.to - piece.from;
    line.covered_m2 += piece.inside_m2;
    line.stops += (piece.stop_at_from ? 1 : 0) + (piece.stop_at_to ? 1 : 0);
  }
}

Region within(const Region& region, const Region& window) {
  Region near;
  const Box box = bounds(window);
  for (const Polygon& polygon : region)
    if (intersects(bounds(polygon), box)) near.push_back(polygon);
  return near.empty() ? near : intersection(near, window);
}

}  // namespace

GapGround gap_ground(Region gaps, const Region& free, const Region& obstacles, double width_m) {
  std::vector<Point> points;
  for (const Polygon& gap : gaps) points.insert(points.end(), gap.outer.begin(), gap.outer.end());
  // A strip that meets the gaps stays, between them, within a width of their hull; half as much again, and
  // no room is cut short.
  const Region window = buffered({{hull_of(std::move(points)), {}}}, 2.5 * width_m, JoinStyle::kMitre);
  GapGround out;
  out.free = within(free, window);
  out.obstacles = within(obstacles, window);
  out.gaps_m2 = area(gaps);
  out.gaps = std::move(gaps);
  return out;
}

GapLines lines_on(const GapGround& ground, const StripGrid& grid, const RepairTerms& terms,
                  double least_width_m) {
  const Region gaps = grid.frame.to_track(ground.gaps);
  const StripRange range = strips_over(grid, bounds(gaps), kWidthTolerance);
  std::vector<StripProfile> gap = cross_sections(gaps, grid, range);
  const std::vector<StripProfile> free = cross_sections(grid.frame.to_track(ground.free), grid, range);
  std::vector<StripProfile> hard = cross_sections(grid.frame.to_track(ground.obstacles), grid, range);
  EndCriterion criterion = end_criterion(terms.end_rule, terms.objective, grid.width_m);
  criterion.least_width_m = std::max(criterion.least_width_m, least_width_m);
  GapLines out{grid, {}, 0, 0};
  for (int k = range.first; k <= range.last; ++k) {
    const auto i = static_cast<std::size_t>(k - range.first);
    if (gap[i].empty()) continue;
    Strip strip;
    strip.index = k;
    strip.subfield = std::move(gap[i]);
    strip.hard = std::move(hard[i]);
    const Intervals open = where_at_least(free[i], grid.width_m - kWidthTolerance);
    for (GapLine& line : lines_in(strip, allowed_by(criterion, strip.subfield), open, grid.width_m)) {
      measure(strip, line);
      if (line.length_m < terms.machine.min_length_m) continue;
      out.covered_m2 += line.covered_m2;
      out.price += price_of(line, terms);
      out.lines.push_back(std::move(line));
    }
  }
  return out;
}

double price_of(const GapLine& line, const RepairTerms& terms) {
  const double width_m = terms.machine.width_m;
  double priced_m = 0;
  for (const StripPiece& piece : line.pieces) priced_m += std::max(piece.to - piece.from, width_m);
  const double overlap_m2 = width_m * std::max(priced_m, 2 * width_m) - line.covered_m2;
  return terms.objective.turn + terms.objective.stop * line.stops + terms.objective.overlap * overlap_m2;
}

SubfieldTracks tracks_of(const GapLines& lines) {
  SubfieldTracks out{lines.grid, {}, {}};
  for (const GapLine& line : lines.lines)
    out.pieces.insert(out.pieces.end(), line.pieces.begin(), line.pieces.end());
  return out;
}

}  // namespace tramline
