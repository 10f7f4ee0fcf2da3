#include "tramline/avoidance/way_round.h"

#include <algorithm>
#include <set>

#include "tramline/avoidance/corners_in_way.h"
#include "tramline/avoidance/detour_ends.h"
#include "tramline/avoidance/detour_frame.h"
#include "tramline/avoidance/detour_path.h"

namespace tramline {
namespace {

std::vector<KeepOut> discs_round(const Parts& parts, const Surroundings& around, const DetourFrame& frame,
                                 double half_width) {
  std::vector<KeepOut> out;
  if (parts.size() == 1) {
    const TurnedHazard& only = around.hazards[parts.begin()->first];
    if (only.round) return {{frame.to_detour(only.round->centre), only.round->radius + half_width}};
  }
  for (const auto& [hazard, range] : parts)
    append_corners(frame.to_detour(around.hazards[hazard].outline), range, -half_width, half_width, out);
  return out;
}

/// Adds what the swath along the path runs into. False where all of it has been taken into account
/// before, so that another look would change nothing.
bool add_what_is_met(const SwathLine& line, Interval extent, const Surroundings& around, Parts& parts,
                     bool& met) {
  bool grown = false;
  for (std::size_t i = 0; i < around.hazards.size(); ++i) {
    const TurnedHazard& hazard = around.hazards[i];
    const auto known = parts.find(i);
    const bool whole = known != parts.end() &&
                       ((parts.size() == 1 && hazard.round) ||
                        (known->second.from <= hazard.box.min_y && known->second.to >= hazard.box.max_y));
    if (whole || !runs_into(line, hazard)) continue;
    met = true;
    grown = extend(parts, i, extent) || grown;
  }
  return grown;
}

class Search {
 public:
  Search(const Obstruction& obstruction, Passing side, const Surroundings& around)
      : o_(obstruction), around_(around), frame_{obstruction.grid.centre(obstruction.strip.index), side} {
    way_.detour.side = side;
  }

  WayRound run() {
    const Intervals& stretches = o_.strip.stretches;
    for (std::size_t gap = o_.gap; gap <= last_gap(); ++gap)
      add_gap({stretches[gap - 1].to, stretches[gap].from});
    constexpr int kMostRounds = 12;
    for (int round = 0; round < kMostRounds; ++round) {
      const Look step = look();
      if (step == Look::kDone) break;
      if (step == Look::kGaveUp) return std::move(way_);
      if (round + 1 == kMostRounds) return refuse("there is no room between the obstacles");
    }
    way_.why_not = fault_of({way_.detour.path, o_.width_m}, around_);
    name_hazards();
    return std::move(way_);
  }

 private:
  std::size_t last_gap() const { return std::max(o_.gap, o_.last_gap); }

  WayRound refuse(const char* why) {
    way_.why_not = why;
    return std::move(way_);
  }
  Look give_up(const char* why) {
    way_.why_not = why;
    return Look::kGaveUp;
  }

  /// Tips of hazards thinner than the width tolerance lie outside the gap.
  bool add_gap(Interval gap) {
    constexpr double kTip = 0.01;
    bool grown = false;
    for (const std::size_t hazard : hazards_in(o_.grid, o_.strip, gap, around_))
      grown = extend(parts_, hazard, {gap.from - kTip, gap.to + kTip}) || grown;
    return grown;
  }

  /// Those that shaped the path, and those in the gaps it bridges that it cleared without a further look.
  void name_hazards() {
    std::set<std::size_t> all;
    for (const auto& part : parts_) all.insert(part.first);
    const Intervals& stretches = o_.strip.stretches;
    for (std::size_t gap = way_.first_gap; gap <= way_.last_gap; ++gap) {
      const Interval between{stretches[gap - 1].to, stretches[gap].from};
      const std::vector<std::size_t> there = hazards_in(o_.grid, o_.strip, between, around_);
      all.insert(there.begin(), there.end());
    }
    way_.hazards.assign(all.begin(), all.end());
  }

  /// Makes a path round the parts known so far and sees where it gets.
  Look look() {
    const double half = 0.5 * o_.width_m, radius = std::max(o_.radius_m, half);
    const std::vector<KeepOut> discs = discs_round(parts_, around_, frame_, half);
    if (discs.empty()) return give_up("the track's end is no obstacle's doing");
    const std::optional<Path> path = detour_path(discs, radius);
    if (!path) return give_up("the obstacle has no side to pass on");
    TrackDetour& detour = way_.detour;
    detour.path = frame_.to_strip(*path);
    detour.from = detour.path.front().from.y;
    detour.to = detour.path.back().to.y;
    detour.length_m = length(detour.path);
    const auto add = [this](const Interval& gap) { return add_gap(gap); };
    if (const Look ends = look_at_ends(o_.strip.stretches, o_.gap, last_gap(), add, way_);
        ends != Look::kDone)
      return ends;
    bool met = false;
    const bool grown =
        add_what_is_met({detour.path, o_.width_m}, {detour.from, detour.to}, around_, parts_, met);
    if (!met) return Look::kDone;
    return grown ? Look::kLookAgain : give_up("there is no room between the obstacles");
  }

  const Obstruction& o_;
  const Surroundings& around_;
  DetourFrame frame_;
  Parts parts_;
  WayRound way_;
};

}  // namespace

std::size_t stretch_at(const Intervals& stretches, double along) {
  constexpr double kRounding = 1e-9;
  for (std::size_t i = 0; i < stretches.size(); ++i)
    if (along >= stretches[i].from - kRounding && along <= stretches[i].to + kRounding) return i;
  return stretches.size();
}

std::vector<std::size_t> hazards_in(const StripGrid& grid, const Track& strip, Interval range,
                                    const Surroundings& around) {
  const Box window{grid.line(strip.index), range.from, grid.line(strip.index + 1), range.to};
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < around.hazards.size(); ++i) {
    if (!intersects(around.hazards[i].box, window)) continue;
    std::vector<KeepOut> corners;
    append_corners(DetourFrame{window.max_x, Passing::kLeft}.to_detour(around.hazards[i].outline), range, 0,
                   0, corners);
    const bool reaches_in = std::any_of(corners.begin(), corners.end(), [&](const KeepOut& corner) {
      return corner.centre.y < grid.width_m;
    });
    if (reaches_in) out.push_back(i);
  }
  return out;
}

WayRound way_round(const Obstruction& obstruction, Passing side, const Surroundings& around) {
  return Search(obstruction, side, around).run();
}

}  // namespace tramline
