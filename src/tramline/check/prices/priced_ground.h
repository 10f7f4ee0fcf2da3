#pragma once
// What a square metre of the ground is worth to a piece that works it, by the prices of a plan's proof.

#include <cstdint>
#include <vector>

#include "tramline/geometry/polygon/region.h"
#include "tramline/model/plan.h"

namespace tramline::check {

/// The land of a proof, local metres.
struct PricedLand {
  Region land;  ///< that is to be worked
  Region passable;
  const GroundPrices* prices = nullptr;  ///< of convex cells, counter-clockwise
  double overlap = 0;                    ///< price per m² outside the land
};

/// The highest worth within a distance of a place, on pixels. Each is a bound for all its places.
class PricedGround {
 public:
  /// Every place within `reach_m` of one counts there. O(pixels + edges · pixels about them).
  PricedGround(const PricedLand& land, double reach_m, double pixel_m);

  /// −overlap wherever no land is within reach, so beyond box() too.
  double at(Point place) const {
    const double x = (place.x - corner_.x) / pixel_m_, y = (place.y - corner_.y) / pixel_m_;
    if (!(x >= 0 && y >= 0 && x < columns_ && y < rows_)) return outside_;
    return worth_[static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(x)];
  }

 private:
  enum Mark : std::uint8_t { kNothing = 0, kLand = 1, kPassable = 2 };
  void mark(const Region& region, Mark bit);
  void mark_inside(const std::vector<Ring>& rings, Mark bit);
  void mark_near(Point from, Point to, Mark bit);
  void raise(const GroundPrices::Cell& cell);
  Point middle(int column, int row) const {
    return corner_ + Point{(column + 0.5) * pixel_m_, (row + 0.5) * pixel_m_};
  }
  /// Calls visit(column, row) for all pixels whose middle is within the box.
  template <class Visit>
  void each_within(const Box& box, const Visit& visit) const;

  double pixel_m_ = 1, within_m_ = 0, outside_ = 0;
  Point corner_;
  int columns_ = 0, rows_ = 0;
  std::vector<std::uint8_t> marks_;
  std::vector<float> worth_;
};

}  // namespace tramline::check
