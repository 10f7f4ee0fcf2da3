#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "drivable";

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

void check_radii(const Path& path, double least_m, std::size_t index, Violations& out) {
  for (const PathSegment& segment : path) {
    if (radius(segment) >= least_m * (1 - kRadiusShare)) continue;
    out.push_back({kRule,
                   fmt::format("{} has an arc of radius {:.3f} m, and {:.3f} m is the least",
                               piece_name(index), radius(segment), least_m),
                   midpoint(segment.from, segment.to), least_m - radius(segment)});
  }
}

/// Where the heading jumps from one segment to the next. The piece comes from its line and goes on to it.
class Joints {
 public:
  Joints(const PieceFrame& frame, std::size_t index, Violations& out)
      : frame_(frame), index_(index), out_(out) {}

  void arrive(Point heading, Point at) {
    const double jump_deg = degrees(std::abs(std::atan2(cross(heading_, heading), dot(heading_, heading))));
    if (jump_deg > kHeadingTolerance_deg)
      out_.push_back({kRule, fmt::format("the heading of {} jumps by {:.2f}°", piece_name(index_), jump_deg),
                      frame_.to_field(at), jump_deg});
  }
  void leave(Point heading) { heading_ = heading; }

 private:
  const PieceFrame& frame_;
  std::size_t index_;
  Violations& out_;
  Point heading_{0, 1};
};

void check_joints(const PieceFrame& frame, const Path& path, std::size_t index, Violations& out) {
  // Rounding alone could turn anything shorter.
  constexpr double kShortest_m = 1e-4;
  Joints joints(frame, index, out);
  for (const PathSegment& segment : moved(path, [&frame](Point p) { return frame.to_local(p); })) {
    if (distance(segment.from, segment.to) < kShortest_m) continue;
    joints.arrive(direction_at_start(segment), segment.from);
    joints.leave(direction_at_end(segment));
  }
  joints.arrive({0, 1}, {0, frame.length()});
}

}  // namespace

double least_radius_m(const Machine& machine) { return std::max(machine.radius_m, 0.5 * machine.width_m); }

void check_drivable(const Case& c, Violations& out) {
  const double least_m = least_radius_m(c.plan.machine);
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    if (piece.detours.empty()) continue;
    const Path path = centre_line(piece);
    check_radii(path, least_m, i, out);
    check_joints(PieceFrame(piece), path, i, out);
  }
}

}  // namespace tramline::check
