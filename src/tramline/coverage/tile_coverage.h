#pragma once
// The exact engine of coverage: areas current after every step, whatever has been worked before.

#include <cstdint>
#include <memory>
#include <vector>

#include "tramline/coverage/worked_step.h"
#include "tramline/geometry/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Exact areas and regions of what was worked, step by step.
///
/// The plane is cut into square tiles; each tile is a partition into convex cells, every one of them wholly
/// inside or outside the field, worked the same number of times and repeated or not. A quad splits the cells
/// whose state it changes and leaves the others alone; areas are sums over cells, kept as they change.
/// Coordinates within a tile are integers finer than 1 µm.
class TileCoverage {
 public:
  struct Settings {
    double tile_m = 8;         ///< side of a tile; about the working width
    bool multiplicity = true;  ///< count up to kMostCounted; else only once and again
  };

  /// `field`: without obstacles, oriented; empty: no field.
  TileCoverage(const Region& field, const Settings& settings);
  TileCoverage(TileCoverage&&) noexcept;
  TileCoverage& operator=(TileCoverage&&) noexcept;
  ~TileCoverage();

  /// Amortised O(cells met). Precondition: finite coordinates within kFarthest_m of the origin.
  void add(const WorkedStep& step);

  const CoverageAreas& areas() const;

  /// All such ground. Rings simple, holes inside; vertices on the grid of the tiles.
  Region region(Ground what) const;

  /// A square in which something changed, with what it holds now.
  struct Change {
    Box tile;
    Region ground;
  };
  /// What changed after `stamp`, a value that stamp() had before; 0: everything. In a stable order.
  std::vector<Change> changes_since(std::uint64_t stamp, Ground what) const;
  std::uint64_t stamp() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tramline::coverage
