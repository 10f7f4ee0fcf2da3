#pragma once
// The land of the tracks, as ways lead over it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/turns/room/land_edges.h"

namespace tramline {

/// Land in square cells, most of which no edge meets: a point in one of those is on the land with all of the
/// cell. Built once, and safe to read from any number of threads.
class CropGround {
 public:
  /// O(n + cells that edges meet + cells): about kMostCropCells of these at the most, or one for every metre
  /// of land that is next to no metre wide.
  explicit CropGround(const Region& land);

  /// The length of the path over the land, in steps of kCropStep_m, m. O(steps), and O(√n) where a step ends
  /// near an edge.
  double length_over_m(const SteeredPath& path) const;

 private:
  enum class Cell : std::uint8_t { kOff, kOn, kMeetsEdge };

  void mark(const EdgeIndex::Edge& edge);
  void fill();
  std::size_t column_of(double x) const;
  std::size_t row_of(double y) const;
  Cell cell_of(Point p) const;

  LandEdges edges_;
  Box bounds_;
  double cell_m_ = 1;
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<Cell> cells_;  ///< row by row
};

inline constexpr double kCropStep_m = 2;
inline constexpr double kMostCropCells = 20000;

}  // namespace tramline
