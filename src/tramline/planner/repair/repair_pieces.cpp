#include "tramline/planner/repair/repair_pieces.h"

#include <algorithm>
#include <map>
#include <optional>
#include <tuple>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/tolerances.h"
#include "tramline/route/order/best_tour.h"

namespace tramline {
namespace {

/// A subfield with the index of its direction in the ground.
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

/// The parts of a gap that the lines of each direction work, by direction, the smallest area first.
std::vector<std::pair<std::size_t, Region>> by_direction(const Polygon& gap,
                                                         const std::vector<RepairLine>& lines) {
  std::map<std::size_t, Region> swaths;
  for (const RepairLine& line : lines)
    for (const Polygon& swath : line.swaths)
      if (intersects(bounds(swath), bounds(gap))) swaths[line.position.direction].push_back(swath);
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

/// The index of the part in the line's direction of which the line works most.
std::optional<std::size_t> part_of(const RepairLine& line, const std::vector<Part>& parts) {
  std::optional<std::size_t> best;
  double most_m2 = -1;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (parts[i].direction != line.position.direction) continue;
    double common_m2 = 0;
    for (const Polygon& swath : line.swaths)
      if (intersects(bounds(swath), bounds(parts[i].shape)))
        common_m2 += area(intersection({swath}, {parts[i].shape}));
    if (common_m2 <= most_m2) continue;
    most_m2 = common_m2;
    best = i;
  }
  return best;
}

struct LaidLine {
  std::size_t part = 0;
  const RepairLine* line = nullptr;
};

/// By subfield, from left to right and along.
std::vector<LaidLine> sorted_lines(const std::vector<RepairLine>& lines, const std::vector<Part>& parts) {
  std::vector<LaidLine> out;
  for (const RepairLine& line : lines)
    if (const auto part = part_of(line, parts)) out.push_back({*part, &line});
  const auto key = [](const LaidLine& laid) {
    return std::tuple(laid.part, laid.line->position.left_m, laid.line->line.pieces.front().from);
  };
  std::sort(out.begin(), out.end(), [&](const LaidLine& a, const LaidLine& b) { return key(a) < key(b); });
  return out;
}

/// The pieces of a line, which lies on strip 0 of the grid, in the field's frame and in order along it. They
/// get the given subfield and track number.
std::vector<TrackPiece> pieces_of(const GapLine& line, const StripGrid& grid, std::size_t subfield,
                                  int track) {
  std::vector<TrackPiece> out;
  const double across = grid.centre(0);
  for (const LaidPiece& piece : line.pieces) {
    TrackPiece driven;
    driven.start = grid.frame.to_field({across, piece.from});
    driven.end = grid.frame.to_field({across, piece.to});
    driven.subfield = subfield;
    driven.track = track;
    driven.stop_at_start = piece.stop_at_from;
    driven.stop_at_end = piece.stop_at_to;
    driven.after_crossing = piece.after_crossing;
    out.push_back(std::move(driven));
  }
  return out;
}

/// Each line is a track of its own, numbered from 0 in its subfield.
std::vector<TrackPiece> laid(const std::vector<RepairLine>& lines, const std::vector<Part>& parts,
                             const RepairGround& ground) {
  std::vector<TrackPiece> out;
  std::optional<std::size_t> part;
  int track = 0;
  for (const LaidLine& next : sorted_lines(lines, parts)) {
    track = next.part == part ? track + 1 : 0;
    part = next.part;
    const LinePosition& position = next.line->position;
    const StripGrid grid{ground.frame(position.direction), position.left_m, ground.terms().machine.width_m};
    for (TrackPiece& piece : pieces_of(next.line->line, grid, next.part, track))
      out.push_back(std::move(piece));
  }
  return out;
}

std::vector<TrackPiece> in_driving_order(const std::vector<TrackPiece>& pieces, const Plan& plan) {
  const std::vector<order::WorkedLine> lines = order::lines_of(pieces);
  return order::pieces_on(order::best_tour(lines, plan.field, plan.machine.width_m), lines);
}

}  // namespace

void add_lines(Plan& plan, const std::vector<std::size_t>& worked, const std::vector<RepairLine>& lines,
               const RepairGround& ground) {
  std::vector<Part> parts;
  for (const std::size_t i : worked) append_parts_of(ground.gap(i), lines, parts);
  for (const Part& part : parts)
    plan.subfields.push_back({part.shape, ground.frame(part.direction).direction()});
  plan.pieces = in_driving_order(laid(lines, parts, ground), plan);
}

}  // namespace tramline
