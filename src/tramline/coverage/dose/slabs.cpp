#include "tramline/coverage/dose/slabs.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace tramline::coverage {
namespace {

/// Ways of the two sides of a slab differ by this share of the longer at most.
constexpr double kEvenWay = 0.2;
/// No side counts as slower than this share of the fastest: amounts at the hub of a turn stay finite.
constexpr double kSlowest = 0.05;
constexpr double kSameEnd_m = 1e-3;

/// A quad by the place across the machine.
class Sweep {
 public:
  Sweep(const Quad& quad, const Section& section)
      : quad_(quad), right_m_(section.right_m), width_m_(section.left_m - section.right_m) {
    const Point bar = (quad[0] - quad[1]) + (quad[3] - quad[2]);
    const double bar_m = length(bar);
    const auto swept = [&](Point way) { return bar_m > 0 ? cross(way, bar) / bar_m : length(way); };
    swept_right_ = swept(quad[2] - quad[1]);
    swept_left_ = swept(quad[3] - quad[0]);
  }

  Point rear(double offset_m) const { return between(quad_[1], quad_[0], offset_m); }
  Point front(double offset_m) const { return between(quad_[2], quad_[3], offset_m); }
  /// How far the place there goes square to the machine; negative: backwards.
  double swept(double offset_m) const {
    const double share = (offset_m - right_m_) / width_m_;
    return (1 - share) * swept_right_ + share * swept_left_;
  }
  /// Where it neither goes forwards nor backwards; NaN: nowhere.
  double hub_m() const { return right_m_ + width_m_ * swept_right_ / (swept_right_ - swept_left_); }

 private:
  Point between(Point right, Point left, double offset_m) const {
    const double share = (offset_m - right_m_) / width_m_;
    return (1 - share) * right + share * left;
  }

  Quad quad_;
  double right_m_, width_m_;
  double swept_right_ = 0, swept_left_ = 0;
};

/// Ends of the slabs within a stretch, from right to left.
std::vector<double> ends_of(const Sweep& sweep, const PatternStretch& stretch, double fastest_m,
                            double cell_m) {
  std::vector<double> ends{stretch.right_m};
  const auto cut_to = [&](double left_m) {
    const double right_m = ends.back();
    const double a = std::abs(sweep.swept(right_m)), b = std::abs(sweep.swept(left_m));
    const double longer = std::max({a, b, kSlowest * fastest_m});
    const double wanted = longer > 0 ? std::ceil(std::abs(a - b) / longer / kEvenWay) : 1;
    const double most = std::ceil((left_m - right_m) / (0.5 * cell_m));
    const int n = static_cast<int>(std::max(1.0, std::min(wanted, most)));
    for (int i = 1; i < n; ++i) ends.push_back(right_m + (left_m - right_m) * i / n);
    ends.push_back(left_m);
  };
  const double hub_m = sweep.hub_m();
  if (hub_m > stretch.right_m && hub_m < stretch.left_m) cut_to(hub_m);
  cut_to(stretch.left_m);
  return ends;
}

}  // namespace

void append_slabs(const Quad& quad, const Section& section, double per_m, const TransversePattern& pattern,
                  double half_width_m, double cell_m, std::vector<Slab>& out) {
  assert(section.left_m > section.right_m);
  const Sweep sweep(quad, section);
  Section laid = section;
  if (!pattern.even()) {
    if (section.left_m >= half_width_m - kSameEnd_m) laid.left_m = std::max(laid.left_m, pattern.left_m());
    if (section.right_m <= kSameEnd_m - half_width_m)
      laid.right_m = std::min(laid.right_m, pattern.right_m());
  }
  const double fastest_m = std::max(std::abs(sweep.swept(laid.right_m)), std::abs(sweep.swept(laid.left_m)));
  for (const PatternStretch& stretch : pattern.within(laid.right_m, laid.left_m)) {
    const auto rate = [&](double offset_m) {
      const double share = (offset_m - stretch.right_m) / (stretch.left_m - stretch.right_m);
      return (1 - share) * stretch.at_right + share * stretch.at_left;
    };
    const auto dense = [&](double offset_m) {
      const double way_m = std::max(std::abs(sweep.swept(offset_m)), kSlowest * fastest_m);
      return way_m > 0 ? rate(offset_m) / way_m : rate(offset_m);
    };
    const std::vector<double> ends = ends_of(sweep, stretch, fastest_m, cell_m);
    for (std::size_t i = 1; i < ends.size(); ++i) {
      const double right_m = ends[i - 1], left_m = ends[i];
      const double amount = per_m * 0.5 * (rate(right_m) + rate(left_m)) * (left_m - right_m);
      if (!(amount > 0)) continue;
      out.push_back({{sweep.rear(left_m), sweep.rear(right_m), sweep.front(right_m), sweep.front(left_m)},
                     amount,
                     dense(right_m),
                     dense(left_m)});
    }
  }
}

}  // namespace tramline::coverage
