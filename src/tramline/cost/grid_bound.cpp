#include "tramline/cost/grid_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tramline/cost/boundary_windows.h"
#include "tramline/cost/moving_rows.h"

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
        half_angle_(box.half_angle),
        grid_(tally.grid(box.origin_m)),
        width_(grid_.width_m),
        range_(strips_over(grid_, subfield_.reach, kWidthTolerance)),
        pivot_(subfield_.frame.to_track(terms.pivot)),
        detour_reach_(terms.detour_reach),
        dearest_(std::max(objective_.overlap, objective_.uncovered)) {
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
  }

  double least_cost() {
    thread_local StripParts parts;
    parts.collect(subfield_.outline, grid_, range_, shift_);
    for (int i = 0; i < range_.size(); ++i) {
      enter(range_.first + i, parts.in(static_cast<std::size_t>(i)));
      add_strip();
      fixed_ += objective_.turn * least_pieces();
    }
    return fixed_ + std::max(apart_, together_.least(moving_.shift, moving_.turn));
  }

 private:
  double shift_at(double along_from_pivot) const {
    return tangent_ * std::abs(along_from_pivot) + fixed_shift_;
  }
  double shift_between(double low, double high) const {
    return shift_at(std::max(std::abs(low - pivot_.y), std::abs(high - pivot_.y)));
  }

  /// Makes the strip the one that the functions below speak of.
  void enter(int k, std::span<BoundaryPart> parts) {
    gather_windows(parts, width_, shift_, 2 * shear_, windows_);
    parts_ = parts;
    zones_.clear();
    blocked_.clear();
    const double left = grid_.line(k), right = left + width_;
    for (const Box& obstacle : subfield_.obstacles) {
      const double touch = shift_ + kWidthTolerance, reach = touch + width_ + detour_reach_;
      if (obstacle.min_x > right + reach || obstacle.max_x < left - reach) continue;
      // A detour leaves its track within an arc, and leads back to it within another.
      const double along = width_ + 3 * detour_reach_ + tangent_ * (reach + width_);
      zones_.push_back({obstacle.min_y - along, obstacle.max_y + along});
      if (obstacle.min_x <= right + touch && obstacle.max_x >= left - touch)
        blocked_.push_back({obstacle.min_y - kWidthTolerance, obstacle.max_y + kWidthTolerance});
    }
  }

  bool in_zone(double low, double high) const {
    return std::any_of(zones_.begin(), zones_.end(),
                       [&](const Interval& zone) { return zone.from < high && low < zone.to; });
  }
  bool in_zone(const BoundaryWindow& window) const { return in_zone(window.lowest, window.highest); }

  /// Run by run: windows with land between them, and none before or beyond.
  void add_strip() {
    for (std::size_t first = 0, last = 0; first < windows_.size(); first = last + 1) {
      for (last = first; windows_[last].inside_after && last + 1 < windows_.size();) ++last;
      if (windows_[last].highest - windows_[first].lowest + 2 * shear_ < shortest_ &&
          !in_zone(windows_[first].lowest, windows_[last].highest)) {
        add_undriven(first, last);
        continue;
      }
      for (std::size_t k = first; k <= last; ++k)
        if (!in_zone(windows_[k])) windows_[k].passes ? add_passage(k) : add_rows(windows_[k]);
    }
  }

  /// A run in which no piece is long enough.
  void add_undriven(std::size_t first, std::size_t last) {
    double inside_m2 = 0;
    for (std::size_t k = first; k <= last; ++k) {
      inside_m2 += inside_rows(windows_[k].parts, moving_) - shear_ * windows_[k].across_m;
      if (k < last) inside_m2 += width_ * (windows_[k + 1].lowest - windows_[k].highest);
    }
    fixed_ += objective_.uncovered * std::max(0.0, inside_m2);
  }

  void add_passage(std::size_t i) {
    const BoundaryWindow& window = windows_[i];
    const double flattest = std::atan(window.least_slope) - half_angle_;
    const double steepest = std::atan(window.most_slope) + half_angle_;
    double wedge = 0;
    if (flattest > 0 && steepest < 0.5 * std::numbers::pi) {
      const double per_wedge = is_driven(i) ? per_wedge_ : std::min(per_wedge_, objective_.uncovered);
      wedge = per_wedge * 0.5 * width_ * width_ * std::tan(flattest);
    }
    const double now = passage_cost(window, width_, objective_.overlap, objective_.uncovered);
    if (wedge > 0.95 * now) {
      fixed_ += wedge;
      return;
    }
    const double sheared = dearest_ * shear_ * window.across_m;
    const double shift = shift_between(window.lowest, window.highest);
    RowBounds rows = moving_rows(window.parts, moving_);
    apart_ += std::max({0.0, wedge, rows.apart - sheared,
                        now - dearest_ * shift * (window.highest - window.lowest) - sheared});
    rows.together.constant -= sheared;
    const bool much = wedge > 0.7 * now && rows.together.least(moving_.shift, moving_.turn) < wedge;
    together_ += much ? AffineBound{wedge, 0, 0} : rows.together;
  }

  void add_rows(const BoundaryWindow& window) {
    const double sheared = dearest_ * shear_ * window.across_m;
    RowBounds rows = moving_rows(window.parts, moving_);
    apart_ += std::max(0.0, rows.apart - sheared);
    rows.together.constant -= sheared;
    together_ += rows.together;
  }

  /// Is the land beside a passage driven in every grid?
  bool is_driven(std::size_t i) const {
    const std::size_t before = windows_[i].begins ? i : i - 1;
    if (before >= windows_.size() || before + 1 >= windows_.size() || !blocked_.empty()) return false;
    return windows_[before + 1].lowest - windows_[before].highest >= least_length_;
  }

  int least_pieces() {
    separators_.clear();
    double from = -std::numeric_limits<double>::infinity();
    bool inside = false;
    for (const BoundaryWindow& window : windows_) {
      if (!inside && !in_zone(from, window.lowest)) separators_.push_back({from, window.lowest});
      inside = window.inside_after;
      from = window.highest;
    }
    if (windows_.empty()) return 0;
    int most = pieces_along(-shift_, width_ + shift_);
    if (tally_.plain_criterion().by_centre_line) {
      if (2 * shift_ < width_)
        most = std::max(most, pieces_along(0.5 * width_ - shift_, 0.5 * width_ + shift_));
    } else if (const double least = least_width_ + shift_; least <= width_) {
      most = std::max({most, pieces_along(0, least), pieces_along(width_ - least, width_)});
    }
    return most;
  }

  /// Stretches as long as a piece in which the sub-strip from `left` to `right` lies inside, between which
  /// somewhere the whole strip lies outside.
  int pieces_along(double left, double right) {
    const double middle = 0.5 * (left + right);
    int count = 0;
    bool inside = false;
    double free_from = -std::numeric_limits<double>::infinity(), last_end = 0;
    const auto consider = [&](double to) {
      if (!inside || to - free_from < least_length_) return;
      if (blocked_.empty()) return count_piece(free_from, to, count, last_end);
      for (const Interval& free : without({{free_from, to}}, blocks()))
        if (free.length() >= least_length_) count_piece(free.from, free.to, count, last_end);
    };
    for (const BoundaryPart& part : parts_) {  // from low to high
      double low = part.from.y, high = part.to.y;
      if (std::max(part.from.x, part.to.x) < left || std::min(part.from.x, part.to.x) > right) continue;
      if (part.from.x != part.to.x) {
        const double slope = (high - low) / (part.to.x - part.from.x);
        low = part.from.y + slope * (std::clamp(part.from.x, left, right) - part.from.x);
        high = part.from.y + slope * (std::clamp(part.to.x, left, right) - part.from.x);
      }
      crossings_.push_back(
          {std::min(low, high), std::max(low, high), (part.from.x > middle) != (part.to.x > middle)});
    }
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.lowest < b.lowest; });
    for (const Crossing& crossing : crossings_) {
      if (crossing.lowest > free_from) consider(crossing.lowest);
      inside ^= crossing.passes_middle;
      free_from = std::max(free_from, crossing.highest);
    }
    crossings_.clear();
    return count;
  }

  void count_piece(double from, double to, int& count, double& last_end) const {
    if (count > 0 && !parted(last_end, from)) return;
    ++count;
    last_end = to;
  }

  bool parted(double from, double to) const {
    return std::any_of(separators_.begin(), separators_.end(), [&](const Interval& outside) {
      return std::min(outside.to, to) - std::max(outside.from, from) > 2 * shear_;
    });
  }

  Intervals blocks() const {
    Intervals sorted = blocked_, out;
    std::sort(sorted.begin(), sorted.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    for (const Interval& block : sorted) append_joining(out, block);
    return out;
  }

  struct Crossing {
    double lowest, highest;
    bool passes_middle;
  };

  const GridTally& tally_;
  const TurnedSubfield& subfield_;
  const Objective& objective_;
  double half_angle_;
  StripGrid grid_;
  double width_;
  StripRange range_;
  Point pivot_;
  double detour_reach_;
  double dearest_;
  double fixed_shift_ = 0, tangent_ = 0;
  double shift_ = 0;  ///< the most that the boundary moves across
  double shear_ = 0;
  double least_width_ = 0, per_wedge_ = 0, shortest_ = 0;  ///< piece that is driven
  double least_length_ = 0;                                ///< … for certain
  MovingTerms moving_;
  double fixed_ = 0;      ///< what is free of the place of the grid within the box
  double apart_ = 0;      ///< the other windows, each at its least
  AffineBound together_;  ///< the same windows, all moved at once
  std::span<BoundaryPart> parts_;
  std::vector<BoundaryWindow> windows_;
  Intervals zones_;    ///< along the strip, where detours may be
  Intervals blocked_;  ///< where an obstacle may reach into it
  Intervals separators_;
  std::vector<Crossing> crossings_;
};

}  // namespace

double least_cost(const GridTally& tally, const BoundTerms& terms, const GridBox& box) {
  return Bound(tally, terms, box).least_cost();
}

}  // namespace tramline
