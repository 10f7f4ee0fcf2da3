#include "tramline/avoidance/least_cost_with_detours.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "tramline/avoidance/tolerances.h"
#include "tramline/cost/strip_tally.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// Extent of a ring across between two positions along. Empty where it does not reach there.
Interval reach_across(const Ring& ring, const Interval& along) {
  Interval out{kNever, -kNever};
  for (std::size_t i = 0; i < ring.size(); ++i) {
    Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
    if (a.y > b.y) std::swap(a, b);
    if (a.y > along.to || b.y < along.from) continue;
    const double slope = a.y < b.y ? (b.x - a.x) / (b.y - a.y) : 0;
    const double low = a.y < along.from ? a.x + slope * (along.from - a.y) : a.x;
    const double high = b.y > along.to ? a.x + slope * (along.to - a.y) : b.x;
    out.from = std::min({out.from, low, high});
    out.to = std::max({out.to, low, high});
  }
  return out;
}

/// The land of one subfield that detours may work, in its turned plane.
class DetourZones {
 public:
  DetourZones(const AvoidanceTask& task, const TrackFrame& frame)
      : width_m_(task.machine.width_m),
        around_(turned_surroundings(task.ground, task.field.outer, EdgeKind::kSoft, frame)) {
    const double arc = std::max(task.machine.radius_m, 0.5 * width_m_);
    for (const TurnedHazard& hazard : around_.hazards) boxes_.push_back(hazard.box.grown(width_m_ + 3 * arc));
  }

  /// The stretches of a strip that no detour comes near.
  Intervals far_from(double left, double right, const Interval& whole) const {
    Intervals near;
    for (const Box& box : boxes_)
      if (box.min_x < right && box.max_x > left) near.push_back({box.min_y, box.max_y});
    std::sort(near.begin(), near.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
    Intervals joined;
    for (const Interval& one : near) append_joining(joined, one);
    return complement(joined, whole);
  }

  /// Least additional length of a detour past the gap over the part of the track it replaces, the gap
  /// included. It begins and ends within `near`, except for the foot of a slope of the steepest kind, and on
  /// either side it passes all of the gap's hazards between the gap's ends. Infinite where that is beyond the
  /// field.
  double longer_m(double left, const Interval& gap, const Interval& near) const {
    const double centre = left + 0.5 * width_m_;
    const Interval past = past_hazards(left, gap);
    const Interval field = reach_across(around_.field, near);
    double shortest = kNever;
    if (past.from > field.from) shortest = std::min(shortest, excess_m(centre - past.from, near));
    if (past.to < field.to) shortest = std::min(shortest, excess_m(past.to - centre, near));
    return shortest;
  }

 private:
  /// The positions across that the centre lines of detours on either side have to reach.
  Interval past_hazards(double left, const Interval& gap) const {
    const double centre = left + 0.5 * width_m_, half = 0.5 * width_m_ - kBoundSlack_m;
    Interval out{centre, centre};
    for (const TurnedHazard& hazard : around_.hazards) {
      if (hazard.box.min_y > gap.to || hazard.box.max_y < gap.from) continue;
      Interval reach = reach_across(hazard.outline, gap);
      if (!(reach.from < left + width_m_ - kBoundSlack_m && reach.to > left + kBoundSlack_m)) continue;
      if (hazard.round) {
        reach.from = std::max(reach.from, hazard.round->centre.x - hazard.round->radius);
        reach.to = std::min(reach.to, hazard.round->centre.x + hazard.round->radius);
      }
      out.from = std::min(out.from, reach.from - half);
      out.to = std::max(out.to, reach.to + half);
    }
    return out;
  }

  /// Additional length of two straight lines to a point beside the track and back.
  static double excess_m(double aside_m, const Interval& near) {
    constexpr double kFoot = 0.6;  // more than twice the cotangent of 75 degrees, the steepest slope
    const double along_m = near.length() + kFoot * aside_m;
    return std::hypot(along_m, 2 * aside_m) - along_m;
  }

  double width_m_ = 0;
  Surroundings around_;
  std::vector<Box> boxes_;
};

/// Turns and stops between two pieces of a strip, or at its end, that a detour may save.
struct Saving {
  double cost = 0;
  double longer_m = 0;  ///< least additional length of a detour that saves them; infinite: there is none
};

struct Sums {
  double over_m2 = 0, under_m2 = 0;   ///< where no detour can come
  double worked_m2 = 0, body_m2 = 0;  ///< elsewhere: worked with all tracks cut, and to be worked
  int pieces = 0;                     ///< pieces that no detour joins to others
  std::vector<Saving> savings;
};

bool lies_in(const LaidPiece& piece, const Interval& stretch) {
  return piece.from >= stretch.from - kNoPiece_m && piece.to <= stretch.to + kNoPiece_m;
}

/// Least additional length of detours past the gaps of a strip. One detour may bridge several gaps of the
/// same stretch of land, so each counts for a share of the least that any of them requires.
std::vector<double> longer_past_gaps(const Track& strip, double left, const Intervals& near,
                                     const DetourZones& zones) {
  std::vector<double> out(strip.stretches.size(), kNever);
  for (const Interval& ground : near) {
    std::vector<std::size_t> gaps;
    double least = kNever;
    for (std::size_t i = 1; i < strip.stretches.size(); ++i) {
      const Interval gap{strip.stretches[i - 1].to, strip.stretches[i].from};
      if (gap.from < ground.from || gap.to > ground.to) continue;
      gaps.push_back(i);
      least = std::min(least, zones.longer_m(left, gap, ground));
    }
    for (const std::size_t i : gaps)
      out[i] = strip.stretches[i].from - strip.stretches[i - 1].to + least / static_cast<double>(gaps.size());
  }
  return out;
}

/// Appends the possible savings between the stretches of one strip that are driven when all tracks are cut. A
/// detour that changes anything there bridges a whole gap, where detours can come.
void append_savings(const Track& strip, const std::vector<const LaidPiece*>& pieces,
                    const std::vector<double>& longer_m, const Objective& price, std::vector<Saving>& out) {
  const Intervals& stretches = strip.stretches;
  double least_m = kNever, stop_before = 0;
  bool begun = false;
  auto piece = pieces.begin();
  for (std::size_t i = 0; i < stretches.size(); ++i) {
    if (i > 0) least_m = std::min(least_m, longer_m[i]);
    if (piece == pieces.end() || !lies_in(**piece, stretches[i])) continue;
    const double stop = (*piece)->stop_at_from ? price.stop : 0;
    out.push_back({(begun ? price.turn : 0) + stop_before + stop, least_m});
    while (piece + 1 != pieces.end() && lies_in(**(piece + 1), stretches[i])) ++piece;
    stop_before = (*piece)->stop_at_to ? price.stop : 0;
    ++piece;
    least_m = kNever;
    begun = true;
  }
  out.push_back({stop_before, least_m});
}

/// Adds the least cost of one strip.
void add_strip(const Track& strip, const std::vector<const LaidPiece*>& pieces, double left,
               const Interval& whole, const DetourZones& zones, const AvoidanceTask& task, Sums& sums) {
  const double width_m = task.machine.width_m;
  const Intervals far = zones.far_from(left, left + width_m, whole), near = complement(far, whole);
  Intervals driven;
  for (const LaidPiece* piece : pieces) append_joining(driven, {piece->from, piece->to});
  for (const Interval& worked : common(driven, far))
    sums.over_m2 += width_m * worked.length() - strip.subfield.area_between(worked.from, worked.to);
  for (const Interval& left_over : without(far, driven))
    sums.under_m2 += strip.subfield.area_between(left_over.from, left_over.to);
  for (const Interval& worked : without(driven, far)) sums.worked_m2 += width_m * worked.length();
  for (const Interval& ground : near) sums.body_m2 += strip.subfield.area_between(ground.from, ground.to);
  sums.pieces += pieces.empty() ? 0 : 1;
  append_savings(strip, pieces, longer_past_gaps(strip, left, near, zones), task.objective, sums.savings);
}

/// Least cost of the land that detours may work. All that is driven with all tracks cut is also driven with
/// detours, or replaced by a detour that is as long and longer by its gaps; and no more is useful than there
/// is body. So each further square metre worked costs the price of overlap, in exchange for turns and stops.
/// The same holds for any lower price, which gives a better bound where much land is left unworked.
double least_near(const Sums& sums, double width_m, const Objective& price) {
  constexpr int kPrices = 4;
  double most = 0;
  for (int i = 0; i <= kPrices; ++i) {
    const double by_m2 = price.overlap * i / kPrices;
    double sum = by_m2 * (sums.worked_m2 - sums.body_m2);
    for (const Saving& saving : sums.savings)
      sum +=
          saving.longer_m == kNever ? saving.cost : std::min(saving.cost, by_m2 * width_m * saving.longer_m);
    most = std::max(most, sum);
  }
  return most;
}

}  // namespace

Avoided all_cut(const AvoidanceTask& task) {
  Avoided out;
  for (const TrackFamily& family : task.families)
    out.tracks.push_back(cut_pieces(family, min_length_m(task.machine)));
  out.tally = tally_of(task.subfields, out.tracks, task.body_m2);
  out.cost = cost(task.objective, out.tally);
  return out;
}

bool meets_obstacles(const AvoidanceTask& task) {
  return std::any_of(task.families.begin(), task.families.end(), [](const TrackFamily& family) {
    return std::any_of(family.tracks.begin(), family.tracks.end(),
                       [](const Track& strip) { return !hard_gaps(strip).empty(); });
  });
}

double least_cost_with_detours(const AvoidanceTask& task, const Avoided& cut) {
  const double width_m = task.machine.width_m;
  Sums sums;
  double subfields_m2 = 0, own_m2 = 0;
  std::size_t dropped = 0;
  for (std::size_t i = 0; i < task.subfields.size(); ++i) {
    const StripGrid& grid = task.families[i].grid;
    const DetourZones zones(task, grid.frame);
    const Box reach = bounds(grid.frame.to_track(Region{task.subfields[i].shape}));
    const Interval whole{reach.min_y - 2 * width_m, reach.max_y + 2 * width_m};
    subfields_m2 += area(task.subfields[i].shape);
    dropped += cut.tracks[i].dropped.size();
    auto piece = cut.tracks[i].pieces.begin();
    for (const Track& strip : task.families[i].tracks) {
      std::vector<const LaidPiece*> pieces;
      for (; piece != cut.tracks[i].pieces.end() && piece->track == strip.index; ++piece) {
        pieces.push_back(&*piece);
        own_m2 += piece->inside_m2;
      }
      add_strip(strip, pieces, grid.line(strip.index), whole, zones, task, sums);
    }
  }
  // Besides its own subfield a swath may work land of another; a piece too short to be driven may be driven
  // after all where a detour joins it to the next.
  const double across_borders_m2 = std::max(0.0, cut.tally.worked_m2 - cut.tally.overlap_m2 - own_m2) +
                                   static_cast<double>(dropped) * width_m * width_m;
  const Objective& price = task.objective;
  const double shared = task.subfields.size() > 1 ? (price.overlap + price.uncovered) * across_borders_m2 : 0;
  return price.uncovered * (task.body_m2 - subfields_m2) + price.overlap * sums.over_m2 +
         price.uncovered * sums.under_m2 + price.turn * std::max(0, sums.pieces - 1) +
         least_near(sums, width_m, price) - shared;
}

}  // namespace tramline
