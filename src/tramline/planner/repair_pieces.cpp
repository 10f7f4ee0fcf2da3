#include "tramline/planner/repair_pieces.h"

#include <algorithm>
#include <map>
#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/planner/gap_pieces.h"
#include "tramline/planner/order/best_tour.h"

namespace tramline {
namespace {

/// A subfield, and which of the ground's directions is its.
struct Part {
  Polygon shape;
  std::size_t direction = 0;
};

void append_parts(Region region, std::size_t direction, std::vector<Part>& out) {
  std::stable_sort(region.begin(), region.end(),
                   [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
  for (Polygon& polygon : region)
    if (area(polygon) >= kNoGround_m2) out.push_back({oriented(std::move(polygon)), direction});
}

/// What the lines of each direction work of a gap, the direction with the least first.
std::vector<std::pair<std::size_t, Region>> by_direction(const Polygon& gap,
                                                         const std::vector<RepairLine>& lines) {
  std::map<std::size_t, Region> swaths;
  for (const RepairLine& line : lines)
    for (const Polygon& swath : line.swaths)
      if (intersects(bounds(swath), bounds(gap))) swaths[line.place.direction].push_back(swath);
  std::vector<std::pair<std::size_t, Region>> out;
  for (const auto& [direction, region] : swaths) {
    Region worked = intersection({gap}, unite(region));
    if (area(worked) > kNoGround_m2) out.emplace_back(direction, std::move(worked));
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const auto& a, const auto& b) { return area(a.second) < area(b.second); });
  return out;
}

void append_parts_of(const Polygon& gap, const std::vector<RepairLine>& lines, std::vector<Part>& out) {
  std::vector<std::pair<std::size_t, Region>> worked = by_direction(gap, lines);
  Region rest{gap};
  for (std::size_t i = 0; i + 1 < worked.size(); ++i) {
    append_parts(intersection(rest, worked[i].second), worked[i].first, out);
    rest = difference(rest, worked[i].second);
  }
  append_parts(std::move(rest), worked.empty() ? 0 : worked.back().first, out);
}

/// Of the parts in the line's direction, that of which it works most.
int part_of(const RepairLine& line, const std::vector<Part>& parts) {
  int best = -1;
  double most_m2 = -1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].direction != line.place.direction) continue;
    double common_m2 = 0;
    for (const Polygon& swath : line.swaths)
      if (intersects(bounds(swath), bounds(parts[i].shape)))
        common_m2 += area(intersection({swath}, {parts[i].shape}));
    if (common_m2 <= most_m2) continue;
    most_m2 = common_m2;
    best = static_cast<int>(i);
  }
  return best;
}

}  // namespace

void add_lines(Plan& plan, const std::vector<std::size_t>& worked, const std::vector<RepairLine>& lines,
               const RepairGround& ground) {
  std::vector<Part> parts;
  for (const std::size_t i : worked) append_parts_of(ground.gap(i), lines, parts);
  for (const Part& part : parts)
    plan.subfields.push_back({part.shape, ground.frame(part.direction).direction()});
  std::vector<int> tracks(parts.size(), 0);
  std::vector<TrackPiece> pieces;
  for (const RepairLine& line : lines) {
    const int part = part_of(line, parts);
    if (part < 0) continue;  // not so: a line works something that no other direction does
    const StripGrid grid{ground.frame(line.place.direction), line.place.left_m,
                         ground.terms().machine.width_m};
    for (TrackPiece& piece : pieces_of(line.line, grid, part, tracks[static_cast<std::size_t>(part)]++))
      pieces.push_back(std::move(piece));
  }
  const std::vector<order::WorkedLine> driven = order::lines_of(pieces);
  plan.pieces = order::pieces_on(order::best_tour(driven, plan.field, plan.machine.width_m), driven);
}

}  // namespace tramline
