#include "tramline/route/connection/roadmap_ways.h"

#include <algorithm>
#include <cassert>
#include <limits>
#include <numbers>
#include <utility>

#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

/// Lines of the roadmap are reached from so far, in radii and widths.
constexpr double kReach_radii = 4, kReach_widths = 1;
/// From the roadmap to the end of a way the machine may turn round: words up to the reach and so many
/// circles.
constexpr double kLongest_circles = 1;
/// Between two lines words lead on: no more than this longer than the straight line, and a share of the
/// radius.
constexpr double kLeadsOn = 1.25, kLeadsOn_radii = 0.5;

}  // namespace

RoadmapWays::RoadmapWays(Roadmap roadmap, const DrivingGround& ground)
    : roadmap_(std::move(roadmap)),
      ground_(ground),
      reach_m_(kReach_radii * ground.machine().radius_m + kReach_widths * ground.machine().width_m),
      changes_(roadmap_.poses().size()),
      along_(roadmap_.poses().size()),
      unreachable_(roadmap_.poses().size()) {
  if (ground.steers_at_once() && !ground.outline().tows()) arc_room_.emplace(ground);
}

double RoadmapWays::longest_word_m() const {
  return reach_m_ + kLongest_circles * 2 * std::numbers::pi * ground_.machine().radius_m;
}

std::vector<RoadmapWays::Word>& RoadmapWays::changes(std::size_t pose) {
  if (changes_[pose]) return *changes_[pose];
  std::vector<Word> out;
  const RoadmapPose& from = roadmap_.poses()[pose];
  const double radius_m = ground_.machine().radius_m;
  roadmap_.each_near(from.pose.at, reach_m_, [&](std::size_t i) {
    const RoadmapPose& to = roadmap_.poses()[i];
    const Point way = to.pose.at - from.pose.at;
    if (to.line == from.line || dot(way, from.ahead) <= 0 || dot(way, to.ahead) <= 0) return;
    const double length_m = dubins_length(relative(from.pose, from.ahead, to.pose, to.ahead), radius_m);
    if (length_m <= kLeadsOn * tramline::length(way) + kLeadsOn_radii * radius_m)
      out.push_back({i, length_m});
  });
  changes_[pose] = std::move(out);
  return *changes_[pose];
}

std::vector<RoadmapWays::Word>& RoadmapWays::words_from(const Pose& pose) {
  const auto [known, is_new] = words_from_.try_emplace(key_of(pose));
  std::vector<Word>& words = known->second;
  if (!is_new) return words;
  const double longest_m = longest_word_m(), radius_m = ground_.machine().radius_m;
  const Point ahead = pose.heading.unit();
  roadmap_.each_near(pose.at, reach_m_, [&](std::size_t i) {
    const RoadmapPose& to = roadmap_.poses()[i];
    const double length_m = dubins_length(relative(pose, ahead, to.pose, to.ahead), radius_m);
    if (length_m <= longest_m) words.push_back({i, length_m});
  });
  return words;
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

const RoadmapWays::Way* RoadmapWays::word(const Pose& from, const Pose& to) {
  const PosePairKey key{key_of(from), key_of(to)};
  auto known = by_word_.find(key);
  if (known == by_word_.end()) known = by_word_.emplace(key, first_with_room(from, to, Words::kAll)).first;
  return known->second ? &*known->second : nullptr;
}

const RoadmapWays::Way* RoadmapWays::looked_for(const Pose& from, Word& word, Words words) {
  if (word.looked) return word.way;
  word.looked = true;
  if (auto way = first_with_room(from, roadmap_.poses()[word.to].pose, words))
    word.way = &ways_.emplace_back(std::move(*way));
  return word.way;
}

const RoadmapWays::Way* RoadmapWays::change(std::size_t from, Word& word) {
  return looked_for(roadmap_.poses()[from].pose, word, Words::kLeadOn);
}

const RoadmapWays::Way* RoadmapWays::word(const Pose& from, Word& word) {
  return looked_for(from, word, Words::kAll);
}

const RoadmapWays::Way* RoadmapWays::along(std::size_t pose) {
  Found& way = along_[pose];
  if (!way) way = way_along(roadmap_.poses()[pose]);
  return *way ? &**way : nullptr;
}

std::optional<RoadmapWays::Way> RoadmapWays::way_along(const RoadmapPose& from) const {
  if (!ground_.can_follow(from.to_next) || !ground_.has_room_along(from.to_next)) return std::nullopt;
  const CropDriven how = from.track ? CropDriven::kAlongTrack : CropDriven::kAcross;
  return Way{from.to_next, cost_seconds(from.to_next, ground_, how)};
}

bool RoadmapWays::is_entered(const Pose& end) {
  const auto [known, is_new] = entered_.try_emplace(key_of(end), false);
  if (!is_new) return known->second;
  // Short words are likelier to have room.
  std::vector<std::pair<double, std::size_t>> words;
  const Point ahead = end.heading.unit();
  roadmap_.each_near(end.at, longest_word_m(), [&](std::size_t i) {
    const RoadmapPose& from = roadmap_.poses()[i];
    const double length_m =
        dubins_length(relative(from.pose, from.ahead, end, ahead), ground_.machine().radius_m);
    if (length_m <= longest_word_m()) words.emplace_back(length_m, i);
  });
  std::ranges::sort(words);
  known->second = std::ranges::any_of(
      words, [&](const auto& one) { return word(roadmap_.poses()[one.second].pose, end) != nullptr; });
  return known->second;
}

}  // namespace tramline
