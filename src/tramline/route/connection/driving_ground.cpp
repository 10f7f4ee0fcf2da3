#include "tramline/route/connection/driving_ground.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/model/rate_values.h"
#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/outline/tolerances.h"

namespace tramline {
namespace {

/// The land with the passable obstacles on it; nothing where there are none.
std::optional<AllowedLand> with_passables(const AllowedLand& land, const Field& field) {
  Region all = land.land();
  const std::size_t before = all.size();
  for (const Obstacle& obstacle : field.obstacles)
    if (obstacle.kind == ObstacleKind::kPassable) all.push_back(obstacle.shape);
  if (all.size() == before) return std::nullopt;
  return AllowedLand(unite(all));
}

/// Land of the tracks counts so many times the time over it besides that time, for the soil under the wheels
/// and the marks on it, and besides what standing crop is worth; and no more than so many times, so that a
/// way with room over crop is still taken before one without room.
constexpr double kMoreOverSoil = 1, kMostMore = 10;
/// Along a track the same counts this share of it.
constexpr double kAlongTrack = 1.0 / 6;

double more_over_crop_of(const Machine& machine) {
  const double crop_s_per_m = driven_over_seconds_per_m(rates_of(machine));
  return std::min(kMostMore, kMoreOverSoil + crop_s_per_m * machine.turning.turning_speed_mps);
}

Machine drivable(Machine machine) {
  machine.radius_m = std::max(machine.radius_m, kLeastRadius_m);
  return machine;
}

Region oriented_all(const Region& region) {
  Region out;
  for (const Polygon& polygon : region) out.push_back(oriented(polygon));
  return out;
}

/// The outline less a rim: no point of the whole is farther than kNoticed_m from the land where the rest
/// fits.
Outline without_rim(Outline outline) {
  const double rim_m = (kNoticed_m - kBoundedMotion_m) / std::numbers::sqrt2;
  const auto shrink = [rim_m](Box& part) {
    const double along_m = std::min(rim_m, part.width() / 2), across_m = std::min(rim_m, part.height() / 2);
    part = {part.min_x + along_m, part.min_y + across_m, part.max_x - along_m, part.max_y - across_m};
  };
  std::ranges::for_each(outline.on_machine, shrink);
  std::ranges::for_each(outline.on_implement, shrink);
  return outline;
}

}  // namespace

DrivingGround::DrivingGround(const AllowedLand& turning_land, const Field& field, const Machine& machine,
                             const Region& body)
    : turning_(turning_land),
      machine_(drivable(machine)),
      outline_(outline_of(machine)),
      curve_(turn_curves(drivable(machine)).forward),
      with_passables_(with_passables(turning_land, field)),
      crop_(oriented_all(body)),
      more_over_crop_(more_over_crop_of(machine)) {}

std::vector<Manoeuvre> DrivingGround::words(const Pose& from, const Pose& to) const {
  return curve_.at_once() ? dubins_words(from, to, machine_.radius_m) : dubins_words(from, to, curve_);
}

bool DrivingGround::has_room_along(const SteeredPath& path) const {
  return land().nearly_fits(path, outline_);
}

bool DrivingGround::can_follow(const SteeredPath& path) const {
  return steers_at_once() || std::ranges::all_of(path, [](const SteeredStretch& stretch) {
           return stretch.curvature_at_start == 0 && stretch.curvature_at_end == 0;
         });
}

double DrivingGround::lacking_along_m(const SteeredPath& path) const {
  if (has_room_along(path)) return 0;
  // Long passes in parts, of which each is looked at as closely as a short one; a drawbar knows of all of it.
  double missing_m = 0;
  if (outline_.tows())
    missing_m = land().missing_m(path, outline_);
  else
    for (const SteeredStretch& stretch : path)
      if (!has_room_along({stretch})) missing_m = std::max(missing_m, land().missing_m({stretch}, outline_));
  if (missing_m > kNoticed_m) return missing_m;
  // It is found to kMissingRoom_m, which is coarser than what is noticed.
  return land().fits(path, without_rim(outline_)) ? 0 : kNoticed_m;
}

double cost_seconds(const SteeredPath& path, const DrivingGround& ground, CropDriven how) {
  const Turning& turning = ground.machine().turning;
  const double more = (how == CropDriven::kAcross ? 1 : kAlongTrack) * ground.more_over_crop();
  return idle_seconds(path, turning) + more * ground.over_crop_m(path) / turning.turning_speed_mps;
}

}  // namespace tramline
