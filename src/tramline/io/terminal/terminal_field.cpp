#include "tramline/io/terminal/terminal_field.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/path/path.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/io/export/thinned_line.h"
#include "tramline/model/headland.h"
#include "tramline/model/track.h"

namespace tramline::io {
namespace {

/// A path as a line of few points, within the tolerance: half of it is for arcs, half for points left out.
std::vector<Point> few_points(const Path& path, double tolerance_m) {
  const double half_m = std::max(0.5 * tolerance_m, kChordSagitta);
  std::vector<Point> line = thinned(chords(path, half_m), 0.5 * tolerance_m);
  line.erase(std::unique(line.begin(), line.end()), line.end());
  return line;
}

const TrackPiece* longest_piece(const Plan& plan, std::size_t subfield) {
  const TrackPiece* out = nullptr;
  for (const TrackPiece& piece : plan.pieces)
    if (piece.subfield == subfield && (out == nullptr || length(piece) > length(*out))) out = &piece;
  return out;
}

/// The line through a piece, from where the shape begins along it to where it ends.
std::vector<Point> prolonged(Point from, Point to, const Polygon& shape) {
  const Point along = (1 / distance(from, to)) * (to - from);
  double first_m = 0, last_m = distance(from, to);
  for (const Point corner : shape.outer) {
    first_m = std::min(first_m, dot(corner - from, along));
    last_m = std::max(last_m, dot(corner - from, along));
  }
  return {from + first_m * along, from + last_m * along};
}

/// The longest stretch of a curved piece without a detour, and the track it is on.
struct Stretch {
  Path path;
  int track = 0;
};

Stretch longest_stretch(const Plan& plan, std::size_t subfield) {
  Stretch out;
  for (const TrackPiece& piece : plan.pieces) {
    if (piece.subfield != subfield) continue;
    for (Path& part : parts_on_track(piece))
      if (out.path.empty() || length(part) > length(out.path)) out = {std::move(part), piece.track};
  }
  return out;
}

TerminalLine line_of_subfield(const Plan& plan, std::size_t subfield, double tolerance_m) {
  TerminalLine out{"", true, {}, subfield, 0};
  const TrackPiece* const longest = longest_piece(plan, subfield);
  if (longest == nullptr) return out;
  out.track = longest->track;
  if (longest->curve.empty()) {
    out.points = prolonged(longest->start, longest->end, plan.subfields[subfield].shape);
  } else {
    const Stretch stretch = longest_stretch(plan, subfield);
    out.track = stretch.track;
    out.points = few_points(stretch.path, tolerance_m);
  }
  out.name = fmt::format("{} {}", out.straight() ? "AB" : "Curve", subfield + 1);
  return out;
}

void add_line(std::vector<TerminalLine>& lines, TerminalLine line) {
  if (line.points.size() >= 2) lines.push_back(std::move(line));
}

std::vector<TerminalLine> lines_of_subfields(const Plan& plan, double tolerance_m) {
  std::vector<TerminalLine> out;
  for (std::size_t i = 0; i < plan.subfields.size(); ++i)
    add_line(out, line_of_subfield(plan, i, tolerance_m));
  return out;
}

std::vector<TerminalLine> all_lines(const Plan& plan, double tolerance_m) {
  std::vector<TerminalLine> out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    add_line(out,
             {fmt::format("Track {}", i + 1), false, few_points(centre_line(plan.pieces[i]), tolerance_m),
              plan.pieces[i].subfield, plan.pieces[i].track});
  for (std::size_t i = 0; i < plan.headland.passes.size(); ++i)
    add_line(out, {fmt::format("Headland {}", i + 1), false,
                   few_points(plan.headland.passes[i].path, tolerance_m)});
  return out;
}

/// A ring that would collapse keeps all of its points.
Ring thinned_ring(Ring ring, double tolerance_m) {
  ring.push_back(ring.front());
  std::vector<Point> few = thinned(ring, tolerance_m);
  std::vector<Point>& kept = few.size() < 4 ? ring : few;
  kept.pop_back();
  return std::move(kept);
}

Region thinned_region(const Region& region, double tolerance_m) {
  Region out;
  for (const Polygon& polygon : region) {
    Polygon& thin = out.emplace_back(Polygon{thinned_ring(polygon.outer, tolerance_m), {}});
    for (const Ring& hole : polygon.holes) thin.holes.push_back(thinned_ring(hole, tolerance_m));
  }
  return out;
}

void require_a_place(const LocalFrame& frame, const std::string& field, const std::string& file) {
  if (!frame.geodetic)
    throw bad_input(
        fmt::format("{}: field '{}' is in plain metres, which have no place on the globe; plan it from "
                    "a file with a coordinate reference system, or name one with --crs then",
                    file, field));
}

}  // namespace

std::vector<TerminalLine> lines_of(const Plan& plan, LineChoice choice, double tolerance_m) {
  return choice == LineChoice::kAll ? all_lines(plan, tolerance_m) : lines_of_subfields(plan, tolerance_m);
}

double true_heading_deg(const TerminalLine& line, const LocalFrame& frame, Point a_lonlat) {
  const Heading heading = Heading::from_to(line.points[0], line.points[1]);
  // The frame's north is turned against the true one by the convergence of meridians, Δλ·sin φ.
  const double convergence_deg =
      (a_lonlat.x - frame.origin_lon_deg) * std::sin(a_lonlat.y * std::numbers::pi / 180);
  return std::fmod(heading.degrees() + convergence_deg + 360, 360);
}

LineCounts counts_of(const std::vector<TerminalLine>& lines) {
  const auto curves =
      std::count_if(lines.begin(), lines.end(), [](const TerminalLine& line) { return !line.straight(); });
  return {lines.size(), static_cast<std::size_t>(curves)};
}

TerminalField terminal_field(const Plan& plan, LineChoice choice, double tolerance_m,
                             const std::string& file) {
  require_a_place(plan.field.frame, plan.field.id, file);
  TerminalField out;
  out.name = plan.field.id;
  out.frame = plan.field.frame;
  out.width_m = plan.machine.width_m;
  out.area_m2 = area_m2(plan.field);
  out.outer = plan.field.outer;
  out.obstacles = plan.field.obstacles;
  out.headland = thinned_region(plan.headland.ground, tolerance_m);
  if (!out.headland.empty()) out.body = thinned_region(plan.body, tolerance_m);
  out.lines = lines_of(plan, choice, tolerance_m);
  out.worked = plan.worked;
  if (!is_repair(plan)) return out;
  for (Polygon& gap : thinned_region(plan.body, tolerance_m))
    out.gaps.push_back({static_cast<int>(out.gaps.size()) + 1, std::move(gap)});
  return out;
}

std::vector<TerminalField> terminal_fields(const Coverage& coverage, double tolerance_m,
                                           const std::string& file) {
  require_a_place(coverage.frame, coverage.field_id, file);
  if (coverage.field.empty())
    throw bad_input(
        fmt::format("{}: the drive was evaluated without a field; evaluate it again with --field", file));
  std::vector<TerminalField> out;
  for (const Polygon& part : coverage.field) {
    TerminalField& field = out.emplace_back();
    field.name = coverage.field_id;
    field.frame = coverage.frame;
    field.width_m = coverage.width_m;
    field.area_m2 = area(part);
    field.outer = part.outer;
    for (const Ring& hole : part.holes)
      field.obstacles.push_back({{reversed(hole), {}}, ObstacleKind::kObstacle, ""});
    field.worked = intersection(coverage.covered, {part});
    for (const Gap& gap : coverage.gaps)
      if (contains(part, gap.centre))
        field.gaps.push_back({gap.number, thinned_region({gap.shape}, tolerance_m).front()});
  }
  return out;
}

}  // namespace tramline::io
