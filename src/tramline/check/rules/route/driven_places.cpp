#include "tramline/check/rules/route/driven_places.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace tramline::check {
namespace {

constexpr int kHeadings = 72;
constexpr double kBetween = 2 * std::numbers::pi / kHeadings;
/// Room is looked at to less than this, and places that are not farther apart may be the same, m.
constexpr double kFoundTo_m = 0.05;
/// Half the width of the place it begins at, and what regions grow by at least, m.
constexpr double kPlace_m = 0.001, kGrows_m = 1e-6;
/// Corners nearer together tell no direction, m.
constexpr double kNoSide_m = 1e-6;
/// A machine that turns by so many sectors can turn round. So many rounds are enough.
constexpr int kTurnsRound = 60, kMostRounds = 200;

int wrapped(int heading) { return (heading % kHeadings + kHeadings) % kHeadings; }

/// Anticlockwise from the heading along x, in sectors: at least 0, less than all.
double heading_in_sectors(const Pose& pose) {
  const Point ahead = pose.heading.unit();
  const double sectors = std::atan2(ahead.y, ahead.x) / kBetween;
  return sectors < 0 ? sectors + kHeadings : sectors;
}

Point unit_at(double sectors) { return {std::cos(kBetween * sectors), std::sin(kBetween * sectors)}; }

/// What of a region lies no farther than `slack_m` outside the half plane to the left of a line.
Ring left_part(const Ring& region, Point on, Point along, double slack_m) {
  std::vector<double> left_m;
  left_m.reserve(region.size());
  for (const Point p : region) left_m.push_back(cross(along, p - on) + slack_m);
  if (std::ranges::min(left_m) >= 0) return region;
  Ring out;
  for (std::size_t i = 0, next = 1; i < region.size(); ++i, next = next + 1 < region.size() ? next + 1 : 0) {
    if (left_m[i] >= 0) out.push_back(region[i]);
    if (left_m[i] * left_m[next] < 0) {
      const double share = left_m[i] / (left_m[i] - left_m[next]);
      out.push_back((1 - share) * region[i] + share * region[next]);
    }
  }
  return out;
}

/// What of a convex region lies in another one or next to it.
Ring common_part(Ring region, const Ring& other) {
  for (std::size_t i = 0; i < other.size() && !region.empty(); ++i) {
    const Point side = other[(i + 1) % other.size()] - other[i];
    const double length_m = std::hypot(side.x, side.y);
    if (length_m > kNoSide_m) region = left_part(region, other[i], 1 / length_m * side, kFoundTo_m);
  }
  return region;
}

/// The corners of a convex region that points span, anticlockwise: above and below the line through the
/// leftmost and the rightmost one (Andrew 1979).
Ring spanned(std::vector<Point> points) {
  std::ranges::sort(points, [](Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  const auto chain = [](const std::vector<Point>& in_order) {
    Ring out;
    for (const Point p : in_order) {
      while (out.size() > 1 && cross(out.back() - out[out.size() - 2], p - out[out.size() - 2]) <= 0)
        out.pop_back();
      if (out.empty() || out.back() != p) out.push_back(p);
    }
    return out;
  };
  Ring out = chain(points);
  std::ranges::reverse(points);
  const Ring above = chain(points);
  if (above.size() > 2) out.insert(out.end(), above.begin() + 1, above.end() - 1);
  return out;
}

bool adds_nothing(const Ring& region, const Ring& more) {
  if (region.size() < 3) return false;
  for (std::size_t i = 0; i < region.size(); ++i) {
    const Point side = region[(i + 1) % region.size()] - region[i];
    const double least = -kGrows_m * std::hypot(side.x, side.y);
    for (const Point p : more)
      if (cross(side, p - region[i]) < least) return false;
  }
  return true;
}

/// Headings from one to the next, and how a machine gets on there.
struct Sector {
  Point first, last;  ///< unit vectors, in which it moves
  double on_m = 0;    ///< along either, to turn from one to the other
  double beyond_m = 0;

  /// Adds corners of the region that it gets to from another by `least_m` of either heading or more. Beyond
  /// the land only those matter that lie farthest to the right and to the left.
  void add(std::vector<Point>& corners, const Ring& region, double least_m) const {
    if (region.empty()) return;
    Point right = region.front(), left = region.front();
    for (const Point p : region) {
      corners.push_back(p + least_m * first);
      corners.push_back(p + least_m * last);
      if (cross(first, p - right) < 0) right = p;
      if (cross(last, p - left) > 0) left = p;
    }
    corners.push_back(right + beyond_m * first);
    corners.push_back(left + beyond_m * last);
  }
};

/// All headings of a machine that drives on from a place, and the regions where it passes them.
class Following {
 public:
  Following(const ConvexLand& land, const Pose& at, double sense)
      : land_(land), begins_(wrapped(static_cast<int>(std::floor(heading_in_sectors(at))))) {
    for (const Point corner : {Point{-1, -1}, Point{1, -1}, Point{1, 1}, Point{-1, 1}})
      place_.push_back(at.at + kPlace_m * corner);
    const double on_m = 2 * land.radius_m() * std::tan(0.5 * kBetween);
    for (int i = 0; i < kHeadings; ++i)
      sectors_.push_back({sense * unit_at(i), sense * unit_at(i + 1), on_m, land.beyond_m()});
  }

  /// A round to the left and one to the right; whether they added anything.
  bool grows() {
    bool out = false;
    for (int i = 0; i < kHeadings; ++i) {
      const int sector = wrapped(begins_ + i);
      if (pass(left(sector + 1), sector, sector + 1, left(sector), right(sector + 1))) out = true;
    }
    for (int i = 0; i < kHeadings; ++i) {
      const int sector = wrapped(begins_ - i);
      if (pass(right(sector), sector, sector, right(sector + 1), left(sector))) out = true;
    }
    return out;
  }

  /// So many sectors it turns to.
  int turned() {
    int out = 0;
    for (int sector = 0; sector < kHeadings; ++sector) out += turns_to(sector) ? 1 : 0;
    return out;
  }

  DrivenPlaces places() {
    DrivenPlaces out;
    out.in.resize(kHeadings);
    out.room.resize(kHeadings);
    for (int sector = 0; sector < kHeadings; ++sector) {
      if (!turns_to(sector)) continue;
      const auto i = static_cast<std::size_t>(sector);
      std::vector<Point> corners;
      sectors_[i].add(corners, left(sector), 0);
      sectors_[i].add(corners, right(sector + 1), 0);
      if (sector == begins_) sectors_[i].add(corners, place_, 0);
      out.in[i] = spanned(std::move(corners));
      // From halfway no corner is turned by more than half a sector.
      out.room[i] = land_.with_room(out.in[i], sector + 0.5, 0.5 * kBetween);
    }
    return out;
  }

 private:
  Ring& left(int heading) { return leftwards_[static_cast<std::size_t>(wrapped(heading))]; }
  Ring& right(int heading) { return rightwards_[static_cast<std::size_t>(wrapped(heading))]; }

  bool turns_to(int sector) {
    return sector == begins_ || !left(sector).empty() || !right(sector + 1).empty();
  }

  /// Passes the heading at one bound of a sector, from the other bound, back from this one, or from the
  /// place.
  bool pass(Ring& region, int sector, int bound, const Ring& across, const Ring& back) {
    if (across.empty() && back.empty() && sector != begins_) return false;
    const Sector& turns = sectors_[static_cast<std::size_t>(sector)];
    std::vector<Point> corners;
    turns.add(corners, across, turns.on_m);
    turns.add(corners, back, 0);
    if (sector == begins_) turns.add(corners, place_, 0);
    const Ring more = land_.with_room(spanned(std::move(corners)), bound, 0);
    if (more.empty() || adds_nothing(region, more)) return false;
    corners = region;
    corners.insert(corners.end(), more.begin(), more.end());
    Ring grown = spanned(std::move(corners));
    if (grown == region) return false;
    region = std::move(grown);
    return true;
  }

  const ConvexLand& land_;
  int begins_;
  Ring place_;
  std::vector<Sector> sectors_;
  /// Regions by the heading passed, turning to the left and to the right.
  std::vector<Ring> leftwards_ = std::vector<Ring>(kHeadings), rightwards_ = std::vector<Ring>(kHeadings);
};

}  // namespace

bool may_be_common(const DrivenPlaces& a, const DrivenPlaces& b) {
  if (a.everywhere || b.everywhere) return true;
  for (std::size_t sector = 0; sector < a.room.size(); ++sector) {
    if (a.room[sector].empty() || b.room[sector].empty()) continue;
    if (!common_part(a.room[sector], b.room[sector]).empty() &&
        !common_part(b.room[sector], a.room[sector]).empty())
      return true;
  }
  return false;
}

bool may_be_on(const std::vector<LineStep>& line, const DrivenPlaces& places) {
  if (places.everywhere) return true;
  constexpr double kAtBound = 1e-7;  // of a sector
  for (const LineStep& step : line) {
    const Ring chord{step.from.at, step.to.at};
    for (const double heading : {heading_in_sectors(step.from), heading_in_sectors(step.to)})
      for (const double aside : {-kAtBound, kAtBound}) {
        const Ring& there =
            places.in[static_cast<std::size_t>(wrapped(static_cast<int>(std::floor(heading + aside))))];
        if (!there.empty() && !common_part(chord, there).empty()) return true;
      }
  }
  return false;
}

ConvexLand::ConvexLand(std::vector<Edge> edges, std::vector<Point> corners, double radius_m)
    : edges_(std::move(edges)), corners_(std::move(corners)), radius_m_(radius_m) {
  assert(!edges_.empty() && !corners_.empty() && radius_m_ > 0);
  for (const Point corner : corners_) reach_m_ = std::max(reach_m_, std::hypot(corner.x, corner.y));
  for (const Edge& edge : edges_)
    beyond_m_ = std::max(beyond_m_, 2 * reach_m_ + 3 * distance(edge.on, edges_.front().on));
}

/// The corner that is nearest to an edge decides, of an outline that is turned by `heading` sectors.
Ring ConvexLand::with_room(Ring region, double heading, double turned) const {
  const double less_m = turned * reach_m_;
  const Point ahead = unit_at(heading), to_left{-ahead.y, ahead.x};
  for (const Edge& edge : edges_) {
    if (region.empty()) break;
    double nearest_m = reach_m_;
    for (const Point corner : corners_)
      nearest_m = std::min(nearest_m, dot(corner.x * ahead + corner.y * to_left, edge.inwards));
    const Point along{edge.inwards.y, -edge.inwards.x};
    region = left_part(region, edge.on - (nearest_m + less_m + kFoundTo_m) * edge.inwards, along, 0);
  }
  return region;
}

DrivenPlaces ConvexLand::driven_from(const Pose& at, double sense) const {
  Following following(*this, at, sense);
  int rounds = 0;
  while (following.grows())
    if (++rounds > kMostRounds || following.turned() > kTurnsRound) return {true, {}, {}};
  return following.places();
}

}  // namespace tramline::check
