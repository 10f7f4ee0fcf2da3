#include "tramline/avoidance/curved_way.h"

#include <algorithm>
#include <set>

#include "tramline/avoidance/corners_in_way.h"
#include "tramline/avoidance/curved_detour_path.h"
#include "tramline/avoidance/detour_ends.h"
#include "tramline/geometry/path_between.h"

namespace tramline {
namespace {

/// Tips of hazards thinner than the width tolerance lie outside the gap, m.
constexpr double kTip = 0.01;

/// x along the track's tangent in the middle of what is in the way, y to the side of passing.
class TangentFrame {
 public:
  TangentFrame(const PathPlace& middle, Passing side)
      : origin_(middle.at), along_(middle.heading), sense_(side == Passing::kLeft ? 1 : -1) {}

  Point to_detour(Point p) const {
    const Point off = p - origin_;
    return {dot(off, along_), sense_ * cross(along_, off)};
  }
  Point to_field(Point p) const {
    const double left = sense_ * p.y;
    return {origin_.x + p.x * along_.x - left * along_.y, origin_.y + p.x * along_.y + left * along_.x};
  }
  Ring to_detour(const Ring& ring) const {
    Ring out;
    out.reserve(ring.size());
    for (const Point p : ring) out.push_back(to_detour(p));
    return out;
  }
  Path to_detour(const Path& path) const {
    Path out;
    out.reserve(path.size());
    for (const PathSegment& segment : path)
      out.push_back({to_detour(segment.from), to_detour(segment.to), sense_ * segment.curvature});
    return out;
  }
  Path to_field(const Path& path) const {
    Path out;
    out.reserve(path.size());
    for (const PathSegment& segment : path)
      out.push_back({to_field(segment.from), to_field(segment.to), sense_ * segment.curvature});
    return out;
  }

 private:
  Point origin_;
  Point along_;
  double sense_;
};

class Search {
 public:
  Search(const CurvedObstruction& obstruction, Passing side, const Surroundings& around)
      : o_(obstruction),
        around_(around),
        gap_(whole_gap(obstruction)),
        places_(obstruction.track.path),
        frame_(places_.at(0.5 * (gap_.from + gap_.to)), side),
        line_{PathPlaces(frame_.to_detour(obstruction.track.path)), gap_.from, gap_.to} {
    way_.detour.side = side;
  }

  WayRound run() {
    add_gap(gap_);
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds; ++round) {
      const Look step = look();
      if (step == Look::kDone) break;
      if (step == Look::kGaveUp) return std::move(way_);
      if (round + 1 == kMostRounds) {
        give_up("there is no room between the obstacles");
        return std::move(way_);
      }
    }
    way_.why_not = fault_of({way_.detour.path, o_.width_m}, around_);
    name_hazards();
    return std::move(way_);
  }

 private:
  static Interval whole_gap(const CurvedObstruction& o) {
    return {o.track.stretches[o.gap - 1].to, o.track.stretches[std::max(o.gap, o.last_gap)].from};
  }
  std::size_t last_gap() const { return std::max(o_.gap, o_.last_gap); }

  Look give_up(const char* why) {
    way_.why_not = why;
    return Look::kGaveUp;
  }

  bool add_gap(Interval gap) {
    bool grown = false;
    for (const std::size_t hazard : hazards_in(o_.track, o_.width_m, gap, around_))
      grown = extend(parts_, hazard, {gap.from - kTip, gap.to + kTip}) || grown;
    return grown;
  }

  void name_hazards() {
    std::set<std::size_t> all;
    for (const auto& part : parts_) all.insert(part.first);
    for (std::size_t gap = way_.first_gap; gap <= way_.last_gap; ++gap) {
      const Interval between{o_.track.stretches[gap - 1].to, o_.track.stretches[gap].from};
      const std::vector<std::size_t> there = hazards_in(o_.track, o_.width_m, between, around_);
      all.insert(there.begin(), there.end());
    }
    way_.hazards.assign(all.begin(), all.end());
  }

  /// What the swath takes between two positions: how far along in the frame, and how low.
  Box reach_between(Interval range) const {
    constexpr double kEvery_m = 1;
    const double half = 0.5 * o_.width_m;
    const int looks = 1 + static_cast<int>(range.length() / kEvery_m);
    Box out;
    for (int i = 0; i <= looks; ++i) {
      const PathPlace on = line_.places.at(range.from + range.length() * i / looks);
      const Point across = half * Point{-on.heading.y, on.heading.x};
      out.extend(on.at + across);
      out.extend(on.at - across);
    }
    return out;
  }

  std::vector<KeepOut> discs() const {
    const double half = 0.5 * o_.width_m;
    if (parts_.size() == 1) {
      const TurnedHazard& only = around_.hazards[parts_.begin()->first];
      if (only.round) return {{frame_.to_detour(only.round->centre), only.round->radius + half}};
    }
    std::vector<KeepOut> out;
    for (const auto& [hazard, range] : parts_) {
      const Box reach = reach_between(range);
      append_corners(frame_.to_detour(around_.hazards[hazard].outline), {reach.min_x, reach.max_x},
                     reach.min_y, half, out);
    }
    return out;
  }

  /// Makes a path round the parts known so far and sees where it gets.
  Look look() {
    const std::vector<KeepOut> keep_out = discs();
    if (keep_out.empty()) return give_up("the track's end is no obstacle's doing");
    const auto found = curved_detour_path(keep_out, std::max(o_.radius_m, 0.5 * o_.width_m), line_);
    if (!found) return give_up("no way on this side comes back to the track");
    TrackDetour& detour = way_.detour;
    detour.path = frame_.to_field(found->path);
    detour.from = found->from;
    detour.to = found->to;
    detour.length_m = length(detour.path);
    const auto add = [this](const Interval& gap) { return add_gap(gap); };
    if (const Look ends = look_at_ends(o_.track.stretches, o_.gap, last_gap(), add, way_);
        ends != Look::kDone)
      return ends;
    bool met = false;
    const bool grown = add_what_is_met(met);
    if (!met) return Look::kDone;
    return grown ? Look::kLookAgain : give_up("there is no room between the obstacles");
  }

  /// Adds what the swath along the path runs into. False where all of it has been taken into account before.
  bool add_what_is_met(bool& met) {
    const SwathLine line(way_.detour.path, o_.width_m);
    const Interval extent{way_.detour.from, way_.detour.to};
    bool grown = false;
    for (std::size_t i = 0; i < around_.hazards.size(); ++i) {
      if (is_known_as_a_whole(i) || !runs_into(line, around_.hazards[i])) continue;
      met = true;
      grown = extend(parts_, i, extent) || grown;
    }
    return grown;
  }

  bool is_known_as_a_whole(std::size_t hazard) const {
    const auto known = parts_.find(hazard);
    if (known == parts_.end()) return false;
    if (parts_.size() == 1 && around_.hazards[hazard].round) return true;
    const Box reach = reach_between(known->second);
    const Box box = bounds(frame_.to_detour(around_.hazards[hazard].outline));
    return reach.min_x <= box.min_x && reach.max_x >= box.max_x;
  }

  const CurvedObstruction& o_;
  const Surroundings& around_;
  Interval gap_;
  PathPlaces places_;
  TangentFrame frame_;
  TrackLine line_;
  Parts parts_;
  WayRound way_;
};

}  // namespace

std::vector<std::size_t> hazards_in(const Track& track, double width_m, Interval range,
                                    const Surroundings& around) {
  const Path part =
      path_between(track.path, std::max(0.0, range.from - kTip), std::min(track.length_m, range.to + kTip));
  const SwathLine line(part, width_m);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < around.hazards.size(); ++i)
    if (runs_into(line, around.hazards[i])) out.push_back(i);
  return out;
}

WayRound curved_way_round(const CurvedObstruction& obstruction, Passing side, const Surroundings& around) {
  return Search(obstruction, side, around).run();
}

}  // namespace tramline
