#include "tramline/cost/bound/grid_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "tramline/cost/bound/boundary_windows.h"
#include "tramline/cost/bound/certain_pieces.h"
#include "tramline/cost/bound/joined_intervals.h"
#include "tramline/cost/bound/pooled_land.h"
#include "tramline/cost/bound/row_cost_bound.h"
#include "tramline/cost/bound/strip_passages.h"
#include "tramline/cost/bound/undriven_rows.h"
#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

/// The strips of the middle grid, and how far those of the others may differ. A grid that is turned about
/// the pivot by the angle a sees the boundary, strip by strip and but for a shift along, moved
/// - along, by a·(x − the strip's middle): the columns of a strip are sheared by at most shear_;
/// - then across, by tan a·y + x·(1/cos a − 1) and by the offset: at most shift_at(y).
class Bound {
 public:
  Bound(const GridTally& tally, const BoundTerms& terms, const GridBox& box)
      : tally_(tally),
        subfield_(tally.subfield()),
        objective_(terms.objective),
        grid_(tally.grid(box.origin_m)),
        width_(grid_.width_m),
        range_(strips_over(grid_, subfield_.reach, kWidthTolerance)),
        pivot_(subfield_.frame.to_track(terms.pivot)),
        detour_reach_(terms.detour_reach),
        highest_price_(std::max(objective_.overlap, objective_.uncovered)) {
    const Box& reach = subfield_.reach;
    const double x = std::max(reach.max_x - pivot_.x, pivot_.x - reach.min_x);
    const double y = std::max(reach.max_y - pivot_.y, pivot_.y - reach.min_y);
    const double second_order = box.half_angle * box.half_angle * std::hypot(x, y);
    fixed_shift_ = box.half_origin_m + 2 * second_order;
    tangent_ = std::tan(box.half_angle);
    shift_ = shift_at(y);
    shear_ = tangent_ * (0.5 * width_ + shift_) + second_order;
    const EndCriterion& rule = tally_.plain_criterion();
    least_width_ = rule.by_centre_line ? 0.5 * width_ : rule.least_width_m;
    const double run_on = 1 - least_width_ / width_;
    per_wedge_ = objective_.overlap * run_on * run_on + objective_.uncovered * (1 - run_on) * (1 - run_on);
    moving_ = {width_, objective_.overlap, objective_.uncovered, pivot_.y, tangent_, fixed_shift_};
    shortest_ = std::max(tally_.terms().min_length_m, kNoPiece_m);
    least_length_ = shortest_ + 2 * shear_;
    certain_ = CertainPieces({width_, shift_, shear_, rule, least_width_, shortest_});
    for_proof_ = terms.near == NearObstacles::kCharged && !subfield_.obstacles.empty();
    if (for_proof_)
      near_ = detour_zones(subfield_, {width_, detour_reach_, box.half_angle, shift_, terms.detours});
    // With several parts what one of them gains from the detours of another is not known by itself.
    charges_near_ = for_proof_ && terms.detours == DetoursOf::kThisGrid &&
                    subfield_.ground.passable.empty() && subfield_.ground.beyond.empty() &&
                    subfield_.ground.field.empty();
    if (charges_near_)
      passages_.emplace(subfield_, near_,
                        PassageTerms{objective_, width_, shift_, shear_, tangent_, moving_, detour_reach_,
                                     terms.at_obstacle, terms.drivable});
  }

  double least_cost(double enough) {
    thread_local StripParts parts;
    parts.collect(subfield_.outline, grid_, range_, shift_);
    for (int i = 0; i < range_.size(); ++i) {
      enter(range_.first + i, parts.in(static_cast<std::size_t>(i)));
      add_strip();
      if (charges_near_ && !zones_.empty() && !windows_.empty()) add_near(range_.first + i);
      // No strip lowers these sums; that of the windows moved together may fall.
      if (sums_.fixed + sums_.apart >= enough) return sums_.fixed + sums_.apart;
    }
    AffineBound together = sums_.together;
    const double least = std::max(sums_.apart, together.least(moving_.shift, moving_.turn));
    if (!charges_near_) return sums_.fixed + least;
    together += near_sums_.together;
    const double past = passages_->cost_together();
    const double pooled =
        past + std::max(sums_.apart + near_sums_.apart, together.least(moving_.shift, moving_.turn));
    return sums_.fixed + std::max(least, pooled);
  }

 private:
  struct Sums {
    double fixed = 0;      ///< what does not depend on the grid's position within the box
    double apart = 0;      ///< the other windows, each at its least
    AffineBound together;  ///< the same windows, all moved at once
  };

  double shift_at(double along_from_pivot) const {
    return tangent_ * std::abs(along_from_pivot) + fixed_shift_;
  }
  double shift_between(double low, double high) const {
    return shift_at(std::max(std::abs(low - pivot_.y), std::abs(high - pivot_.y)));
  }

  /// Makes this strip the current one, which the functions below refer to.
  void enter(int k, std::span<BoundaryPart> parts) {
    gather_windows(parts, width_, shift_, 2 * shear_, windows_);
    zones_.clear();
    blocked_.clear();
    const double left = grid_.line(k), right = left + width_;
    if (for_proof_) {
      for (const DetourZone& zone : near_)
        if (zone.land.min_x - shift_ <= right && zone.land.max_x + shift_ >= left)
          zones_.push_back({zone.land.min_y - 2 * shear_, zone.land.max_y + 2 * shear_});
      const double touch = shift_ + kWidthTolerance;
      for (const Box& obstacle : subfield_.obstacles)
        if (obstacle.min_x <= right + touch && obstacle.max_x >= left - touch)
          blocked_.push_back({obstacle.min_y - kWidthTolerance, obstacle.max_y + kWidthTolerance});
      return;
    }
    for (const Box& obstacle : subfield_.obstacles) {
      const double touch = shift_ + kWidthTolerance, reach = touch + width_ + detour_reach_;
      if (obstacle.min_x > right + reach || obstacle.max_x < left - reach) continue;
      // A detour leaves its track along one arc and returns along another.
      const double along = width_ + 3 * detour_reach_ + tangent_ * (reach + width_);
      zones_.push_back({obstacle.min_y - along, obstacle.max_y + along});
      if (obstacle.min_x <= right + touch && obstacle.max_x >= left - touch)
        blocked_.push_back({obstacle.min_y - kWidthTolerance, obstacle.max_y + kWidthTolerance});
    }
  }

  bool in_zone(double low, double high) const { return reaches_between(zones_, low, high); }
  bool in_zone(const BoundaryWindow& window) const { return in_zone(window.lowest, window.highest); }

  /// Windows first … last of the strip.
  struct Windows {
    std::size_t first = 0, last = 0;
  };

  /// Windows with land between them, and none before or beyond.
  Windows run_from(std::size_t first) const {
    std::size_t last = first;
    while (windows_[last].inside_after && last + 1 < windows_.size()) ++last;
    return {first, last};
  }

  /// Runs without a common piece in any grid: the land before and beyond them is outside.
  Windows group_from(std::size_t first) const {
    Windows group = run_from(first);
    while (group.last + 1 < windows_.size()) {
      const double from = windows_[group.last].highest, to = windows_[group.last + 1].lowest;
      if (to - from > 2 * shear_ && !in_zone(from, to)) break;
      group.last = run_from(group.last + 1).last;
    }
    return group;
  }

  void add_strip() {
    for (std::size_t next = 0; next < windows_.size();) {
      const Windows group = group_from(next);
      const Sums before = sums_;
      for (std::size_t k = group.first; k <= group.last; k = run_from(k).last + 1) add_run(run_from(k));
      if (has_piece(group))
        sums_.fixed += objective_.turn;
      else if (zones_.empty())
        sums_.fixed += undecided(group, before);
      next = group.last + 1;
    }
  }

  void add_run(const Windows& run) {
    const double lowest = windows_[run.first].lowest, highest = windows_[run.last].highest;
    if (highest - lowest + 2 * shear_ < shortest_ && !in_zone(lowest, highest)) {
      sums_.fixed += undriven(run);
      return;
    }
    find_undriven(run);
    const auto is_passage = [this](const BoundaryWindow& window) {
      return window.passes && !is_left(window.lowest, window.highest);
    };
    for (std::size_t k = run.first; k <= run.last; ++k) {
      if (in_zone(windows_[k])) continue;
      is_passage(windows_[k]) ? add_passage(k) : add_rows(windows_[k]);
      // A passage may move along without costing less: the land between is certain only beside other windows.
      if (k == run.last || is_passage(windows_[k]) || is_passage(windows_[k + 1])) continue;
      if (is_left(windows_[k].highest, windows_[k + 1].lowest))
        sums_.fixed += objective_.uncovered * width_ * (windows_[k + 1].lowest - windows_[k].highest);
    }
  }

  /// Sets undriven_ for the run; leaves it empty where a quick test shows that all of the run is driven.
  void find_undriven(const Windows& run) {
    undriven_.clear();
    const std::span of_run(windows_.begin() + static_cast<std::ptrdiff_t>(run.first),
                           run.last - run.first + 1);
    if (tally_.plain_criterion().by_centre_line || in_zone(of_run.front().lowest, of_run.back().highest))
      return;
    const bool two_ends = of_run.size() == 2 && of_run[0].passes && of_run[1].passes;
    if (two_ends && of_run[1].lowest - of_run[0].highest >= shortest_) return;
    find_undriven_rows(of_run, moving_, {least_width_, shortest_, shear_}, undriven_);
  }

  /// Whether no grid drives anything between these coordinates along.
  bool is_left(double from, double to) const {
    return std::any_of(undriven_.begin(), undriven_.end(),
                       [&](const Interval& stretch) { return stretch.from <= from && to <= stretch.to; });
  }

  /// Cost of the run where no piece is driven in it.
  double undriven(const Windows& run) const {
    double inside_m2 = 0;
    for (std::size_t k = run.first; k <= run.last; ++k) {
      inside_m2 += inside_rows(windows_[k].parts, moving_) - shear_ * windows_[k].across_m;
      if (k < run.last) inside_m2 += width_ * (windows_[k + 1].lowest - windows_[k].highest);
    }
    return objective_.uncovered * std::max(0.0, inside_m2);
  }

  /// A group that may or may not hold a piece: either it costs a turn besides the charge for its rows, or all
  /// its land is left unworked.
  double undecided(const Windows& group, const Sums& before) const {
    double left = 0;
    for (std::size_t k = group.first; k <= group.last; k = run_from(k).last + 1)
      left += undriven(run_from(k));
    AffineBound together = sums_.together;
    together -= before.together;
    const double charged = sums_.fixed - before.fixed +
                           std::max(sums_.apart - before.apart, together.most(moving_.shift, moving_.turn));
    return std::clamp(left - charged, 0.0, objective_.turn);
  }

  /// Charges the strip's land that detours may work. Whoever works it, each square metre of a swath that is
  /// not the only one on its land costs λo there: the cost is at least λo·(worked − land), and all of the
  /// strip's rows that are driven for certain are worked, by its own swath or by a detour that takes as many
  /// rows. A strip that an obstacle blocks is cut, or the rows in between are worked by a detour too.
  void add_near(int k) {
    const Intervals pooled = pooled_rows(windows_, zones_, shear_);
    Intervals driven = without(certain_.rows_of(windows_), passages_->enter(grid_, k));
    std::erase_if(driven, [this](const Interval& one) { return one.length() < shortest_ + kNoPiece_m; });
    sums_.fixed += objective_.stop * passages_->stops_at_ends(driven, windows_);
    double driven_m = 0;
    for (const Interval& stretch : common(driven, pooled)) driven_m += stretch.length();
    const double cost =
        objective_.overlap * width_ * driven_m + passages_->cost(driven, joined(zones_), pooled, windows_);
    near_sums_.apart += cost;
    near_sums_.together.constant += cost;
    subtract_land(windows_, zones_, pooled, moving_, near_sums_);
  }

  void add_passage(std::size_t i) {
    const BoundaryWindow& window = windows_[i];
    // tan(atan s − h), where the passage rises at least as steeply as s; it remains a passage while s is not
    // turned upright.
    const double flattest = window.least_slope - tangent_;
    double wedge = 0;
    if (flattest > 0 && window.most_slope * tangent_ < 1) {
      const double per_wedge = is_driven(i) ? per_wedge_ : std::min(per_wedge_, objective_.uncovered);
      wedge = per_wedge * 0.5 * width_ * width_ * flattest / (1 + window.least_slope * tangent_);
    }
    const double now = passage_cost(window, width_, objective_.overlap, objective_.uncovered);
    if (wedge > 0.95 * now) {
      sums_.fixed += wedge;
      return;
    }
    const double sheared = highest_price_ * shear_ * window.across_m;
    const double shift = shift_between(window.lowest, window.highest);
    RowBounds rows = row_cost_bound(window.parts, moving_);
    sums_.apart += std::max({0.0, wedge, rows.apart - sheared,
                             now - highest_price_ * shift * (window.highest - window.lowest) - sheared});
    rows.together.constant -= sheared;
    const bool much = wedge > 0.7 * now && rows.together.least(moving_.shift, moving_.turn) < wedge;
    sums_.together += much ? AffineBound{wedge, 0, 0} : rows.together;
  }

  void add_rows(const BoundaryWindow& window) {
    const double sheared = highest_price_ * shear_ * window.across_m;
    RowBounds rows = row_cost_bound(window.parts, moving_, undriven_);
    sums_.apart += std::max(0.0, rows.apart - sheared);
    rows.together.constant -= sheared;
    sums_.together += rows.together;
  }

  /// Whether the land beside a passage is driven in every grid.
  bool is_driven(std::size_t i) const {
    const std::size_t before = windows_[i].begins ? i : i - 1;
    if (before >= windows_.size() || before + 1 >= windows_.size() || !blocked_.empty()) return false;
    return windows_[before + 1].lowest - windows_[before].highest >= least_length_;
  }

  /// Whether a piece is driven in the group in every grid.
  bool has_piece(const Windows& group) {
    return certain_.any_in({windows_.begin() + static_cast<std::ptrdiff_t>(group.first),
                            windows_.begin() + static_cast<std::ptrdiff_t>(group.last) + 1},
                           blocked_.empty() ? Intervals{} : joined(blocked_));
  }

  const GridTally& tally_;
  const TurnedSubfield& subfield_;
  const Objective& objective_;
  StripGrid grid_;
  double width_;
  StripRange range_;
  Point pivot_;
  double detour_reach_;
  double highest_price_;
  double fixed_shift_ = 0, tangent_ = 0;
  double shift_ = 0;  ///< largest move of the boundary across
  double shear_ = 0;
  double least_width_ = 0, per_wedge_ = 0, shortest_ = 0;  ///< piece that is driven
  double least_length_ = 0;                                ///< … for certain
  RowBoundTerms moving_;
  Sums sums_;
  std::vector<BoundaryWindow> windows_;
  Intervals undriven_;  ///< of the current run
  Intervals zones_;     ///< along the strip, where detours may be
  Intervals blocked_;   ///< where an obstacle may reach into it
  CertainPieces certain_;
  bool for_proof_ = false;
  bool charges_near_ = false;  ///< whether land that detours may work is charged too
  std::vector<DetourZone> near_;
  std::optional<StripPassages> passages_{};  ///< where it is
  RowBounds near_sums_;                      ///< cost of the land that detours may work
};

/// Whether one of the prices of land is less than half the actual one.
bool is_far_from(const Objective& nearer, const Objective& actual) {
  return 2 * nearer.overlap < actual.overlap || 2 * nearer.uncovered < actual.uncovered;
}

}  // namespace

double least_cost(const GridTally& tally, const BoundTerms& terms, const GridBox& box, double enough) {
  const Objective& actual = terms.objective;
  double least = 0;
  for (const double times : {2.0, 10.0, 100.0}) {
    BoundTerms nearer = terms;
    nearer.objective.overlap = std::min(actual.overlap, times * actual.uncovered);
    nearer.objective.uncovered = std::min(actual.uncovered, times * actual.overlap);
    if (!is_far_from(nearer.objective, actual)) break;
    least = std::max(least, Bound(tally, nearer, box).least_cost(enough));
    if (least >= enough) return least;
  }
  return std::max(least, Bound(tally, terms, box).least_cost(enough));
}

}  // namespace tramline
