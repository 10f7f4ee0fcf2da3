#include "tramline/route/connection/squeezed_way.h"

#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "tramline/turns/outline/outline.h"

namespace tramline {
namespace {

/// Of the machine's width and of what reaches out before and behind.
constexpr std::array kNarrowed = {0.6, 0.3, 0.05};
/// Another way leaves the land by so much less, m.
constexpr double kLess_m = 0.5;

Machine narrower(Machine machine, double share) {
  machine.width_m *= share;
  machine.turning.vehicle_width_m *= share;
  machine.turning.front_overhang_m *= share;
  machine.turning.rear_overhang_m *= share;
  return machine;
}

/// The way of a narrower machine that backs only where this one has room: along its work.
std::optional<Way> with_backing(const Connector& narrowed, const SteeredPath& left,
                                const SteeredPath& entered, const DrivingGround& ground) {
  Way way = narrowed.between(left, entered);
  if (!way.has_room()) return std::nullopt;
  way = narrowed.with_less_backing(way, left, entered);
  for (const RouteLeg& leg : legs_of(way))
    if (leg.gear == Gear::kReverse && !ground.has_room_along(leg.path)) return std::nullopt;
  way.backs_on_land = true;
  return way;
}

}  // namespace

struct SqueezedWays::Narrowed {
  DrivingGround ground;
  RoadmapOnDemand roadmap;
  Connector connector;

  Narrowed(const Connector& wide, const Field& field, const Region& body, const RoadmapFor& roadmap_for,
           double share)
      : ground(wide.ground().turning(), field, narrower(wide.ground().machine(), share), body),
        roadmap([&] { return roadmap_for(ground); }, ground),
        connector(ground, roadmap, wide.terms()) {}
};

SqueezedWays::SqueezedWays(const Connector& connector, const Field& field, const Region& body,
                           RoadmapFor roadmap_for)
    : connector_(connector), field_(field), body_(body), roadmap_for_(std::move(roadmap_for)) {}

SqueezedWays::~SqueezedWays() = default;

const Connector& SqueezedWays::narrowed(std::size_t step) {
  while (narrowed_.size() <= step)
    narrowed_.push_back(
        std::make_unique<Narrowed>(connector_, field_, body_, roadmap_for_, kNarrowed[narrowed_.size()]));
  return narrowed_[step]->connector;
}

std::optional<Way> SqueezedWays::nearer_the_land(double missing_m, const SteeredPath& left,
                                                 const SteeredPath& entered, Backing backing) {
  const DrivingGround& ground = connector_.ground();
  for (std::size_t step = 0; step < kNarrowed.size(); ++step) {
    std::optional<Way> found = backing == Backing::kNone
                                   ? narrowed(step).without_backing(left, entered)
                                   : with_backing(narrowed(step), left, entered, ground);
    if (!found) continue;
    found->missing_m = ground.turning().missing_m(found->path, ground.outline());
    if (found->missing_m > 0 && found->missing_m <= missing_m - kLess_m) return found;
  }
  return std::nullopt;
}

Way SqueezedWays::along_the_land(Way way, const SteeredPath& left, const SteeredPath& entered) {
  assert(!way.has_room());
  const DrivingGround& ground = connector_.ground();
  if (ground.outline().tows()) return way;
  if (auto found = nearer_the_land(way.missing_m, left, entered, Backing::kNone)) return std::move(*found);
  // In a lane it sticks out by half its width at the most.
  if (way.missing_m <= half_breadth_m(ground.outline())) return way;
  auto found = nearer_the_land(way.missing_m, left, entered, Backing::kAsNeeded);
  return found ? std::move(*found) : way;
}

}  // namespace tramline
