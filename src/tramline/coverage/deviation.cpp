#include "tramline/coverage/deviation.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/path.h"

namespace tramline::coverage {
namespace {

/// Tracks are looked at in parts no longer than this, so that few lie in the box of any, m.
constexpr double kPart_m = 20;

void append(const PathSegment& segment, std::vector<PathSegment>& out) {
  if (!segment.straight()) {
    out.push_back(segment);
    return;
  }
  const double count = std::max(1.0, std::ceil(length(segment) / kPart_m));
  const Point part = (1 / count) * (segment.to - segment.from);
  for (double i = 0; i < count; ++i)
    out.push_back({segment.from + i * part, segment.from + (i + 1) * part, 0});
}

/// Where the path leads at its place nearest to p.
Direction direction_near(const PathSegment& part, Point p) {
  if (part.straight()) return Direction::along(part.from, part.to);
  return Direction::along(centre(part), p).perpendicular();
}

/// A planned line as seen from a step.
struct Seen {
  double distance_m = std::numeric_limits<double>::infinity();
  double angle_deg = 0;  ///< between its direction and the step's
};

/// The planned lines, ready to be asked for the nearest.
class Tracks {
 public:
  explicit Tracks(const Plan& plan) {
    for (const TrackPiece& piece : plan.pieces)
      for (const PathSegment& segment : centre_line(piece)) append(segment, parts_);
    for (const HeadlandPass& pass : plan.headland.passes)
      for (const PathSegment& segment : pass.path) append(segment, parts_);
    std::vector<Box> boxes;
    for (const PathSegment& part : parts_) {
      boxes.push_back(reach_of({part}, 0));
      all_.extend(boxes.back());
    }
    grid_ = BoxGrid(boxes);
  }

  bool empty() const { return parts_.empty(); }

  /// The nearest within reach whose direction is no further off than that; nullopt: none.
  std::optional<Seen> nearest(Point p, Direction course, double within_m, double within_deg) const {
    std::optional<Seen> best;
    Box window;
    window.extend(p);
    grid_.each_meeting(window.grown(within_m), [&](std::size_t i) {
      const double off_m = distance_to_edge(parts_[i], p, p);
      if (off_m > within_m || (best && off_m >= best->distance_m)) return;
      const double angle_deg = angle_between(course, direction_near(parts_[i], p)).degrees();
      if (angle_deg <= within_deg) best = Seen{off_m, angle_deg};
    });
    return best;
  }

  /// However far it is. Precondition: not empty.
  Seen nearest_anywhere(Point p, Direction course, double first_look_m) const {
    assert(!empty());
    Box everything = all_;
    everything.extend(p);
    const double most_m = std::hypot(everything.width(), everything.height());
    for (double within_m = first_look_m; within_m < most_m; within_m *= 4)
      if (const std::optional<Seen> found = nearest(p, course, within_m, kAnyAngle_deg)) return *found;
    return nearest(p, course, most_m + first_look_m, kAnyAngle_deg).value_or(Seen{most_m, 0});
  }

 private:
  static constexpr double kAnyAngle_deg = 180;
  std::vector<PathSegment> parts_;
  Box all_;
  BoxGrid grid_;
};

/// A value, and the way on which it was so.
using Weighted = std::vector<std::pair<double, double>>;

/// What `share` of the way does not exceed; NaN where there is none.
double quantile(Weighted values, double share) {
  if (values.empty()) return std::numeric_limits<double>::quiet_NaN();
  std::sort(values.begin(), values.end());
  double total = 0;
  for (const auto& [value, way_m] : values) total += way_m;
  double sum = 0;
  for (const auto& [value, way_m] : values) {
    sum += way_m;
    if (sum >= share * total) return value;
  }
  return values.back().first;
}

/// Calls `visit(middle, direction, way_m)` for every step at work that leads anywhere.
template <class Visit>
void each_worked_step(const std::vector<DrivenLine>& lines, Visit visit) {
  for (const DrivenLine& line : lines) {
    if (line.run < 0) continue;
    for (std::size_t i = 1; i < line.line.size(); ++i) {
      const Point from = line.line[i - 1], to = line.line[i];
      if (const double way_m = distance(from, to); way_m > 0)
        visit(midpoint(from, to), Direction::along(from, to), way_m);
    }
  }
}

}  // namespace

double Deviation::followed_share() const {
  const double whole_m = along_m + beside_m;
  return whole_m > 0 ? along_m / whole_m : 0;
}

Deviation deviation(const Plan& plan, const std::vector<DrivenLine>& lines) {
  const double within_m = plan.machine.width_m / 2;
  const Tracks tracks(plan);
  Deviation out;
  Weighted followed, distances, angles;
  each_worked_step(lines, [&](Point middle, Direction course, double way_m) {
    if (const auto track = tracks.nearest(middle, course, within_m, kAlongTrack.degrees())) {
      followed.emplace_back(track->distance_m, way_m);
      out.along_m += way_m;
      out.mean_m += track->distance_m * way_m;
      out.most_m = std::max(out.most_m, track->distance_m);
    } else {
      out.beside_m += way_m;
    }
    if (tracks.empty()) return;
    const Seen seen = tracks.nearest_anywhere(middle, course, within_m);
    distances.emplace_back(seen.distance_m, way_m);
    angles.emplace_back(seen.angle_deg, way_m);
  });
  if (out.along_m > 0) {
    out.mean_m /= out.along_m;
    out.p95_m = quantile(std::move(followed), 0.95);
  }
  out.median_distance_m = quantile(std::move(distances), 0.5);
  out.median_angle_deg = quantile(std::move(angles), 0.5);
  return out;
}

}  // namespace tramline::coverage
