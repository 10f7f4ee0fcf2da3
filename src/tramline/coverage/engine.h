#pragma once
// The common interface of the coverage engines.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// All covered and repeated land of one square tile; local metres. Tiles do not overlap, so a reader may
/// simply collect them.
struct TileWork {
  TileIndex index;
  Region covered;
  Region repeated;
};

/// Areas and regions of what was worked, step by step.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual void add(const WorkedStep& step) = 0;
  /// Adds land that may have been worked and was not recorded.
  virtual void add_unrecorded(const std::vector<Quad>& quads) = 0;
  virtual CoverageAreas areas() const = 0;
  virtual Region region(LandClass what) const = 0;
  /// Only an engine of meshes has them.
  virtual std::optional<Meshes> meshes() const { return std::nullopt; }

  /// A number that grows with every step that changes anything.
  virtual std::uint64_t stamp() const = 0;
  /// The present land of the tiles that changed after `stamp`, an earlier value of stamp(); 0: of all.
  /// O(tiles), and O(cells or meshes) of those that changed.
  virtual std::vector<TileWork> tiles_since(std::uint64_t stamp, RepeatRule repeat) const = 0;
  /// Corners of outlines are this far from the true outline or less, m; 0: exact.
  virtual double grain_m() const { return 0; }
  /// The exact engine; nullptr for another engine.
  virtual const TileCoverage* tiles() const { return nullptr; }
};

/// Side of a tile, m, for a machine of this width and number of sections: a quad should reach into few tiles
/// and a tile hold few quads, and quads are as wide as the machine or as one section.
double tile_for(double width_m, std::size_t sections);

/// `field`: oriented; empty: no field. `width_m` and `sections`: approximate working width and number of
/// sections, for the size of tiles. `mesh_m`: Zhang §2.3.1, for kMesh.
std::unique_ptr<Engine> make_engine(EngineKind kind, const Region& field, double width_m,
                                    std::size_t sections, double mesh_m);

}  // namespace tramline::coverage
