#include "tramline/cost/bound/best_offset.h"

#include <algorithm>
#include <cmath>

#include "tramline/cost/tolerances.h"

namespace tramline {
namespace {

/// Largest number of intervals evaluated; boundaries of thousands of corners, such as rounded ones, would
/// take too long.
constexpr int kMostLooks = 1000;
/// The same where the best need not be found.
constexpr int kFewLooks = 60;

class OffsetSearch {
 public:
  OffsetSearch(const GridTally& tally, const BoundTerms& terms, const PricedOrigin& known, double near_enough)
      : tally_(tally), terms_(terms), best_(known), near_enough_(near_enough) {
    list_breaks();
    look_between(0, breaks_.size() - 1);
  }

  const PricedOrigin& best() const { return best_; }

 private:
  void list_breaks() {
    const double width = tally_.terms().width_m;
    const EndCriterion& rule = tally_.plain_criterion();
    const double share = rule.by_centre_line ? 0.5 * width : rule.least_width_m;
    const double base = tally_.subfield().reach.min_x;
    for (const Ring& ring : tally_.subfield().outline)
      for (const Point& p : ring)
        for (const double shift : {0.0, share, width - share}) {
          const double turns = (p.x - base + shift) / width;
          breaks_.push_back(base + width * (turns - std::floor(turns)));
        }
    breaks_.push_back(base);
    breaks_.push_back(base + width);
    std::sort(breaks_.begin(), breaks_.end());
    const auto same = [](double a, double b) { return b - a < kWidthTolerance; };
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end(), same), breaks_.end());
  }

  double offer(double origin_m) {
    const Tally sum = tally_.at(origin_m);
    const double cost = separate_cost(terms_.objective, sum);
    if (sum.pieces > 0 && cost < best_.cost) best_ = {origin_m, cost};
    return cost;
  }

  void look_between(std::size_t first, std::size_t last) {
    if (looks_++ >= (near_enough_ > 0 ? kFewLooks : kMostLooks)) return;
    const double from = breaks_[first], to = breaks_[last];
    const GridBox box{0.5 * (from + to), 0.5 * (to - from), 0};
    const double worth_it = best_.cost - near_enough_ * std::abs(best_.cost);
    if (least_cost(tally_, terms_, box, worth_it) >= worth_it) return;
    if (last - first > 1) {
      const std::size_t middle = (first + last) / 2;
      look_between(first, middle);
      look_between(middle, last);
      return;
    }
    offer(from);
    offer(to);
    const double quarter = 0.25 * (to - from), centre = 0.5 * (from + to);
    const double a = offer(centre - quarter), b = offer(centre), c = offer(centre + quarter);
    const double curvature = a - 2 * b + c;
    if (curvature > 0) offer(std::clamp(centre + 0.5 * quarter * (a - c) / curvature, from, to));
  }

  const GridTally& tally_;
  const BoundTerms& terms_;
  PricedOrigin best_;
  double near_enough_;
  std::vector<double> breaks_;
  int looks_ = 0;
};

}  // namespace

double separate_cost(const Objective& objective, const Tally& tally) {
  return objective.overlap * tally.overlap_m2 + objective.uncovered * tally.uncovered_m2 +
         objective.turn * (tally.pieces - tally.crossings) + objective.stop * tally.stops;
}

PricedOrigin best_offset(const GridTally& tally, const BoundTerms& terms, const PricedOrigin& known,
                         double near_enough) {
  return OffsetSearch(tally, terms, known, near_enough).best();
}

}  // namespace tramline
