#include "tramline/coverage/deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "tramline/geometry/box_grid.h"
#include "tramline/geometry/path.h"

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

/// The planned lines, ready to be asked for the nearest.
class Tracks {
 public:
  Tracks(const Plan& plan, double within_m) : within_m_(within_m) {
    for (const TrackPiece& piece : plan.pieces)
      for (const PathSegment& segment : centre_line(piece)) append(segment, parts_);
    for (const HeadlandPass& pass : plan.headland.passes)
      for (const PathSegment& segment : pass.path) append(segment, parts_);
    std::vector<Box> boxes;
    for (const PathSegment& part : parts_) boxes.push_back(reach_of({part}, 0));
    grid_ = BoxGrid(boxes);
  }

  /// Infinite where none is within reach.
  double distance_from(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    Box window;
    window.extend(p);
    grid_.each_meeting(window.grown(within_m_),
                       [&](std::size_t i) { least = std::min(least, distance_to_edge(parts_[i], p, p)); });
    return least;
  }

 private:
  double within_m_;
  std::vector<PathSegment> parts_;
  BoxGrid grid_;
};

/// The distance that `share` of the way does not exceed. Precondition: not empty.
double quantile(std::vector<std::pair<double, double>> distance_and_way, double share) {
  std::sort(distance_and_way.begin(), distance_and_way.end());
  double total = 0;
  for (const auto& [distance_m, way_m] : distance_and_way) total += way_m;
  double sum = 0;
  for (const auto& [distance_m, way_m] : distance_and_way) {
    sum += way_m;
    if (sum >= share * total) return distance_m;
  }
  return distance_and_way.back().first;
}

}  // namespace

Deviation deviation(const Plan& plan, const std::vector<DrivenLine>& lines) {
  const double within_m = plan.machine.width_m / 2;
  const Tracks tracks(plan, within_m);
  Deviation out;
  std::vector<std::pair<double, double>> found;
  for (const DrivenLine& line : lines) {
    if (line.run < 0) continue;
    for (std::size_t i = 1; i < line.line.size(); ++i) {
      const double way_m = distance(line.line[i - 1], line.line[i]);
      const double off_m = tracks.distance_from(midpoint(line.line[i - 1], line.line[i]));
      if (off_m > within_m) {
        out.beside_m += way_m;
        continue;
      }
      found.emplace_back(off_m, way_m);
      out.along_m += way_m;
      out.mean_m += off_m * way_m;
      out.most_m = std::max(out.most_m, off_m);
    }
  }
  if (out.along_m > 0) {
    out.mean_m /= out.along_m;
    out.p95_m = quantile(std::move(found), 0.95);
  }
  return out;
}

}  // namespace tramline::coverage
