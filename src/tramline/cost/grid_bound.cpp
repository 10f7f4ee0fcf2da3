#include "tramline/cost/grid_bound.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline {
namespace {

/// λo·over + λu·under where every cross-section is worked or left, whichever costs less.
EndCriterion dearest_spared(const Objective& objective, double width_m) {
  return end_criterion(EndRule::kCheapest, objective, width_m);
}

/// A passage with its neighbours as far as the boundary may move.
struct Stretched {
  bool complete = true;  ///< the boundary passes plainly through all those strips
  double lowest = 0, highest = 0;
  double least_slope = 0, most_slope = 0;
};

/// The strips of one grid in the middle of the box, and how far they may differ in the others.
class Bound {
 public:
  Bound(const GridTally& tally, const BoundTerms& terms, const GridBox& box)
      : tally_(tally),
        subfield_(tally.subfield()),
        objective_(terms.objective),
        box_(box),
        grid_(tally.grid(box.origin_m)),
        width_(grid_.width_m),
        range_(strips_over(grid_, subfield_.reach, kWidthTolerance)),
        pivot_(subfield_.frame.to_track(terms.pivot)),
        dearest_(std::max(objective_.overlap, objective_.uncovered)) {
    const Box& reach = subfield_.reach;
    const double x = std::max(reach.max_x - pivot_.x, pivot_.x - reach.min_x);
    const double y = std::max(reach.max_y - pivot_.y, pivot_.y - reach.min_y);
    const double second_order = box.half_angle * box.half_angle * std::hypot(x, y);
    fixed_shift_ = box.half_origin_m + 2 * second_order;
    tangent_ = std::tan(box.half_angle);
    shift_ = shift_at(y);
    shear_ = tangent_ * (0.5 * width_ + shift_) + second_order;
    choose_shares();
    mark_zones(terms.detour_reach);
  }

  double least_cost() {
    ends_.collect(subfield_.outline, grid_, range_, dearest_spared(objective_, width_), true);
    gather_strips();
    StripMask intricate(strips_.size(), false);
    for (std::size_t i = 0; i < strips_.size(); ++i) intricate[i] = !strips_[i].plain || in_zone_[i];
    profiles_ = cross_sections({subfield_.shape}, grid_, range_, intricate);
    double sum = 0;
    for (std::size_t i = 0; i < strips_.size(); ++i) sum += least_of(i);
    return sum;
  }

 private:
  struct StripEnds {
    bool plain = false;
    std::size_t first = 0;  ///< into passages_
    std::size_t count = 0;
  };

  void choose_shares() {
    const EndCriterion& rule = tally_.plain_criterion();
    least_width_ = rule.by_centre_line ? 0.5 * width_ : rule.least_width_m;
    const double run_on = 1 - least_width_ / width_;
    per_wedge_ = objective_.overlap * run_on * run_on + objective_.uncovered * (1 - run_on) * (1 - run_on);
    least_length_ = std::max(tally_.terms().min_length_m, kNoPiece_m);
  }

  void mark_zones(double detour_reach) {
    in_zone_.assign(static_cast<std::size_t>(range_.size()), false);
    for (const Box& obstacle : subfield_.obstacles) {
      const double round = std::min(detour_reach, std::hypot(obstacle.width(), obstacle.height()));
      const double margin = shift_ + width_ + round + kWidthTolerance;
      const int first = std::max(grid_.strip_at(obstacle.min_x - margin), range_.first);
      const int last = std::min(grid_.strip_at(obstacle.max_x + margin), range_.last);
      for (int k = first; k <= last; ++k) in_zone_[static_cast<std::size_t>(k - range_.first)] = true;
    }
  }

  void gather_strips() {
    for (std::size_t i = 0; i < in_zone_.size(); ++i) {
      const PlainEnds::InStrip found = ends_.in_strip(i);
      strips_.push_back({found.plain, passages_.size(), static_cast<std::size_t>(found.end - found.begin)});
      passages_.insert(passages_.end(), found.begin, found.end);
    }
  }

  /// How far the boundary at a coordinate along may lie from its place across, against the grid.
  double shift_at(double along_from_pivot) const {
    return tangent_ * std::abs(along_from_pivot) + fixed_shift_;
  }
  double shift_between(double low, double high) const {
    return shift_at(std::max(std::abs(low - pivot_.y), std::abs(high - pivot_.y)));
  }

  Stretched stretched(const PlainEnd& end) const {
    Stretched out{true, end.lowest, end.highest, end.least_slope, end.most_slope};
    const int reach = static_cast<int>(std::ceil(shift_ / width_));
    if (reach > 3) return {false};
    for (const bool onward : {false, true}) {
      int at = onward ? end.next : end.previous;
      for (int j = 0; j < reach; ++j) {
        if (at < 0) return {false};
        const PlainEnd& beside = ends_.at(at);
        out.lowest = std::min(out.lowest, beside.lowest);
        out.highest = std::max(out.highest, beside.highest);
        out.least_slope = std::min(out.least_slope, beside.least_slope);
        out.most_slope = std::max(out.most_slope, beside.most_slope);
        at = onward ? beside.next : beside.previous;
      }
    }
    return out;
  }

  /// Nothing but its own passages, each continued plainly to both sides and far from the next, comes near
  /// the strip: each end can be looked at alone.
  bool is_calm(std::size_t i) {
    const auto reach = static_cast<std::size_t>(std::ceil(shift_ / width_));
    if (i < reach || i + reach >= strips_.size()) return false;
    for (std::size_t j = i - reach; j <= i + reach; ++j)
      if (!strips_[j].plain || strips_[j].count != strips_[i].count) return false;
    stretched_.clear();
    for (std::size_t e = 0; e < strips_[i].count; ++e) {
      stretched_.push_back(stretched(*passages_[strips_[i].first + e]));
      if (!stretched_.back().complete) return false;
      if (e > 0 && stretched_[e].lowest - stretched_[e - 1].highest <= 2 * shear_) return false;
    }
    return true;
  }

  double least_of(std::size_t i) {
    if (in_zone_[i]) return least_pieces(i) > 0 ? objective_.turn : 0;
    if (strips_[i].plain && strips_[i].count == 0) return 0;
    if (is_calm(i)) return least_of_calm(i);
    const double moved = dearest_ * shear_ * across_near(i);
    const double spared = strips_[i].plain ? least_area_plain(i) : least_area_intricate(i);
    return std::max(0.0, spared - moved) + objective_.turn * least_pieces(i);
  }

  double least_of_calm(std::size_t i) const {
    double sum = 0;
    for (std::size_t e = 0; e < strips_[i].count; e += 2) {
      const double full = stretched_[e + 1].lowest - stretched_[e].highest;
      const bool driven = full >= least_length_ + 2 * shear_;
      const double per_wedge = driven ? per_wedge_ : std::min(per_wedge_, objective_.uncovered);
      if (driven) sum += objective_.turn;
      for (const std::size_t side : {e, e + 1}) sum += least_of_end(i, side, per_wedge);
    }
    return sum;
  }

  double least_of_end(std::size_t i, std::size_t side, double per_wedge) const {
    const PlainEnd& end = *passages_[strips_[i].first + side];
    const Stretched& around = stretched_[side];
    const double flattest = std::atan(around.least_slope) - box_.half_angle;
    const double steepest = std::atan(around.most_slope) + box_.half_angle;
    double wedge = 0;
    if (flattest > 0 && steepest < 0.5 * std::numbers::pi)
      wedge = per_wedge * 0.5 * width_ * width_ * std::tan(flattest);
    const double moved = dearest_ * shear_ * (width_ + 2 * shift_);
    return std::max({0.0, wedge, spared_at(end) - moved});
  }

  /// What the passage costs at least if it moves across.
  double spared_at(const PlainEnd& end) const {
    const double shift = shift_between(end.lowest, end.highest);
    return objective_.overlap * end.over_m2 + objective_.uncovered * end.under_m2 -
           dearest_ * shift * (end.highest - end.lowest);
  }

  double least_area_plain(std::size_t i) const {
    double sum = 0;
    for (std::size_t e = 0; e < strips_[i].count; ++e)
      sum += std::max(0.0, spared_at(*passages_[strips_[i].first + e]));
    return sum;
  }

  /// ∫ max(0, min(λo·(w − s − m), λu·(m − s))) dm from 0 to m.
  double spared_up_to(double m, double shift) const {
    const double low = shift, high = width_ - shift;
    if (!(low < high)) return 0;
    const double both = objective_.overlap + objective_.uncovered;
    if (both <= 0) return 0;
    const double peak = low + (high - low) * objective_.overlap / both;
    const double rising = std::clamp(m, low, peak) - low;
    const double falling = high - std::clamp(m, peak, high);
    return 0.5 * (objective_.uncovered * rising * rising +
                  objective_.overlap * ((high - peak) * (high - peak) - falling * falling));
  }

  double least_area_intricate(std::size_t i) const {
    double sum = 0;
    for (const Slab& slab : profiles_[i].slabs) {
      const double shift = shift_between(slab.from, slab.to);
      const double change = slab.width_to - slab.width_from;
      if (std::abs(change) > 1e-9 * width_) {
        sum += (slab.to - slab.from) *
               (spared_up_to(slab.width_to, shift) - spared_up_to(slab.width_from, shift)) / change;
      } else {
        const double m = slab.width_from;
        sum += (slab.to - slab.from) * std::max(0.0, std::min(objective_.overlap * (width_ - shift - m),
                                                              objective_.uncovered * (m - shift)));
      }
    }
    return sum;
  }

  /// How far the boundary goes across, in all the strips that it may come from.
  double across_near(std::size_t i) const {
    const auto reach = static_cast<std::size_t>(std::ceil(shift_ / width_));
    const std::size_t first = i < reach ? 0 : i - reach, last = std::min(strips_.size() - 1, i + reach);
    double sum = 0;
    for (std::size_t j = first; j <= last; ++j) sum += ends_.across_m(j);
    return sum;
  }

  int least_pieces(std::size_t i) {
    if (in_zone_[i]) return std::min(least_pieces_intricate(i), 1);
    return strips_[i].plain ? least_pieces_plain(i) : least_pieces_intricate(i);
  }

  int least_pieces_plain(std::size_t i) const {
    if (least_width_ + shift_ > width_) return 0;
    int count = 0;
    bool apart = true;  // from the last piece counted
    for (std::size_t e = 0; e < strips_[i].count; e += 2) {
      const PlainEnd& begin = *passages_[strips_[i].first + e];
      const PlainEnd& end = *passages_[strips_[i].first + e + 1];
      if (e > 0 && shift_ < least_width_) {
        const double gap = begin.lowest - passages_[strips_[i].first + e - 1]->highest;
        apart = apart || gap > 2 * shear_;
      }
      if (!apart || end.lowest - begin.highest < least_length_ + 2 * shear_) continue;
      ++count;
      apart = false;
    }
    return count;
  }

  int least_pieces_intricate(std::size_t i) {
    ends_.parts_in_strip(i, parts_);
    const double least = least_width_ + shift_;
    if (tally_.plain_criterion().by_centre_line)
      return pieces_along(i, 0.5 * width_ - shift_, 0.5 * width_ + shift_);
    if (least > width_) return 0;
    return std::max(pieces_along(i, 0, least), pieces_along(i, width_ - least, width_));
  }

  /// Stretches as long as a piece in which the sub-strip from `left` to `right` lies inside, between which
  /// somewhere the whole strip lies outside.
  int pieces_along(std::size_t i, double left, double right) {
    Intervals& blocked = blocked_;
    blocked.clear();
    for (const BoundaryPart& part : parts_) {
      Point a = part.from, b = part.to;
      if (std::max(a.x, b.x) < left || std::min(a.x, b.x) > right) continue;
      const auto at = [&](double x) { return a.y + (b.y - a.y) * ((x - a.x) / (b.x - a.x)); };
      double low = a.y, high = b.y;
      if (a.x != b.x) {
        low = at(std::clamp(a.x, left, right));
        high = at(std::clamp(b.x, left, right));
      }
      blocked.push_back({std::min(low, high), std::max(low, high)});
    }
    if (in_zone_[i]) block_obstacles(i);
    std::sort(blocked.begin(), blocked.end(),
              [](const Interval& a, const Interval& b) { return a.from < b.from; });
    int count = 0;
    double free_from = subfield_.reach.min_y, last_end = 0;
    const double middle = 0.5 * (left + right);
    const auto consider = [&](double from, double to) {
      if (to - from < least_length_ + 2 * shear_ || !inside(i, {middle, 0.5 * (from + to)})) return;
      if (count > 0 && !outside_between(i, last_end, from)) return;
      ++count;
      last_end = to;
    };
    for (const Interval& next : blocked) {
      consider(free_from, next.from);
      free_from = std::max(free_from, next.to);
    }
    consider(free_from, subfield_.reach.max_y);
    return count;
  }

  /// A swath ends before an obstacle that meets any of its width.
  void block_obstacles(std::size_t i) {
    const double left = grid_.line(range_.first + static_cast<int>(i));
    for (const Box& obstacle : subfield_.obstacles)
      if (obstacle.max_x > left - shift_ - kWidthTolerance &&
          obstacle.min_x < left + width_ + shift_ + kWidthTolerance)
        blocked_.push_back({obstacle.min_y, obstacle.max_y});
  }

  /// Of a point that no part of the boundary comes near; x is measured from the strip's left line.
  bool inside(std::size_t i, Point p) const {
    double nearest = width_ + 1;
    int sense = 0;
    for (const BoundaryPart& part : parts_) {
      if ((part.from.y > p.y) == (part.to.y > p.y)) continue;
      const double x =
          part.from.x + (part.to.x - part.from.x) * ((p.y - part.from.y) / (part.to.y - part.from.y));
      if (std::abs(x - p.x) >= nearest) continue;
      nearest = std::abs(x - p.x);
      const bool upward = part.to.y > part.from.y;
      sense = (x > p.x) == upward ? 1 : -1;  // the region lies to the left of its boundary
    }
    if (sense != 0) return sense > 0;
    for (const Slab& slab : profiles_[i].slabs)
      if (slab.from <= p.y && p.y <= slab.to) return slab.width_at(p.y) > 0.5 * width_;
    return false;
  }

  bool outside_between(std::size_t i, double from, double to) const {
    if (shift_ >= least_width_) return false;
    double at = from;
    for (const Slab& slab : profiles_[i].slabs) {
      if (slab.to <= from || slab.from >= to) continue;
      if (slab.from - at > 2 * shear_) return true;
      at = std::max(at, slab.to);
    }
    return to - at > 2 * shear_;
  }

  const GridTally& tally_;
  const TurnedSubfield& subfield_;
  const Objective& objective_;
  const GridBox& box_;
  StripGrid grid_;
  double width_;
  StripRange range_;
  Point pivot_;
  double dearest_;
  double fixed_shift_ = 0, tangent_ = 0;
  double shift_ = 0;  ///< of the boundary across, at most
  double shear_ = 0;  ///< of a strip's columns along, at most, one against the other
  double least_width_ = 0, per_wedge_ = 0, least_length_ = 0;
  StripMask in_zone_;
  PlainEnds ends_;
  std::vector<StripEnds> strips_;
  std::vector<const PlainEnd*> passages_;
  std::vector<Stretched> stretched_;
  std::vector<StripProfile> profiles_;
  std::vector<BoundaryPart> parts_;
  Intervals blocked_;
};

}  // namespace

double least_cost(const GridTally& tally, const BoundTerms& terms, const GridBox& box) {
  return Bound(tally, terms, box).least_cost();
}

}  // namespace tramline
