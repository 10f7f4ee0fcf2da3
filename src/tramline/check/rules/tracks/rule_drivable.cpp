#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>
#include <utility>

#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

void check_radii(const Path& path, double least_m, const std::string& name, Violations& out) {
  for (const PathSegment& segment : path) {
    if (radius(segment) >= least_m * (1 - kRadiusShare)) continue;
    out.push_back({Rule::kDrivable,
                   fmt::format("{} has an arc of radius {:.3f} m, the least is {:.3f} m", name,
                               radius(segment), least_m),
                   midpoint(segment.from, segment.to), least_m - radius(segment)});
  }
}

/// A jump of the heading from one segment to the next.
class Joints {
 public:
  Joints(std::string name, Violations& out) : name_(std::move(name)), out_(out) {}

  void arrive(Point heading, Point at) {
    const double jump_deg = degrees(std::abs(std::atan2(cross(heading_, heading), dot(heading_, heading))));
    if (jump_deg > kHeadingTolerance_deg)
      out_.push_back({Rule::kDrivable, fmt::format("the heading of {} jumps by {:.2f}°", name_, jump_deg), at,
                      jump_deg});
  }
  void leave(Point heading) { heading_ = heading; }
  /// The segments of a path but those so short that rounding alone could turn them.
  void drive(const Path& path) {
    for (const PathSegment& segment : path) {
      if (distance(segment.from, segment.to) < kShortestTurned_m) continue;
      if (length(heading_) > 0) arrive(direction_at_start(segment), segment.from);
      if (!first_) first_ = segment;
      leave(direction_at_end(segment));
    }
  }
  /// From the last segment driven on to the first.
  void close() {
    if (first_) arrive(direction_at_start(*first_), first_->from);
  }

 private:
  std::string name_;
  Violations& out_;
  Point heading_{0, 0};  ///< not known yet
  std::optional<PathSegment> first_;
};

/// The middle of a detour as Versleijen 2019 draws it may be as tight as the obstacle's buffer, w/2 (fig.
/// 19), which is a finding; its first and last segments are arcs that the machine can drive.
void check_detour_as_printed(const Detour& detour, const Machine& machine, const std::string& name,
                             Violations& out, Violations& findings) {
  const Path middle(detour.path.begin() + 1, detour.path.end() - 1);
  check_radii({detour.path.front(), detour.path.back()}, least_radius_m(machine), name, out);
  check_radii(middle, 0.5 * machine.width_m, name, out);
  check_radii(middle, least_radius_m(machine), name, findings);
}

void check_detours_as_printed(const TrackPiece& piece, std::size_t index, const Machine& machine,
                              Violations& out, Violations& findings) {
  for (std::size_t k = 0; k < piece.detours.size(); ++k)
    if (piece.detours[k].path.size() > 2)
      check_detour_as_printed(piece.detours[k], machine, detour_name(index, k), out, findings);
    else
      check_radii(piece.detours[k].path, least_radius_m(machine), detour_name(index, k), out);
  for (const Path& part : parts_on_track(piece))
    check_radii(part, least_radius_m(machine), piece_name(index), out);
}

void check_joints(const TrackPiece& piece, const std::string& name, Violations& out) {
  const Path path = centre_line(piece);
  Joints joints(name, out);
  if (!piece.curve.empty()) {
    joints.drive(path);
    return;
  }
  // A detour comes from its line and returns to it.
  const Point along = (1 / distance(piece.start, piece.end)) * (piece.end - piece.start);
  joints.leave(along);
  joints.drive(path);
  joints.arrive(along, piece.end);
}

void check_pass(const HeadlandPass& pass, double least_m, const std::string& name, Violations& out) {
  check_radii(pass.path, least_m, name, out);
  Joints joints(name, out);
  joints.drive(pass.path);
  if (is_closed(pass)) joints.close();
}

}  // namespace

void check_drivable(const Case& c, Violations& out, Violations& findings) {
  const double least_m = least_radius_m(c.plan.machine);
  const bool as_in_paper = c.plan.settings.tracks == TrackConstruction::kPaper;
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    if (piece.detours.empty() && piece.curve.empty()) continue;
    if (c.plan.settings.avoid == Avoidance::kPaper)
      check_detours_as_printed(piece, i, c.plan.machine, out, findings);
    else
      check_radii(centre_line(piece), least_m, piece_name(i), as_in_paper ? findings : out);
    check_joints(piece, piece_name(i), as_in_paper ? findings : out);
  }
  const auto& passes = c.plan.headland.passes;
  if (c.plan.headland.construction == HeadlandConstruction::kPlain) return;
  for (std::size_t i = 0; i < passes.size(); ++i) check_pass(passes[i], least_m, pass_name(i), out);
}

}  // namespace tramline::check
