#include "tramline/route/connection/squeezed_way.h"

#include <array>
#include <cassert>
#include <optional>
#include <utility>

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

Way SqueezedWays::along_the_land(Way way, const SteeredPath& left, const SteeredPath& entered) {
  assert(!way.has_room());
  const DrivingGround& ground = connector_.ground();
  if (ground.outline().tows()) return way;
  for (std::size_t i = 0; i < kNarrowed.size(); ++i) {
    if (i == narrowed_.size())
      narrowed_.push_back(std::make_unique<Narrowed>(connector_, field_, body_, roadmap_for_, kNarrowed[i]));
    std::optional<Way> found = narrowed_[i]->connector.without_backing(left, entered);
    if (!found) continue;
    found->missing_m = ground.turning().missing_m(found->path, ground.outline());
    if (found->missing_m > 0 && found->missing_m <= way.missing_m - kLess_m) return *found;
  }
  return way;
}

}  // namespace tramline
