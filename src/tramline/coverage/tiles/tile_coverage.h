#pragma once
// The exact engine of coverage: areas current after every step, whatever has been worked before.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Exact areas and regions of what was worked, step by step (S3.6-S3.8).
///
/// The plane is cut into square tiles; each tile is a partition into convex cells, every one of them wholly
/// inside or outside the field, worked the same number of times and repeated or not. A quad splits the cells
/// whose state it changes and leaves the others alone; areas are sums over cells, kept as they change.
/// Coordinates within a tile are integers finer than 1 µm (7.5 nm for tiles of 8 m), and what lies closer
/// together than four of them is one.
///
/// Quads of one step are one another's own trail: where they overlap, the ground is sliver. A quad that
/// crosses itself is its two triangles. Not safe to change from several threads at once.
class TileCoverage {
 public:
  struct Settings {
    double tile_m = 8;         ///< side of a tile, kLeastTile_m … kLargestTile_m; about the working width
    bool multiplicity = true;  ///< count up to kMostCounted; else only once and again
  };

  /// `field`: without obstacles, oriented; empty: no field. Throws bad input for a side out of range.
  TileCoverage(const Region& field, const Settings& settings);
  TileCoverage(TileCoverage&&) noexcept;
  TileCoverage& operator=(TileCoverage&&) noexcept;
  ~TileCoverage();

  /// Amortised O(cells met). Preconditions: finite coordinates within kFarthest_m of the origin; travel_m
  /// does not decrease within a run, and what lies further back than kLongestReach_m is forgotten.
  void add(const WorkedStep& step);

  /// Ground that may have been worked and was not recorded. What is worked, before or after, is covered all
  /// the same. O(cells met). Precondition as for add().
  void add_unrecorded(const std::vector<Quad>& quads);

  /// O(1).
  const CoverageAreas& areas() const;

  /// All such ground. Rings simple, holes inside; vertices on a grid of 64 units, and parts thinner than two
  /// of those (1 µm for tiles of 8 m) on average left out: their area is that of areas() up to about 1 µm
  /// times the perimeter. Empty for ground that is not counted (kTwice, kOften without multiplicity). In a
  /// stable order, on any number of threads. O(cells of such ground).
  Region region(Ground what) const;

  /// Ground of the field (without a field: all ground) not worked yet that may lie within a convex ring, in
  /// convex rings, counter-clockwise, that do not overlap: every such cell that reaches into it, whole.
  /// Within 4 units. O(cells of the tiles it reaches into). Precondition: counter-clockwise.
  std::vector<Ring> open_ground(const Ring& convex) const;

  /// A square in which something changed, with what it holds now.
  struct Change {
    Box tile;
    Region ground;
    TileIndex index{};
  };
  /// What changed after `stamp`, a value that stamp() had before; 0: every tile that was ever worked in.
  /// Missed ground of other tiles is the field's own. In the order in which tiles were first worked in.
  /// O(tiles), and O(cells) of those that changed; on several threads, with the same result on any number.
  std::vector<Change> changes_since(std::uint64_t stamp, Ground what) const;
  /// Grows with every step that changes anything.
  std::uint64_t stamp() const;

  /// How much there is; for measurements.
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
