#pragma once
// The pieces of one direction that are worth most, by the prices of the ground.

#include <utility>
#include <vector>

#include "tramline/planner/prove/ground_labels.h"

namespace tramline {

/// The sizes of a sweep. All swaths whose place differs from that of one that is looked at by half a step
/// across and by half_angle lie within reach of it.
struct SweepScale {
  double width_m = 1;
  int lines = 4;          ///< into which the width is divided
  double half_angle = 0;  ///< between directions
  double radius_m = 0;    ///< of the land about its pivot

  double step_m() const { return width_m / lines; }
  double reach_m() const;
};

/// A row of prices that a piece is worth: its area by the cell that was counted, and outside the land.
struct PieceWorth {
  double worth = 0;
  double outside_m2 = 0;
  std::vector<std::pair<int, double>> area_m2;  ///< by cell, ascending
};

/// The most that any piece near each offset is worth; the prices are those of `worth`, and the labels have
/// been gathered within scale.reach_m().
class StripSweep {
 public:
  StripSweep(const GroundLabels& ground, const PixelWorth& worth, const SweepScale& scale, Point pivot)
      : ground_(ground), worth_(worth), scale_(scale), pivot_(pivot) {}

  /// Looks at all offsets of one direction, in radians from the grid's towards its right. O(a/step²) for an
  /// area a of the box round the land.
  void lay(double angle);
  int offsets() const { return static_cast<int>(best_.size()); }
  double worth(int offset) const { return best_[static_cast<std::size_t>(offset)].worth; }
  double most() const;
  /// The area of the piece that is worth most there.
  PieceWorth piece(int offset) const;

 private:
  struct Best {
    double worth = 0;
    int from = 0, to = 0;  ///< rows
  };
  std::int32_t set_at(int line, int row) const;
  void look(int offset);
  void add_line(int line, double sign);

  const GroundLabels& ground_;
  const PixelWorth& worth_;
  SweepScale scale_;
  Point pivot_, up_, right_;
  int first_line_ = 0, lines_ = 0, first_row_ = 0, rows_ = 0;
  std::vector<std::int32_t> sets_;  ///< line by line
  std::vector<double> samples_;     ///< their worth
  std::vector<double> sums_;        ///< by row, of the lines of a swath
  std::vector<Best> best_;
};

}  // namespace tramline
