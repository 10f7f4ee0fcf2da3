#pragma once
// The exact coverage engine: areas are current after every step, whatever has been worked before.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Exact areas and regions of what was worked, step by step (what Zhang §3.1 and §3.2 report).
///
/// The plane is cut into square tiles; each tile is a partition into convex cells, every one of them wholly
/// inside or outside the field, worked the same number of times and repeated or not. A quad splits the cells
/// whose state it changes and leaves the others alone; areas are sums over cells, kept as they change.
/// Coordinates within a tile are integers in units finer than 1 µm (7.5 nm for tiles of 8 m), and points
/// closer together than four units count as one.
/// Quads of one step belong to one another's own trail: land where they overlap is sliver. A quad that
/// crosses itself counts as its two triangles. Not safe to change from several threads at once.
class TileCoverage {
 public:
  struct Settings {
    double tile_m = 8;         ///< side of a tile, kLeastTile_m … kLargestTile_m; about the working width
    bool multiplicity = true;  ///< count up to kMostCounted; otherwise only once, and more than once
  };

  /// `field`: without obstacles, oriented; empty: no field. Throws bad input for a side out of range.
  TileCoverage(const Region& field, const Settings& settings);
  TileCoverage(TileCoverage&&) noexcept;
  TileCoverage& operator=(TileCoverage&&) noexcept;
  ~TileCoverage();

  /// Adds a step. Work further back in a run than kLongestReach_m is forgotten. Amortised O(cells
  /// overlapped). Preconditions: finite coordinates within kFarthest_m of the origin; travel_m does not
  /// decrease within a run.
  void add(const WorkedStep& step);

  /// Adds land that may have been worked and was not recorded. Land that is worked, before or after, still
  /// counts as covered. O(cells overlapped). Precondition as for add().
  void add_unrecorded(const std::vector<Quad>& quads);

  /// O(1).
  const CoverageAreas& areas() const;

  /// All land of this class. Rings are simple, holes inside; vertices lie on a grid of 64 units, and parts
  /// thinner on average than two of those (1 µm for tiles of 8 m) are left out: the area equals that of
  /// areas() up to about 1 µm times the perimeter. Empty for land that is not counted (kTwice, kOften without
  /// multiplicity). The order is the same on any number of threads. O(cells of such land).
  Region region(LandClass what) const;

  /// Land of the field (without a field: all land) not worked yet near a convex ring, as convex,
  /// counter-clockwise rings that do not overlap: each such cell that reaches into the ring, as a whole.
  /// Exact within 4 units. O(cells of the tiles it reaches into). Precondition: counter-clockwise.
  std::vector<Ring> open_ground(const Ring& convex) const;

  /// A tile in which something changed, with its present land of the requested class.
  struct Change {
    Box tile;
    Region ground;
    TileIndex index{};
  };
  /// The tiles that changed after `stamp`, an earlier value of stamp(); 0: every tile that was ever worked
  /// in. In all other tiles the missed land is the whole field. In the order in which tiles were first worked
  /// in. O(tiles), and O(cells) of those that changed; on several threads, with the same result on any
  /// number.
  std::vector<Change> changes_since(std::uint64_t stamp, LandClass what) const;
  /// A number that grows with every step that changes anything.
  std::uint64_t stamp() const;

  /// Counts and memory, for measurements.
  struct Size {
    std::size_t tiles = 0;
    std::size_t cells = 0;
    std::size_t bytes = 0;  ///< of tiles and cells
  };
  Size size() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace tramline::coverage
