#pragma once
// The common interface of the coverage engines.

#include <cstddef>
#include <memory>
#include <vector>

#include "tramline/coverage/drive/worked_step.h"
#include "tramline/coverage/evaluate_settings.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/model/coverage.h"

namespace tramline::coverage {

/// Areas and regions of what was worked, step by step.
class Engine {
 public:
  virtual ~Engine() = default;
  virtual void add(const WorkedStep& step) = 0;
  /// Adds land that may have been worked and was not recorded.
  virtual void add_unrecorded(const std::vector<Quad>& quads) = 0;
  virtual CoverageAreas areas() const = 0;
  virtual Region region(Ground what) const = 0;
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
