#include "tramline/route/build/leg_list.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/index/edge_index.h"
#include "tramline/model/speeds.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

/// Where a pass comes to a passable obstacle or leaves it is looked for in steps of this, m, and found to
/// kInterruption_m.
constexpr double kLookedFor_m = 0.25;
constexpr double kInterruption_m = 1e-6;

/// A stretch of a pass with the work on or off.
struct PassPart {
  double from_m = 0;
  double to_m = 0;
  bool work = true;
};

Region passables(const Field& field) {
  Region out;
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) out.push_back(obstacle.shape);
  return out;
}

/// Where between two places on a path, only one of which is on the land, its edge is.
double edge_between(const SteeredPath& path, const EdgeIndex& land, double low_m, double high_m) {
  const bool low_inside = land.contains(pose_on(path, low_m).at);
  while (high_m - low_m > kInterruption_m) {
    const double middle_m = 0.5 * (low_m + high_m);
    (land.contains(pose_on(path, middle_m).at) == low_inside ? low_m : high_m) = middle_m;
  }
  return high_m;
}

/// `implement`: the way of the implement along the pass.
std::vector<PassPart> parts_of(const SteeredPath& implement, const Region& passable) {
  const double length_m = length(implement);
  if (passable.empty()) return {{0, length_m, true}};
  const EdgeIndex land(passable);
  const double steps = std::max(1.0, std::ceil(length_m / kLookedFor_m));
  std::vector<PassPart> out{{0, 0, !land.contains(implement.front().start.at)}};
  for (double step = 1; step <= steps; ++step) {
    const double before_m = (step - 1) / steps * length_m, at_m = step / steps * length_m;
    const bool work = !land.contains(pose_on(implement, at_m).at);
    if (work != out.back().work) {
      const double edge_m = edge_between(implement, land, before_m, at_m);
      out.back().to_m = edge_m;
      out.push_back({edge_m, edge_m, work});
    }
  }
  out.back().to_m = length_m;
  return out;
}

}  // namespace

void LegList::add(const Way& way) {
  for (RouteLeg& leg : legs_of(way)) legs_.push_back(std::move(leg));
}

void LegList::add(const order::WorkedLine& line, std::size_t first_piece) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    RouteLeg leg;
    leg.kind = LegKind::kWork;
    leg.work = true;
    leg.piece = first_piece + i;
    leg.path = axle_path(line[i], *turning_);
    if (i > 0) {
      RouteLeg across;
      across.kind = LegKind::kTransit;
      const Pose from = end_of(legs_.back().path);
      across.path = {arc_from(from, distance(from.at, leg.path.front().start.at), 0, Gear::kForward)};
      legs_.push_back(std::move(across));
    }
    legs_.push_back(std::move(leg));
  }
}

void LegList::add(const HeadlandPass& pass, std::size_t number, const PassEntry& entry) {
  const SteeredPath axle = axle_path(pass, entry, *turning_);
  const Region passable = passables(*field_);
  for (const PassPart& part : parts_of(steered(worked_path(pass, entry)), passable)) {
    RouteLeg leg;
    leg.kind = part.work ? LegKind::kHeadland : LegKind::kTransit;
    leg.work = part.work;
    leg.pass = number;
    leg.path = part_of(axle, part.from_m, part.to_m);
    if (!leg.path.empty()) legs_.push_back(std::move(leg));
  }
}

double leg_seconds(const RouteLeg& leg, Gear before, const Turning& turning) {
  return length(leg) / speed_of(leg, turning) + (leg.gear != before ? turning.gear_change_s : 0);
}

std::vector<RouteLeg> LegList::finished() && {
  Gear gear = Gear::kForward;
  for (RouteLeg& leg : legs_) {
    leg.time_s = leg_seconds(leg, gear, *turning_);
    gear = leg.gear;
  }
  return std::move(legs_);
}

}  // namespace tramline
