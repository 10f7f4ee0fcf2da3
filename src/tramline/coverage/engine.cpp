#include "tramline/coverage/engine.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "tramline/coverage/mesh/connected_rings.h"
#include "tramline/coverage/mesh/mesh_coverage.h"

namespace tramline::coverage {
namespace {

class ExactEngine : public Engine {
 public:
  ExactEngine(const Region& field, double tile_m) : coverage_(field, {tile_m, true}) {}
  void add(const WorkedStep& step) override { coverage_.add(step); }
  void add_unrecorded(const std::vector<Quad>& quads) override { coverage_.add_unrecorded(quads); }
  CoverageAreas areas() const override { return coverage_.areas(); }
  Region region(LandClass what) const override { return coverage_.region(what); }
  const TileCoverage* tiles() const override { return &coverage_; }
  std::uint64_t stamp() const override { return coverage_.stamp(); }
  std::vector<TileWork> tiles_since(std::uint64_t stamp, RepeatRule repeat) const override {
    std::vector<TileCoverage::Change> covered = coverage_.changes_since(stamp, LandClass::kCovered);
    std::vector<TileCoverage::Change> repeated = coverage_.changes_since(
        stamp, repeat == RepeatRule::kStrict ? LandClass::kAgain : LandClass::kRepeated);
    std::vector<TileWork> out;
    out.reserve(covered.size());
    for (std::size_t i = 0; i < covered.size(); ++i)
      out.push_back({covered[i].index, std::move(covered[i].ground), std::move(repeated[i].ground)});
    return out;
  }

 private:
  TileCoverage coverage_;
};

class MeshEngine : public Engine {
 public:
  MeshEngine(const Region& field, double mesh_m, double tile_m) : coverage_(field, mesh_m, tile_m) {}
  void add(const WorkedStep& step) override { coverage_.add(step); }
  void add_unrecorded(const std::vector<Quad>& quads) override { coverage_.add_unrecorded(quads); }
  CoverageAreas areas() const override { return coverage_.areas(); }
  /// Empty for what meshes do not tell.
  Region region(LandClass what) const override {
    const bool counted = what == LandClass::kTwice || what == LandClass::kOften;
    return counted ? Region{} : coverage_.region(what);
  }
  std::optional<Meshes> meshes() const override { return coverage_.meshes(); }
  std::uint64_t stamp() const override { return coverage_.tiles().stamp(); }
  /// Meshes know no slivers: all land worked twice is repeated, by either rule.
  std::vector<TileWork> tiles_since(std::uint64_t stamp, RepeatRule /*repeat*/) const override {
    const MeshTiles& tiles = coverage_.tiles();
    const auto shape = [&](const MeshRegion& region, TileIndex tile) {
      return region_of(tiles.part(region, tile), coverage_.mesh_m());
    };
    std::vector<TileWork> out;
    for (const TileIndex tile : tiles.changed_since(stamp))
      out.push_back({tile, shape(coverage_.covered(), tile), shape(coverage_.repeated(), tile)});
    return out;
  }
  double grain_m() const override { return coverage_.mesh_m(); }

 private:
  MeshCoverage coverage_;
};

}  // namespace

double tile_for(double width_m, std::size_t sections) {
  const double section_m = width_m / static_cast<double>(std::max<std::size_t>(1, sections));
  return std::clamp(std::sqrt(width_m * section_m), 2.0, 32.0);
}

const char* name(EngineKind kind) { return kind == EngineKind::kMesh ? "mesh" : "exact"; }

std::unique_ptr<Engine> make_engine(EngineKind kind, const Region& field, double width_m,
                                    std::size_t sections, double mesh_m) {
  if (kind == EngineKind::kMesh)
    return std::make_unique<MeshEngine>(field, mesh_m, tile_for(width_m, sections));
  return std::make_unique<ExactEngine>(field, tile_for(width_m, sections));
}

}  // namespace tramline::coverage
