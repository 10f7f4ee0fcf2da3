#include "tramline/turns/room/missing_room.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <queue>

#include "tramline/geometry/index/edge_index.h"
#include "tramline/turns/outline/tolerances.h"
#include "tramline/turns/outline/towed_motion.h"

namespace tramline {
namespace {

/// Places at which the distance is measured at the most: enough for kMissingRoom_m unless the outline runs
/// along far outside for long.
constexpr int kMostPlaces = 30000;

struct Reach {
  Point middle;
  double radius_m;
};

/// A disc that the outline does not leave on its way.
Reach reach_of(const SteeredPath& path, const Outline& outline) {
  Box places;
  for (const SteeredStretch& stretch : path) places.extend(stretch.start.at);
  const Point middle = places.centre();
  double axle_m = 0, machine_m = 0, implement_m = 0;
  for (const SteeredStretch& stretch : path)
    axle_m = std::max(axle_m, distance(middle, stretch.start.at) + stretch.length_m);
  for (const Box& part : outline.on_machine) machine_m = std::max(machine_m, farthest_corner_m(part));
  for (const Box& part : outline.on_implement) implement_m = std::max(implement_m, farthest_corner_m(part));
  if (outline.tows()) implement_m += std::abs(outline.hitch_m) + outline.drawbar_m;
  return {middle, axle_m + std::max(machine_m, implement_m)};
}

/// The edges of the land that decide how far points of a disc are from it.
class LandNearby {
 public:
  /// The edge nearest to a point of the disc is no farther from the middle than the edge nearest to that and
  /// twice the radius. A ray to the right meets edges at heights of the disc alone.
  LandNearby(const Region& land, const Reach& reach) {
    const auto& [middle, radius_m] = reach;
    const EdgeIndex all(land);
    const auto off_m = [&at = reach.middle](const EdgeIndex::Edge& edge) {
      return distance_to_segment(at, edge.from, edge.to);
    };
    double nearest_m = std::numeric_limits<double>::infinity();
    for (const EdgeIndex::Edge& edge : all.edges()) nearest_m = std::min(nearest_m, off_m(edge));
    for (const EdgeIndex::Edge& edge : all.edges()) {
      if (off_m(edge) <= nearest_m + 2 * radius_m) near_.push_back(edge);
      const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
      if (high >= middle.y - radius_m && low <= middle.y + radius_m &&
          std::max(edge.from.x, edge.to.x) >= middle.x - radius_m)
        right_.push_back(edge);
    }
  }

  /// Positive outside.
  double distance_from(Point p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const EdgeIndex::Edge& edge : near_)
      least = std::min(least, distance_to_segment(p, edge.from, edge.to));
    return contains(p) ? -least : least;
  }

 private:
  bool contains(Point p) const {
    bool inside = false;
    for (const EdgeIndex::Edge& edge : right_) {
      if ((edge.from.y > p.y) == (edge.to.y > p.y)) continue;
      const double share = (p.y - edge.from.y) / (edge.to.y - edge.from.y);
      if (edge.from.x + share * (edge.to.x - edge.from.x) > p.x) inside = !inside;
    }
    return inside;
  }

  std::vector<EdgeIndex::Edge> near_, right_;
};

/// Part of a side on a part of its way.
struct SideOnWay {
  const Box* part;
  bool of_implement;
  std::size_t stretch;
  double from_m, to_m;  ///< on the stretch
  Point from, to;       ///< on the side, in the part's frame
  double at_most;       ///< bound of the distance from the land
  double reach_of_way;  ///< bounds of how far a point of it is from the middle
  double reach_of_side;
  friend bool operator<(const SideOnWay& a, const SideOnWay& b) { return a.at_most < b.at_most; }
};

class MissingRoom {
 public:
  MissingRoom(const Region& land, const SteeredPath& path, const Outline& outline, double roughly)
      : land_(land, reach_of(path, outline)), path_(path), outline_(outline), roughly_(roughly) {
    if (outline.tows()) towed_.emplace(path, outline);
  }

  double greatest(double enough_m) {
    for (std::size_t i = 0; i < path_.size(); ++i) {
      measure_at_ends(i);
      for (const Box& part : outline_.on_machine) add_sides(part, false, i, 0, path_[i].length_m);
      if (!outline_.tows()) continue;
      const double pieces = towed_->pieces(i);
      for (const Box& part : outline_.on_implement)
        for (double k = 0; k < pieces; ++k)
          add_sides(part, true, i, k / pieces * path_[i].length_m, (k + 1) / pieces * path_[i].length_m);
    }
    while (!queue_.empty() && may_be_greater(queue_.top()) && best_ < enough_m && places_ < kMostPlaces) {
      const SideOnWay widest = queue_.top();
      queue_.pop();
      halve(widest);
    }
    return best_;
  }

 private:
  bool may_be_greater(const SideOnWay& side) const {
    return side.at_most > best_ + std::max(kMissingRoom_m, roughly_ * best_);
  }

  MotionPiece motion(const SideOnWay& side) const {
    return side.of_implement ? towed_->motion(side.stretch, side.from_m, side.to_m)
                             : machine_motion(path_[side.stretch], side.from_m, side.to_m);
  }

  /// Corners reach out farthest where stretches begin and end, on the whole. Known early, they spare many
  /// places along an edge that a long stretch follows.
  void measure_at_ends(std::size_t stretch) {
    for (const double at_m : {0.0, path_[stretch].length_m}) {
      const Placement machine = placed(pose_after(path_[stretch], at_m));
      for (const Box& part : outline_.on_machine) measure_corners(part, machine);
      if (!outline_.tows()) continue;
      const Placement implement = towed_->implement(stretch, at_m);
      for (const Box& part : outline_.on_implement) measure_corners(part, implement);
    }
  }

  void measure_corners(const Box& part, const Placement& frame) {
    for (const Point corner : corners_of(part))
      best_ = std::max(best_, land_.distance_from(to_ground(frame, corner)));
  }

  void add_sides(const Box& part, bool of_implement, std::size_t stretch, double from_m, double to_m) {
    const auto corners = corners_of(part);
    for (std::size_t i = 0; i < corners.size(); ++i)
      add({&part, of_implement, stretch, from_m, to_m, corners[i], corners[(i + 1) % corners.size()], 0, 0,
           0});
  }

  void add(SideOnWay side) {
    const double middle_m = 0.5 * (side.from_m + side.to_m);
    const Placement frame = side.of_implement ? towed_->implement(side.stretch, middle_m)
                                              : placed(pose_after(path_[side.stretch], middle_m));
    const double from_land = land_.distance_from(to_ground(frame, midpoint(side.from, side.to)));
    const MotionPiece piece = motion(side);
    side.reach_of_way =
        0.5 * (std::abs(piece.even.way_m) + std::abs(piece.even.turn_rad) * farthest_corner_m(*side.part)) +
        2 * piece.margin_m(*side.part);
    side.reach_of_side = 0.5 * distance(side.from, side.to);
    side.at_most = from_land + side.reach_of_way + side.reach_of_side;
    best_ = std::max(best_, from_land);
    ++places_;
    if (may_be_greater(side)) queue_.push(side);
  }

  void halve(const SideOnWay& whole) {
    SideOnWay first = whole, second = whole;
    if (whole.reach_of_way > whole.reach_of_side)
      first.to_m = second.from_m = 0.5 * (whole.from_m + whole.to_m);
    else
      first.to = second.from = midpoint(whole.from, whole.to);
    add(first);
    add(second);
  }

  LandNearby land_;
  const SteeredPath& path_;
  const Outline& outline_;
  double roughly_;
  std::optional<TowedMotion> towed_;
  std::priority_queue<SideOnWay> queue_;
  double best_ = 0;
  int places_ = 0;
};

}  // namespace

double missing_room_m(const Region& land, const SteeredPath& path, const Outline& outline, double enough_m,
                      double roughly) {
  return MissingRoom(land, path, outline, roughly).greatest(enough_m);
}

}  // namespace tramline
