#include "tramline/check/prices/priced_ground.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// Not below the number.
float not_below(double number) {
  return std::nextafter(static_cast<float>(number), std::numeric_limits<float>::infinity());
}

}  // namespace

template <class Visit>
void PricedGround::each_within(const Box& box, const Visit& visit) const {
  const auto first = [&](double from) {
    return std::max(0, static_cast<int>(std::floor(from / pixel_m_ - 0.5)));
  };
  const auto last = [&](double to, int count) {
    return std::min(count - 1, static_cast<int>(std::ceil(to / pixel_m_ - 0.5)));
  };
  for (int row = first(box.min_y - corner_.y); row <= last(box.max_y - corner_.y, rows_); ++row)
    for (int column = first(box.min_x - corner_.x); column <= last(box.max_x - corner_.x, columns_); ++column)
      visit(column, row);
}

PricedGround::PricedGround(const PricedLand& land, double reach_m, double pixel_m)
    : pixel_m_(pixel_m),
      // A pixel counts where its middle is so near, for its corners are nearer still.
      within_m_(reach_m + pixel_m * std::numbers::sqrt2 / 2 + kTouching_m),
      outside_(-land.overlap) {
  Box box = bounds(land.land);
  for (const Polygon& polygon : land.passable) box.extend(bounds(polygon.outer));
  box = box.grown(within_m_ + pixel_m);
  corner_ = {box.min_x, box.min_y};
  columns_ = static_cast<int>(std::ceil(box.width() / pixel_m));
  rows_ = static_cast<int>(std::ceil(box.height() / pixel_m));
  const auto count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  marks_.assign(count, kNothing);
  mark(land.land, kLand);
  mark(land.passable, kPassable);
  worth_.assign(count, 0);
  for (const GroundPrices::Cell& cell : land.prices->cells) raise(cell);
  for (std::size_t i = 0; i < count; ++i) {
    if (marks_[i] == kNothing) worth_[i] = not_below(outside_);
    if (marks_[i] == kPassable) worth_[i] = 0;
  }
  marks_ = {};
}

void PricedGround::mark(const Region& region, Mark bit) {
  const std::vector<Ring> rings = rings_of(region);
  mark_inside(rings, bit);
  for (const Ring& ring : rings) {
    Point from = ring.back();
    for (const Point to : ring) {
      mark_near(from, to, bit);
      from = to;
    }
  }
}

/// All pixels whose middle is inside.
void PricedGround::mark_inside(const std::vector<Ring>& rings, Mark bit) {
  std::vector<std::vector<double>> crossings(static_cast<std::size_t>(rows_));
  for (const Ring& ring : rings) {
    Point a = ring.back();
    for (const Point b : ring) {
      const Point low = a.y < b.y ? a : b, high = a.y < b.y ? b : a;
      const int first = std::max(0, static_cast<int>(std::floor((low.y - corner_.y) / pixel_m_ - 0.5)));
      for (int row = first; row < rows_; ++row) {
        const double y = corner_.y + (row + 0.5) * pixel_m_;
        if (y < low.y) continue;
        if (y >= high.y) break;
        crossings[static_cast<std::size_t>(row)].push_back(low.x +
                                                           (high.x - low.x) * (y - low.y) / (high.y - low.y));
      }
      a = b;
    }
  }
  for (int row = 0; row < rows_; ++row) {
    std::vector<double>& xs = crossings[static_cast<std::size_t>(row)];
    std::sort(xs.begin(), xs.end());
    for (std::size_t i = 0; i + 1 < xs.size(); i += 2) {
      const int first = std::max(0, static_cast<int>(std::floor((xs[i] - corner_.x) / pixel_m_)));
      const int last =
          std::min(columns_ - 1, static_cast<int>(std::floor((xs[i + 1] - corner_.x) / pixel_m_)));
      for (int column = first; column <= last; ++column)
        marks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column)] |= bit;
    }
  }
}

void PricedGround::mark_near(Point from, Point to, Mark bit) {
  // In parts as long as the reach, so that the boxes of slanted edges hold little else.
  const int parts = std::max(1, static_cast<int>(std::ceil(distance(from, to) / (4 * within_m_))));
  for (int i = 0; i < parts; ++i) {
    const Point a = from + (1.0 * i / parts) * (to - from), b = from + (1.0 * (i + 1) / parts) * (to - from);
    each_within(bounds(a, b).grown(within_m_), [&](int column, int row) {
      if (distance_to_segment(middle(column, row), a, b) <= within_m_)
        marks_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
               static_cast<std::size_t>(column)] |= bit;
    });
  }
}

/// Beyond each side of the cell as far as counts, so at its corners somewhat farther.
void PricedGround::raise(const GroundPrices::Cell& cell) {
  struct HalfPlane {
    Point from, outwards;
  };
  std::vector<HalfPlane> sides;
  Point from = cell.shape.back();
  for (const Point to : cell.shape) {
    if (const double length_m = distance(from, to); length_m > 0)
      sides.push_back({from, (1 / length_m) * Point{to.y - from.y, from.x - to.x}});
    from = to;
  }
  const float price = not_below(cell.price);
  each_within(bounds(cell.shape).grown(within_m_), [&](int column, int row) {
    const Point at = middle(column, row);
    for (const HalfPlane& side : sides)
      if (dot(at - side.from, side.outwards) > within_m_) return;
    float& worth = worth_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                          static_cast<std::size_t>(column)];
    worth = std::max(worth, price);
  });
}

}  // namespace tramline::check
