#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "tramline/check/measure/comparison.h"
#include "tramline/check/rules/rules.h"

namespace tramline::check {
namespace {

/// Areas of plans that differ by less count as equal, m².
constexpr double kSameArea_m2 = 1e-3;

/// The figures by which plans of a front are compared; less is better.
std::vector<double> criteria(const Tally& tally) {
  const auto rounded = [](double area_m2) { return std::round(area_m2 / kSameArea_m2); };
  return {rounded(tally.overlap_m2), rounded(tally.uncovered_m2), static_cast<double>(tally.turns),
          static_cast<double>(tally.stops), static_cast<double>(further_subfields(tally))};
}

bool no_worse(const std::vector<double>& a, const std::vector<double>& b) {
  return std::equal(a.begin(), a.end(), b.begin(), std::less_equal<>());
}

/// The area that a plan has to work, by its figures. For all plans of the front it is the same: that of the
/// plan itself, less the area that headland passes work.
double land_by_figures_m2(const Case& c, const Tally& tally) {
  return c.plan.machine.width_m * tally.track_length_m + tally.uncovered_m2 - tally.overlap_m2;
}

class FrontCheck {
 public:
  FrontCheck(const Case& c, Violations& out) : c_(c), front_(c.plan.front), out_(out) {}

  void run() {
    std::vector<std::vector<double>> all;
    for (const FrontPoint& point : front_.points) all.push_back(criteria(point.tally));
    for (std::size_t i = 0; i < front_.points.size(); ++i) {
      check_figures(i);
      for (std::size_t k = 0; k < all.size(); ++k)
        if (k != i && no_worse(all[k], all[i]))
          report(i, fmt::format("is no better in anything than plan {}", k + 1));
      if (i > 0 && all[i] < all[i - 1]) report(i, "is out of order: plans ascend in overlap");
    }
    check_marks();
  }

 private:
  void check_figures(std::size_t i) {
    const FrontPoint& point = front_.points[i];
    const Tally& tally = point.tally;
    const double expected = cost(c_.plan.objective, tally);
    if (!(std::abs(point.cost - expected) <= rounding_of(expected)))
      report(i, fmt::format("is said to cost {:.6f}, its figures cost {:.6f}", point.cost, expected));
    if (tally.turns != std::max(0, tally.pieces - 1 - tally.crossings))
      report(i, fmt::format("has {} tracks with {} crossings, and {} turns", tally.pieces, tally.crossings,
                            tally.turns));
    if (!(tally.overlap_m2 >= -kSameArea_m2 && tally.uncovered_m2 >= -kSameArea_m2 && tally.stops >= 0 &&
          tally.crossings >= 0 && tally.pieces >= 0))
      report(i, "has a negative figure");
    const Tally& own = c_.plan.tally;
    const double off_m2 = land_by_figures_m2(c_, tally) - land_by_figures_m2(c_, own);
    if (!(std::abs(off_m2) <= 2 * c_.area_tolerance_m2 + kSameArea_m2))
      report(i,
             fmt::format("works, less overlap and with what it leaves, {:.3f} m² more than the land there is",
                         off_m2));
    if (c_.plan.figures == PlanFigures::kTracksAndPasses &&
        tally.subfields > static_cast<int>(point.directions.size()))
      report(i, "works more subfields than it has directions");
  }

  /// Checks that a marked plan has the least value of its kind.
  void check_marks() {
    const FrontMarks& marks = front_.marks;
    const auto check = [&](std::size_t marked, const char* mark, auto figure, double same) {
      for (const FrontPoint& other : front_.points)
        if (figure(other) < figure(front_.points[marked]) - same)
          return report(marked, fmt::format("is marked '{}' and is not", mark));
    };
    check(
        marks.least_overlap, "least overlap", [](const FrontPoint& p) { return p.tally.overlap_m2; },
        kSameArea_m2);
    check(
        marks.least_uncovered, "least uncovered", [](const FrontPoint& p) { return p.tally.uncovered_m2; },
        kSameArea_m2);
    check(
        marks.fewest_turns, "fewest turns and stops",
        [](const FrontPoint& p) { return static_cast<double>(turns_and_stops(p.tally)); }, 0);
    check(
        marks.given_prices, "given prices", [](const FrontPoint& p) { return p.cost; },
        rounding_of(c_.plan.cost));
  }

  void report(std::size_t index, const std::string& fault) {
    out_.push_back({Rule::kFront, fmt::format("plan {} of the front {}", index + 1, fault),
                    c_.plan.field.outer.front(), 1});
  }

  const Case& c_;
  const Front& front_;
  Violations& out_;
};

}  // namespace

void check_front(const Case& c, Violations& out) {
  if (!c.plan.front.points.empty()) FrontCheck(c, out).run();
}

}  // namespace tramline::check
