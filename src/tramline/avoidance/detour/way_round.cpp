#include "tramline/avoidance/detour/way_round.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include "tramline/avoidance/detour/track_side.h"
#include "tramline/avoidance/tolerances.h"
#include "tramline/geometry/path/path_between.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// Parts of hazards that the detour has to go round, by hazard: positions along the track.
using Parts = std::map<std::size_t, Interval>;

/// Adds a part. False where it was known already.
bool extend(Parts& parts, std::size_t hazard, Interval range) {
  const auto [found, is_new] = parts.try_emplace(hazard, range);
  if (is_new) return true;
  const Interval before = found->second;
  found->second = {std::min(before.from, range.from), std::max(before.to, range.to)};
  return !(found->second == before);
}

/// Appends the corners of the part of a ring with from ≤ x ≤ to and y ≥ bottom, as discs of this radius, in
/// the detour's frame.
void append_corners(const Ring& ring, Interval range, double bottom, double radius,
                    std::vector<KeepOut>& out) {
  const auto clipped = [](const Ring& in, auto height) {
    Ring kept;
    for (std::size_t i = 0; i < in.size(); ++i) {
      const Point a = in[i], b = in[i + 1 == in.size() ? 0 : i + 1];
      const double ha = height(a), hb = height(b);
      if (ha >= 0) kept.push_back(a);
      if ((ha >= 0) != (hb >= 0)) kept.push_back(a + (ha / (ha - hb)) * (b - a));
    }
    return kept;
  };
  Ring part = clipped(ring, [&](Point p) { return p.x - range.from; });
  part = clipped(part, [&](Point p) { return range.to - p.x; });
  part = clipped(part, [&](Point p) { return p.y - bottom; });
  for (const Point corner : part) out.push_back({corner, radius});
}

/// Result of one attempt at a detour.
enum class Look { kDone, kLookAgain, kGaveUp };

/// Both ends have to lie on drivable stretches, before the gap `gap` and behind the gap `last_gap`: then the
/// way bridges what lies between. If not, `add_gap` is called with the gaps that the detour reaches; it
/// returns whether that adds anything that the detour has to go round. The reason for a failure is put into
/// `way`. O(n) for n stretches.
Look look_at_ends(const Intervals& stretches, std::size_t gap, std::size_t last_gap,
                  const std::function<bool(const Interval&)>& add_gap, WayRound& way) {
  const TrackDetour& detour = way.detour;
  const std::size_t first = stretch_at(stretches, detour.from), last = stretch_at(stretches, detour.to);
  if (first < gap && last >= last_gap && last < stretches.size()) {
    way.first_gap = first + 1;
    way.last_gap = last;
    return Look::kDone;
  }
  bool grown = false;
  for (std::size_t i = 1; i < stretches.size(); ++i) {
    const Interval between{stretches[i - 1].to, stretches[i].from};
    if (between.from <= detour.to && between.to >= detour.from) grown = add_gap(between) || grown;
  }
  if (grown) return Look::kLookAgain;
  way.why_not = Refusal::kEndsBefore;
  return Look::kGaveUp;
}

class Search {
 public:
  Search(const Obstruction& obstruction, Passing side, const Surroundings& around)
      : o_(obstruction),
        around_(around),
        track_(track_side(obstruction.grid, obstruction.track, gap(obstruction.gap, last_gap()), side)) {
    way_.detour.side = side;
  }

  WayRound run() {
    for (std::size_t i = o_.gap; i <= last_gap(); ++i) add_gap(gap(i, i));
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds; ++round) {
      const Look step = look();
      if (step == Look::kDone) break;
      if (step == Look::kGaveUp) return std::move(way_);
      if (round + 1 == kMostRounds) {
        give_up(Refusal::kNoRoomBetween);
        return std::move(way_);
      }
    }
    way_.why_not = fault_of({way_.detour.path, track_.width_m}, around_);
    name_hazards();
    return std::move(way_);
  }

 private:
  std::size_t last_gap() const { return std::max(o_.gap, o_.last_gap); }
  /// The part of the track that cannot be driven, from one gap to another.
  Interval gap(std::size_t first, std::size_t last) const {
    return {o_.track.stretches[first - 1].to, o_.track.stretches[last].from};
  }

  Look give_up(Refusal why) {
    way_.why_not = why;
    return Look::kGaveUp;
  }

  bool add_gap(Interval gap) {
    bool grown = false;
    for (const std::size_t hazard : hazards_in(o_.grid, o_.track, gap, around_))
      grown = extend(parts_, hazard, {gap.from - kTip_m, gap.to + kTip_m}) || grown;
    return grown;
  }

  /// Names the hazards that shaped the path, and those in the gaps it bridges that it clears anyway.
  void name_hazards() {
    std::set<std::size_t> all;
    for (const auto& part : parts_) all.insert(part.first);
    for (std::size_t i = way_.first_gap; i <= way_.last_gap; ++i) {
      const std::vector<std::size_t> there = hazards_in(o_.grid, o_.track, gap(i, i), around_);
      all.insert(there.begin(), there.end());
    }
    way_.hazards.assign(all.begin(), all.end());
  }

  std::vector<KeepOut> discs() const {
    const double half = 0.5 * track_.width_m;
    if (parts_.size() == 1) {
      const TurnedHazard& only = around_.hazards[parts_.begin()->first];
      if (only.round) return {{track_.frame.to_detour(only.round->centre), only.round->radius + half}};
    }
    std::vector<KeepOut> out;
    for (const auto& [hazard, range] : parts_) {
      const Box reach = reach_between(track_, range);
      append_corners(track_.frame.to_detour(around_.hazards[hazard].outline), {reach.min_x, reach.max_x},
                     reach.min_y, half, out);
    }
    return out;
  }

  /// Makes a path round the parts known so far and tests it.
  Look look() {
    const std::vector<KeepOut> keep_out = discs();
    if (keep_out.empty()) return give_up(Refusal::kNotBlocked);
    const double radius = std::max(o_.radius_m, 0.5 * track_.width_m);
    std::optional<TrackDetour> found = detour_beside(track_, keep_out, radius, HullCorners::kDrivable);
    if (!found) return give_up(track_.curve ? Refusal::kNoWayBack : Refusal::kNoSide);
    way_.detour = std::move(*found);
    const auto add = [this](const Interval& gap) { return add_gap(gap); };
    if (const Look ends = look_at_ends(o_.track.stretches, o_.gap, last_gap(), add, way_);
        ends != Look::kDone)
      return ends;
    bool any = false;
    const bool grown = add_hazards_reached(any);
    if (!any) return Look::kDone;
    return grown ? Look::kLookAgain : give_up(Refusal::kNoRoomBetween);
  }

  /// Adds the hazards that the swath along the path runs into; `any` tells whether there are any. False where
  /// all of them were known before, so that another attempt would change nothing.
  bool add_hazards_reached(bool& any) {
    const SwathLine line(way_.detour.path, track_.width_m);
    const Interval extent{way_.detour.from, way_.detour.to};
    bool grown = false;
    for (std::size_t i = 0; i < around_.hazards.size(); ++i) {
      if (is_known_as_a_whole(i) || !runs_into(line, around_.hazards[i])) continue;
      any = true;
      grown = extend(parts_, i, extent) || grown;
    }
    return grown;
  }

  bool is_known_as_a_whole(std::size_t hazard) const {
    const auto known = parts_.find(hazard);
    if (known == parts_.end()) return false;
    if (parts_.size() == 1 && around_.hazards[hazard].round) return true;
    const Box reach = reach_between(track_, known->second);
    const Box box = bounds(track_.frame.to_detour(around_.hazards[hazard].outline));
    return reach.min_x <= box.min_x && reach.max_x >= box.max_x;
  }

  const Obstruction& o_;
  const Surroundings& around_;
  TrackSide track_;
  Parts parts_;
  WayRound way_;
};

std::vector<std::size_t> hazards_in_strip(const StripGrid& grid, int strip, Interval range,
                                          const Surroundings& around) {
  const Box window{grid.line(strip), range.from, grid.line(strip + 1), range.to};
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < around.hazards.size(); ++i) {
    if (!intersects(around.hazards[i].box, window)) continue;
    std::vector<KeepOut> corners;
    append_corners(DetourFrame(window.max_x, Passing::kLeft).to_detour(around.hazards[i].outline), range, 0,
                   0, corners);
    const bool reaches_in = std::any_of(corners.begin(), corners.end(), [&](const KeepOut& corner) {
      return corner.centre.y < grid.width_m;
    });
    if (reaches_in) out.push_back(i);
  }
  return out;
}

std::vector<std::size_t> hazards_along(const Track& curved, double width_m, Interval range,
                                       const Surroundings& around) {
  const Path part = path_between(curved.path, std::max(0.0, range.from - kTip_m),
                                 std::min(curved.length_m, range.to + kTip_m));
  const SwathLine line(part, width_m);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < around.hazards.size(); ++i)
    if (runs_into(line, around.hazards[i])) out.push_back(i);
  return out;
}

}  // namespace

std::size_t stretch_at(const Intervals& stretches, double along) {
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (along >= stretches[i].from - kSameDistance_m && along <= stretches[i].to + kSameDistance_m) return i;
  return stretches.size();
}

std::vector<std::size_t> hazards_in(const StripGrid& grid, const Track& track, Interval range,
                                    const Surroundings& around) {
  return is_straight(track) ? hazards_in_strip(grid, track.index, range, around)
                            : hazards_along(track, grid.width_m, range, around);
}

WayRound way_round(const Obstruction& obstruction, Passing side, const Surroundings& around) {
  return Search(obstruction, side, around).run();
}

}  // namespace tramline
