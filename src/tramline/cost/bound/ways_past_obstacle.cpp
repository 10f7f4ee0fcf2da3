#include "tramline/cost/bound/ways_past_obstacle.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/cost/bound/detour_length.h"

namespace tramline {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

/// How far to the side the inner edge of a detour's swath lies, at least, row by row. Negative: towards the
/// other side of the track.
class InnerEdge {
 public:
  InnerEdge(std::vector<SeenPoint> points, const PassedPlace& place, double half_width_m, double arc_m)
      : place_(place), half_m_(half_width_m), arc_m_(arc_m), outer_m_(arc_m + half_width_m) {
    const std::vector<SeenPoint> hull = upper_hull(std::move(points));
    constexpr int kParts = 4;  // of an edge, whose places the arcs may touch
    for (std::size_t i = 0; i < hull.size(); ++i) {
      chain_.push_back(hull[i]);
      for (int k = 1; k < kParts && i + 1 < hull.size(); ++k) {
        const double share = static_cast<double>(k) / kParts;
        chain_.push_back({hull[i].along + share * (hull[i + 1].along - hull[i].along),
                          hull[i].aside + share * (hull[i + 1].aside - hull[i].aside)});
      }
    }
    for (const SeenPoint& p : chain_) {
      const double foot_m = foot(p.aside);
      if (foot_m < 0) continue;
      if (p.along - foot_m < begins_) {
        begins_ = p.along - foot_m;
        first_ = p.along;
      }
      if (p.along + foot_m > ends_) {
        ends_ = p.along + foot_m;
        last_ = p.along;
      }
    }
  }

  /// In all rows between two coordinates along: both bounds rise to their highest place and fall from it.
  double least_between(double from, double to) const {
    const double by_arcs =
        place_.aside_m > 0 ? std::min(inner_edge_m(place_, std::abs(from - place_.along) + place_.slack_m),
                                      inner_edge_m(place_, std::abs(to - place_.along) + place_.slack_m))
                           : -half_m_;
    return std::max(by_arcs, std::min(round_points(from), round_points(to)));
  }

 private:
  /// How far along from a point the arc that passes it has come to the track; −1: it need not pass it.
  double foot(double aside) const {
    if (aside >= arc_m_) return outer_m_;
    const double below_m = arc_m_ - aside;
    return below_m > outer_m_ ? -1 : std::sqrt((outer_m_ - below_m) * (outer_m_ + below_m));
  }

  /// The edge of what passes the points: along their hull, and along arcs from and to the track.
  double round_points(double along) const {
    if (!(begins_ < along && along < ends_)) return -half_m_;
    if (along < first_) return on_arc(along - begins_);
    if (along > last_) return on_arc(ends_ - along);
    const auto next = std::upper_bound(chain_.begin(), chain_.end(), along,
                                       [](double a, const SeenPoint& p) { return a < p.along; });
    if (next == chain_.begin()) return chain_.front().aside;
    if (next == chain_.end()) return chain_.back().aside;
    const SeenPoint &a = *(next - 1), &b = *next;
    return a.aside + (b.aside - a.aside) * ((along - a.along) / (b.along - a.along));
  }
  double on_arc(double from_foot_m) const {
    const double d = std::min(from_foot_m, outer_m_);
    return arc_m_ - std::sqrt((outer_m_ - d) * (outer_m_ + d));
  }

  PassedPlace place_;
  double half_m_, arc_m_, outer_m_;
  std::vector<SeenPoint> chain_;
  double begins_ = kNever, ends_ = -kNever;  ///< where the swath's edge leaves the track's
  double first_ = 0, last_ = 0;              ///< points that the arcs touch
};

/// Tries all pairs of the rightmost strip that goes left and the leftmost one that goes right.
class Ways {
 public:
  Ways(const ObstacleTerms& terms, std::span<const StripAtObstacle> strips) : terms_(terms), strips_(strips) {
    constexpr double kRow_share = 0.04;  // of the outer arc's radius
    constexpr int kFewest = 8, kMost = 128;
    const double length_m = terms.rows.length();
    rows_ = std::clamp(static_cast<int>(length_m / (kRow_share * (terms.arc_m + 0.5 * terms.width_m))),
                       kFewest, kMost);
    step_m_ = length_m / rows_;
    find_obstacle();
    find_edges();
    known_m2_.assign(2 * (2 * strips.size() + 1) * strips.size(), -1);
  }

  double least() {
    const int n = static_cast<int>(strips_.size());
    double best = kNever;
    // Those that do not cross first, which are mostly the cheapest.
    for (int apart = 1; apart <= n + 1; ++apart)
      for (int left = -1; left + apart <= n; ++left) best = std::min(best, cost(left, left + apart, best));
    for (int apart = 1; apart < n; ++apart)
      for (int left = apart; left < n; ++left) best = std::min(best, cost(left, left - apart, best));
    return best;
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  double row_from(int row) const { return terms_.rows.from + row * step_m_; }
  std::size_t in_table(int strip, int row) const { return at(strip) * at(rows_) + at(row); }

  /// Sets obstacle_: where it may lie in each row.
  void find_obstacle() {
    obstacle_.assign(at(rows_), {kNever, -kNever});
    Point a = terms_.ring.back();
    for (const Point b : terms_.ring) {
      const Point low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
      a = b;
      const auto row_of = [this](double y) {
        return static_cast<int>(std::floor(std::clamp((y - terms_.rows.from) / step_m_, -1.0, rows_ + 1.0)));
      };
      const int first = std::max(0, row_of(low.y - terms_.along_m) - 1);
      const int last = std::min(rows_ - 1, row_of(high.y + terms_.along_m) + 1);
      for (int row = first; row <= last; ++row) {
        const double from = row_from(row) - terms_.along_m, to = row_from(row + 1) + terms_.along_m;
        if (high.y < from || low.y > to) continue;
        Interval& part = obstacle_[at(row)];
        for (const double y : {std::clamp(from, low.y, high.y), std::clamp(to, low.y, high.y)}) {
          const auto see = [&](double x) {
            part = {std::min(part.from, x - terms_.across_m), std::max(part.to, x + terms_.across_m)};
          };
          if (low.y == high.y) {
            see(low.x);
            see(high.x);
          } else {
            see(low.x + (high.x - low.x) * ((y - low.y) / (high.y - low.y)));
          }
        }
      }
    }
  }

  /// Sets what is the farthest that detours on the left, of strips up to each, work to the right; and those
  /// on the right to the left.
  void find_edges() {
    const int n = static_cast<int>(strips_.size());
    left_edges_.assign(at(n) * at(rows_), -kNever);
    right_edges_.assign(at(n) * at(rows_), kNever);
    for (int i = 0; i < n; ++i) {
      add_edges(i, 0, left_edges_);
      if (i == 0) continue;
      for (int row = 0; row < rows_; ++row)
        left_edges_[in_table(i, row)] =
            std::max(left_edges_[in_table(i, row)], left_edges_[in_table(i - 1, row)]);
    }
    for (int i = n - 1; i >= 0; --i) {
      add_edges(i, 1, right_edges_);
      if (i == n - 1) continue;
      for (int row = 0; row < rows_; ++row)
        right_edges_[in_table(i, row)] =
            std::min(right_edges_[in_table(i, row)], right_edges_[in_table(i + 1, row)]);
    }
  }

  void add_edges(int i, std::size_t side, std::vector<double>& edges) const {
    const StripAtObstacle& strip = strips_[at(i)];
    if (!std::isfinite(strip.ways[side].cost)) return;
    const double centre = strip.left + 0.5 * terms_.width_m, sense = side == 0 ? -1 : 1;
    std::vector<SeenPoint> points;
    for (const Point p : strip.ways[side].passed)
      points.push_back({p.y, sense * (p.x - centre) - terms_.across_m});
    const InnerEdge edge(std::move(points), strip.ways[side].place, 0.5 * terms_.width_m, terms_.arc_m);
    for (int row = 0; row < rows_; ++row)
      edges[in_table(i, row)] = centre + sense * edge.least_between(row_from(row) - terms_.along_m,
                                                                    row_from(row + 1) + terms_.along_m);
  }

  /// Land of a strip that nobody works in some rows where no others go left than those up to `left`, and no
  /// others right than those from `right` on.
  double unworked_m2(int i, int left, int right, const Interval& rows) const {
    const StripAtObstacle& strip = strips_[at(i)];
    const double from = std::max(strip.clear.from, rows.from), to = std::min(strip.clear.to, rows.to);
    const double line = strip.left + terms_.width_m;
    double sum = 0;
    for (int row = 0; row < rows_; ++row) {
      if (row_from(row) < from || row_from(row + 1) > to) continue;
      const double low = left < i ? strip.left : std::max(strip.left, left_edges_[in_table(left, row)]);
      const double high = right > i ? line : std::min(line, right_edges_[in_table(right, row)]);
      const Interval& obstacle = obstacle_[at(row)];
      if (low >= high) continue;
      sum += high - low - std::max(0.0, std::min(high, obstacle.to) - std::max(low, obstacle.from));
    }
    return sum * step_m_;
  }

  /// The same, for a strip that goes round, or one that is cut. Detours on the left of strips that lie
  /// farther left do not come to a strip, so that mostly one of the two counts, and the area is known
  /// already.
  double left_m2(int i, int left, int right, bool is_cut) {
    const StripAtObstacle& strip = strips_[at(i)];
    const Interval& rows = is_cut ? strip.in_the_way : terms_.rows;
    if (left >= i && right <= i) return unworked_m2(i, left, right, rows);
    const std::size_t by = left >= i    ? at(left)
                           : right <= i ? strips_.size() + at(right)
                                        : 2 * strips_.size();
    double& known = known_m2_[(2 * by + (is_cut ? 1 : 0)) * strips_.size() + at(i)];
    if (known < 0) known = unworked_m2(i, left, right, rows);
    return known;
  }

  /// The ways round that a strip has beside these two.
  double round_cost(int i, int left, int right) const {
    const StripAtObstacle& strip = strips_[at(i)];
    if (i == left) return strip.ways[0].cost;
    if (i == right) return strip.ways[1].cost;
    return std::min(i < left ? strip.ways[0].cost : kNever, i > right ? strip.ways[1].cost : kNever);
  }

  /// Least cost of a strip, without the land that is left.
  double quick_cost(int i, int left, int right) const {
    const StripAtObstacle& strip = strips_[at(i)];
    const double round = round_cost(i, left, right);
    if (i == left || i == right) return round;
    return strip.blocked ? std::min(strip.cut, round) : 0;
  }

  double strip_cost(int i, int left, int right) {
    const StripAtObstacle& strip = strips_[at(i)];
    const bool may_cut = i != left && i != right;
    if (may_cut && !strip.blocked) return 0;
    double out = kNever;
    if (const double round = round_cost(i, left, right); std::isfinite(round))
      out = round + terms_.land_price * left_m2(i, left, right, false);
    if (may_cut && strip.cut < out)
      out = std::min(out, strip.cut + terms_.land_price * left_m2(i, left, right, true));
    return out;
  }

  /// The least cost with these two; some number that is no less than `enough` where that is no less.
  double cost(int left, int right, double enough) {
    const int n = static_cast<int>(strips_.size());
    if (left >= 0 && !std::isfinite(strips_[at(left)].ways[0].cost)) return kNever;
    if (right < n && !std::isfinite(strips_[at(right)].ways[1].cost)) return kNever;
    double sum = 0;
    for (int i = 0; i < n && sum < enough; ++i) sum += quick_cost(i, left, right);
    for (int i = 0; i < n && sum < enough; ++i)
      sum += strip_cost(i, left, right) - quick_cost(i, left, right);
    return sum;
  }

  const ObstacleTerms& terms_;
  std::span<const StripAtObstacle> strips_;
  int rows_ = 1;
  double step_m_ = 1;
  std::vector<Interval> obstacle_;                ///< by row; from > to: it is not there
  std::vector<double> left_edges_, right_edges_;  ///< by strip, then by row
  std::vector<double> known_m2_;                  ///< of land that is left; −1: not known yet
};

}  // namespace

double least_cost_past(const ObstacleTerms& terms, std::span<const StripAtObstacle> strips) {
  return Ways(terms, strips).least();
}

}  // namespace tramline
