#include "irregular_route.h"

#include <cmath>
#include <numbers>

#include "tramline/geometry/angle.h"

namespace tramline::bench {
namespace {

constexpr double kWidth_m = 4, kStep_m = 0.4;

/// Some points along which a machine turns: half a turn, or 0 for a row that wavers.
struct Stretch {
  int points;
  double turn;  ///< positive: to the right
};
/// Turns tighter than half the width sweep back over ground; wide ones leave some between two rows.
constexpr Stretch kStretches[] = {{68, 0}, {14, -1}, {68, 0},  {24, 1}, {68, 0}, {14, -1}, {68, 0},
                                  {25, 1}, {68, 0},  {13, -1}, {68, 0}, {24, 1}, {33, 0}};
constexpr int kBend = 12;  ///< points of a quarter turn to the right; then straight across the rows

double turn_rad(const Stretch& stretch, int point) {
  const double share = std::numbers::pi / stretch.points;
  return stretch.turn == 0 ? 0.001 * std::cos(2 * share * point) : stretch.turn * share;
}

std::vector<Point> places() {
  std::vector<Point> out{{0, 0}};
  double heading_rad = std::numbers::pi;
  const auto go = [&](double turned_rad) {
    heading_rad += turned_rad;
    out.push_back(out.back() + kStep_m * Point{std::sin(heading_rad), std::cos(heading_rad)});
  };
  for (const Stretch& stretch : kStretches)
    for (int i = 0; i < stretch.points; ++i) go(turn_rad(stretch, i));
  for (int i = 0; i < kBend; ++i) go(0.5 * std::numbers::pi / kBend);
  while (out.size() < kIrregularPoints) go(0);
  return out;
}

struct Bar {
  Point left, right;
};

Bar bar(Point at, Heading heading) {
  const Point forward = heading.unit(), left = 0.5 * kWidth_m * Point{-forward.y, forward.x};
  return {at + left, at - left};
}

}  // namespace

std::vector<coverage::WorkedStep> irregular_route() {
  const std::vector<Point> at = places();
  std::vector<coverage::WorkedStep> out;
  Bar rear = bar(at.front(), Heading::clockwise_from_north(Angle::degrees(180)));
  for (std::size_t i = 1; i < at.size(); ++i) {
    const Bar front = bar(at[i], Heading::from_to(at[i - 1], at[i + 1 < at.size() ? i + 1 : i]));
    out.push_back({{{rear.left, rear.right, front.right, front.left}},
                   0,
                   kStep_m * static_cast<double>(i),
                   kWidth_m,
                   i});
    rear = front;
  }
  return out;
}

Region irregular_field() { return {{{{-1.5, -29}, {30, -32}, {30.6, 5.2}, {14, 6}, {-1, 0}}, {}}}; }

}  // namespace tramline::bench
