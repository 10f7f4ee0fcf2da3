#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "tramline/check/file/compare_layers.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr double kOff_m = 2 * kChordSagitta;

/// A position on a path: a segment, and a point on it.
struct Station {
  std::size_t segment = 0;
  Point at;
};

/// Follows a path with the vertices of a line that should show it. All in the frame of the piece.
class PathWalk {
 public:
  explicit PathWalk(const Path& path) : path_(path), at_{0, path.front().from} {}

  /// Whether the next vertex is on the path ahead, and the chord to it is near to all of the path between.
  bool goes_on_to(Point vertex) {
    for (std::size_t k = at_.segment; k < path_.size(); ++k) {
      if (distance_to_edge(path_[k], vertex, vertex) > kOff_m) continue;
      const Station next{k, vertex};
      if (!is_ahead(next) || !chord_follows(next)) continue;
      at_ = next;
      return true;
    }
    return false;
  }

  /// Whether the end of the path is reached.
  bool is_over() const {
    for (std::size_t k = at_.segment; k < path_.size(); ++k)
      if (distance(path_[k].to, at_.at) > kOff_m) return false;
    return true;
  }

 private:
  /// No more than the tolerance backwards, on the same segment.
  bool is_ahead(const Station& next) const {
    if (next.segment > at_.segment) return true;
    const Point step = next.at - at_.at;
    if (length(step) <= kOff_m) return true;
    const PathSegment& segment = path_[next.segment];
    return segment.straight() ? dot(step, segment.to - segment.from) > 0
                              : distance(next.at, segment.from) > distance(at_.at, segment.from);
  }

  bool chord_follows(const Station& next) const {
    for (std::size_t k = at_.segment; k <= next.segment; ++k) {
      const Point from = k == at_.segment ? at_.at : path_[k].from;
      const Point to = k == next.segment ? next.at : path_[k].to;
      const double off = std::max(distance_to_edge({at_.at, next.at, 0}, from, from),
                                  distance_to_edge({at_.at, next.at, 0}, to, to));
      if (off + sagitta(distance(from, to), path_[k].curvature) > kOff_m) return false;
    }
    return true;
  }
  /// Of an arc over a chord.
  static double sagitta(double chord_m, double curvature) {
    const double half_sine = std::min(1.0, 0.5 * chord_m * std::abs(curvature));
    return half_sine == 0 ? 0 : 0.5 * chord_m * std::tan(0.5 * std::asin(half_sine));
  }

  const Path& path_;
  Station at_;
};

/// The index of the vertex at which a line first leaves the path; nullopt where it shows the whole path.
std::optional<std::size_t> first_astray(const std::vector<Point>& line, const Path& path) {
  if (line.empty() || distance(line.front(), path.front().from) > kSaidTwice) return 0;
  PathWalk walk(path);
  for (std::size_t i = 0; i < line.size(); ++i)
    if (!walk.goes_on_to(line[i])) return i;
  if (!walk.is_over() || distance(line.back(), path.back().to) > kSaidTwice) return line.size() - 1;
  return std::nullopt;
}

/// The chords of a line that have a direction.
Path path_along(const std::vector<Point>& line) {
  Path out;
  for (const Point p : line) {
    const Point from = out.empty() ? line.front() : out.back().to;
    if (distance(from, p) >= kShortestTurned_m) out.push_back({from, p, 0});
  }
  return out;
}

struct Bend {
  double excess_deg = 0;  ///< of turning over what the curvature explains
  Point at;
};

/// The stretch of a polyline that turns most, to one side, over what the curvature allows on the way
/// between the middles of its first and last chord. Kinks and arcs too tight both show. O(n).
Bend worst_bend(const Path& line, double curvature) {
  Bend worst;
  for (const double side : {-1.0, 1.0}) {
    double excess = 0;
    for (std::size_t i = 0; i + 1 < line.size(); ++i) {
      const Point a = line[i].to - line[i].from, b = line[i + 1].to - line[i + 1].from;
      const double turn = side * std::atan2(cross(a, b), dot(a, b));
      excess = std::max(0.0, excess) + turn - curvature * 0.5 * (length(a) + length(b));
      if (const double deg = excess * 180 / std::numbers::pi; deg > worst.excess_deg)
        worst = {deg, line[i].to};
    }
  }
  return worst;
}

/// Checks a line that does not agree with the path as if it were driven: it may have been edited on purpose.
void judge_line(const Case& c, std::size_t index, const std::vector<Point>& line, Violations& out) {
  const std::string name = "the line stored for " + piece_name(index);
  const Path path = path_along(line);
  if (path.empty()) return;
  const PieceFrame frame(c.plan.pieces[index]);
  const SwathClearance swath(frame, path, 0.5 * c.plan.machine.width_m);
  check_line_within_field(c, swath, name, out);
  check_clearance_of(c, swath, name, out);
  const double curvature = (1 + kRadiusShare) / least_radius_m(c.plan.machine);
  const Bend bend = worst_bend(path, curvature);
  if (bend.excess_deg > kHeadingTolerance_deg)
    out.push_back(
        {Rule::kDrivable,
         fmt::format("{} turns {:.2f}° more than a machine of this radius can", name, bend.excess_deg),
         bend.at, bend.excess_deg});
}

}  // namespace

std::vector<Violation> compare_lines(const Plan& plan, const std::vector<std::vector<Point>>& lines) {
  std::vector<Violation> out;
  if (lines.size() != plan.pieces.size()) {
    out.push_back({Rule::kLayers,
                   fmt::format("there are {} lines for {} tracks", lines.size(), plan.pieces.size()),
                   {},
                   static_cast<double>(lines.size()) - static_cast<double>(plan.pieces.size())});
    return out;
  }
  std::optional<Case> c;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const PieceFrame frame(plan.pieces[i]);
    const auto to_local = [&frame](Point p) { return frame.to_local(p); };
    std::vector<Point> line;
    for (const Point p : lines[i]) line.push_back(to_local(p));
    const auto astray = first_astray(line, moved(centre_line(plan.pieces[i]), to_local));
    if (!astray) continue;
    out.push_back(
        {Rule::kLayers,
         fmt::format("the line stored for {} is not its path from vertex {} on", piece_name(i), *astray + 1),
         line.empty() ? plan.pieces[i].start : lines[i][*astray], 0});
    if (!c) c.emplace(plan);
    judge_line(*c, i, lines[i], out);
  }
  return out;
}

}  // namespace tramline::check
