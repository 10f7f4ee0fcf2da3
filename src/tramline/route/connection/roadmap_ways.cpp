#include "tramline/route/connection/roadmap_ways.h"

#include <functional>
#include <limits>
#include <utility>

#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

/// Lines of the roadmap are reached from so far, in radii and widths.
constexpr double kReach_radii = 4, kReach_widths = 1;
/// Between two lines words lead on: no more than this longer than the straight line, and a share of the
/// radius.
constexpr double kLeadsOn = 1.25, kLeadsOn_radii = 0.5;

/// What is known under a key, found first where it is not.
template <class Map, class Find>
const RoadmapWays::Way* known(Map& map, const typename Map::key_type& key, const Find& find) {
  auto at = map.find(key);
  if (at == map.end()) at = map.emplace(key, find()).first;
  return at->second ? &*at->second : nullptr;
}

}  // namespace

RoadmapWays::RoadmapWays(Roadmap roadmap, const DrivingGround& ground)
    : roadmap_(std::move(roadmap)),
      ground_(ground),
      reach_m_(kReach_radii * ground.machine().radius_m + kReach_widths * ground.machine().width_m),
      changes_(roadmap_.poses().size()) {
  if (ground.steers_at_once() && !ground.outline().tows()) arc_room_.emplace(ground);
}

const std::vector<RoadmapWays::Change>& RoadmapWays::changes(std::size_t pose) {
  std::optional<std::vector<Change>>& out = changes_[pose];
  if (out) return *out;
  out.emplace();
  const RoadmapPose& from = roadmap_.poses()[pose];
  const double radius_m = ground_.machine().radius_m;
  const Point ahead = from.pose.heading.unit();
  roadmap_.each_near(from.pose.at, reach_m_, [&](std::size_t i) {
    const RoadmapPose& to = roadmap_.poses()[i];
    const Point way = to.pose.at - from.pose.at;
    if (to.line == from.line || dot(way, ahead) <= 0 || dot(way, to.pose.heading.unit()) <= 0) return;
    const double length_m = dubins_length(from.pose, to.pose, radius_m);
    if (length_m <= kLeadsOn * tramline::length(way) + kLeadsOn_radii * radius_m)
      out->push_back({i, length_m});
  });
  return *out;
}

std::optional<RoadmapWays::Way> RoadmapWays::first_with_room(const Pose& from, const Pose& to, Words words) {
  const auto way_on = [this](SteeredPath path) {
    const double cost_s = cost_seconds(path, ground_);
    return Way{std::move(path), cost_s};
  };
  if (arc_room_) {
    // No other word than the shortest leads on.
    const std::size_t few = words == Words::kLeadOn ? 1 : std::numeric_limits<std::size_t>::max();
    const DubinsWords all(from, to, ground_.machine().radius_m);
    if (auto path = arc_room_->first_with_room(from, to, all, few)) return way_on(std::move(*path));
    return std::nullopt;
  }
  for (Manoeuvre& word : ground_.words(from, to)) {
    if (word.path.empty() || ground_.has_room(word.path)) return way_on(std::move(word.path));
    if (ground_.steers_at_once() && words == Words::kLeadOn) break;
  }
  return std::nullopt;
}

std::size_t RoadmapWays::PosePairHash::operator()(const PosePair& pair) const {
  std::size_t out = 0;
  for (const double number : pair) out = out * 1099511628211U + std::hash<double>{}(number);
  return out;
}

const RoadmapWays::Way* RoadmapWays::word(const Pose& from, const Pose& to) {
  const PosePair key{from.at.x, from.at.y, from.heading.angle().radians(),
                     to.at.x,   to.at.y,   to.heading.angle().radians()};
  return known(by_word_, key, [&] { return first_with_room(from, to, Words::kAll); });
}

const RoadmapWays::Way* RoadmapWays::change(std::size_t from, std::size_t to) {
  const std::uint64_t key = static_cast<std::uint64_t>(from) * roadmap_.poses().size() + to;
  return known(by_change_, key, [&] {
    return first_with_room(roadmap_.poses()[from].pose, roadmap_.poses()[to].pose, Words::kLeadOn);
  });
}

const RoadmapWays::Way* RoadmapWays::along(std::size_t pose) {
  return known(along_, pose, [&]() -> std::optional<Way> {
    const RoadmapPose& from = roadmap_.poses()[pose];
    if (!ground_.can_follow(from.to_next) || !ground_.has_room_along(from.to_next)) return std::nullopt;
    const CropDriven how = from.track ? CropDriven::kAlongTrack : CropDriven::kAcross;
    return Way{from.to_next, cost_seconds(from.to_next, ground_, how)};
  });
}

}  // namespace tramline
