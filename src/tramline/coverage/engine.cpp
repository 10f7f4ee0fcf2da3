#include "tramline/coverage/engine.h"

#include <algorithm>
#include <cmath>

#include "tramline/coverage/mesh/mesh_coverage.h"

namespace tramline::coverage {
namespace {

class ExactEngine : public Engine {
 public:
  ExactEngine(const Region& field, double tile_m) : coverage_(field, {tile_m, true}) {}
  void add(const WorkedStep& step) override { coverage_.add(step); }
  void add_unrecorded(const std::vector<Quad>& quads) override { coverage_.add_unrecorded(quads); }
  CoverageAreas areas() const override { return coverage_.areas(); }
  Region region(Ground what) const override { return coverage_.region(what); }
  const TileCoverage* tiles() const override { return &coverage_; }

 private:
  TileCoverage coverage_;
};

class MeshEngine : public Engine {
 public:
  MeshEngine(const Region& field, double mesh_m) : coverage_(field, mesh_m) {}
  void add(const WorkedStep& step) override { coverage_.add(step); }
  void add_unrecorded(const std::vector<Quad>& quads) override { coverage_.add_unrecorded(quads); }
  CoverageAreas areas() const override { return coverage_.areas(); }
  /// Empty for what meshes do not tell.
  Region region(Ground what) const override {
    const bool counted = what == Ground::kTwice || what == Ground::kOften;
    return counted ? Region{} : coverage_.region(what);
  }

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
  if (kind == EngineKind::kMesh) return std::make_unique<MeshEngine>(field, mesh_m);
  return std::make_unique<ExactEngine>(field, tile_for(width_m, sections));
}

}  // namespace tramline::coverage
