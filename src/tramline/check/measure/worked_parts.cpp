#include "tramline/check/measure/worked_parts.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/path_distance.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline::check {
namespace {

/// The parts of one swath, one after the other.
class SwathParts {
 public:
  SwathParts(std::size_t piece, double width_m, std::vector<WorkedPart>& out)
      : piece_(piece), width_m_(width_m), out_(out) {}

  void add(Path line, Region ground, bool kinked = false) {
    const double before = turned_;
    for (const PathSegment& segment : line) turn_along(segment);
    out_.push_back({piece_, std::move(line), std::move(ground), kinked, before, turned_});
  }
  void add(const PathSegment& segment) { add({segment}, bands_along({segment}, width_m_, kLayerSagitta)); }
  void add(const Path& path) {
    Region ground;
    append_ground(band(path, width_m_, kLayerSagitta), has_arcs(path) ? Folds::kPerhaps : Folds::kNever,
                  ground);
    add(path, std::move(ground));
  }

 private:
  void turn_along(const PathSegment& segment) {
    const Point heading = direction_at_start(segment);
    const bool jumps = begun_ && distance(heading, heading_) > kStraightOn;
    const bool tight = 2 * radius(segment) <= width_m_ * (1 - kRounding);
    turned_ += std::abs(turning(segment)) + (jumps || tight ? std::numbers::pi : 0);
    heading_ = direction_at_end(segment);
    begun_ = true;
  }

  std::size_t piece_;
  double width_m_;
  std::vector<WorkedPart>& out_;
  double turned_ = 0;
  bool begun_ = false;
  Point heading_;
};

void append_whole(const TrackPiece& piece, double width_m, SwathParts& out) {
  Region ground;
  append_ground(swath(piece, width_m), piece.detours.empty() ? Folds::kNever : Folds::kPerhaps, ground);
  out.add(centre_line(piece), std::move(ground));
}

void append_between_detours(const TrackPiece& piece, SwathParts& out) {
  const std::vector<PathSegment> straight = straight_parts(piece);
  // Between two detours, and before the first, there may be none: by place along the piece.
  const Point along = piece.end - piece.start;
  const auto along_of = [&](Point p) { return dot(p - piece.start, along); };
  auto next = straight.begin();
  for (const Detour& detour : piece.detours) {
    for (; next != straight.end() && along_of(next->to) <= along_of(detour.path.back().to); ++next)
      out.add(*next);
    out.add(detour.path);
  }
  for (; next != straight.end(); ++next) out.add(*next);
}

template <class AppendStraight>
std::vector<WorkedPart> parts_of(const Plan& plan, AppendStraight append_straight) {
  std::vector<WorkedPart> out;
  const double width_m = plan.machine.width_m;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const TrackPiece& piece = plan.pieces[i];
    SwathParts parts(i, width_m, out);
    if (is_kinked(piece.curve)) {
      const Region cells = bands_along(piece.curve, width_m);
      for (std::size_t k = 0; k < cells.size(); ++k) parts.add({piece.curve[k]}, {cells[k]}, true);
    } else if (piece.curve.empty()) {
      append_straight(piece, parts);
    } else {
      for (const PathSegment& segment : piece.curve) parts.add(segment);
    }
  }
  return out;
}

}  // namespace

std::vector<WorkedPart> worked_parts(const Plan& plan) {
  return parts_of(plan, [&plan](const TrackPiece& piece, SwathParts& out) {
    append_whole(piece, plan.machine.width_m, out);
  });
}

std::vector<WorkedPart> parts_between_detours(const Plan& plan) {
  return parts_of(plan, append_between_detours);
}

Region pass_bands(const Plan& plan, const HeadlandPass& pass, double sagitta_m) {
  if (is_of_lines(plan)) return bands_along(pass.path, plan.machine.width_m, sagitta_m);
  return pass_bands_along(pass.path, plan.headland.construction, plan.machine.width_m, sagitta_m);
}

std::vector<WorkedPart> pass_parts(const Plan& plan, double sagitta_m) {
  std::vector<WorkedPart> out;
  const double width_m = plan.machine.width_m;
  for (std::size_t k = 0; k < plan.headland.passes.size(); ++k) {
    SwathParts parts(plan.pieces.size() + k, width_m, out);
    const HeadlandPass& pass = plan.headland.passes[k];
    const bool has_corners = plan.headland.construction == HeadlandConstruction::kPlain ||
                             (is_of_lines(plan) && is_kinked(pass.path));
    if (has_corners) {
      const Region cells = pass_bands(plan, pass, sagitta_m);
      for (std::size_t i = 0; i < cells.size(); ++i) parts.add({pass.path[i]}, {cells[i]}, true);
      continue;
    }
    for (const PathSegment& segment : pass.path)
      parts.add({segment}, flat_bands_along({segment}, width_m, sagitta_m));
  }
  return out;
}

bool may_meet(const WorkedPart& earlier, const WorkedPart& later, double width_m) {
  if (earlier.kinked && later.kinked) {
    const Ring both = convex_intersection(earlier.ground.front().outer, later.ground.front().outer);
    return std::abs(signed_area(both)) > kThinnestShown_m * perimeter(both);
  }
  if (earlier.piece == later.piece && later.turned_after - earlier.turned_before <= std::numbers::pi / 2)
    return false;
  const double reach_m = earlier.kinked || later.kinked ? 2 * width_m : width_m;  // mitres are longer
  return distance_between(earlier.line, later.line) < reach_m - kThinnestShown_m;
}

}  // namespace tramline::check
