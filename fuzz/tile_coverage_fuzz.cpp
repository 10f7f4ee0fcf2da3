// Any quads at all, in any order: the exact engine against the union by polygon booleans, and against the
// definitions taken word for word.
//
// The first byte picks field and tiles; each quad then takes nine bytes: what its step is, and its corners on
// a grid of 1/8 m, coarse enough that edges and corners of different quads coincide often.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <vector>

#include "coverage/tiles/literal_coverage.h"
#include "tramline/coverage/tiles/tile_coverage.h"
#include "tramline/geometry/polygon/boolean.h"

namespace {

using namespace tramline;

constexpr std::size_t kBytes = 9;
constexpr std::size_t kMostQuads = 24;
constexpr double kGrid_m = 0.125;

Region field_of(std::uint8_t choice) {
  const double side = 8 + choice % 16;
  if (choice % 3 == 0) return {};
  Polygon square{{{1, 1}, {side, 1}, {side, side}, {1, side}}, {}};
  if (choice % 3 == 2) square.holes.push_back({{3, 3}, {3, 5}, {5.5, 5}, {5.5, 3}});
  return {square};
}

/// `data`: one quad's bytes.
void append(const std::uint8_t* data, std::vector<coverage::WorkedStep>& steps) {
  coverage::Quad quad;
  for (std::size_t i = 0; i < 4; ++i) quad[i] = {kGrid_m * data[1 + 2 * i], kGrid_m * data[2 + 2 * i]};
  const bool same_step = !steps.empty() && data[0] % 4 == 0;
  if (same_step) {
    steps.back().quads.push_back(quad);
    return;
  }
  const bool same_run = !steps.empty() && data[0] % 4 != 1;
  const double travel_m = same_run ? steps.back().travel_m + data[0] / 64.0 : 0;
  const int run = steps.empty() ? 0 : steps.back().run + (same_run ? 0 : 1);
  steps.push_back({{quad}, run, travel_m, 4, steps.size()});
}

void demand(bool holds) {
  if (!holds) std::abort();
}

/// Where the true figures are these, up to what rounding to grids may do.
void demand_same(const CoverageAreas& found, const CoverageAreas& wanted, double tolerance_m2) {
  const auto same = [&](double a, double b) { demand(std::abs(a - b) <= tolerance_m2); };
  same(found.covered_m2, wanted.covered_m2);
  same(found.covered_inside_m2, wanted.covered_inside_m2);
  same(found.repeated_m2, wanted.repeated_m2);
  same(found.sliver_m2, wanted.sliver_m2);
  same(found.missed_m2, wanted.missed_m2);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 + kBytes) return 0;
  const Region field = field_of(data[0]);
  coverage::TileCoverage::Settings settings;
  settings.tile_m = (data[0] & 0x40) != 0 ? 2 : 8;
  std::vector<coverage::WorkedStep> steps;
  for (std::size_t i = 0; i < std::min((size - 1) / kBytes, kMostQuads); ++i)
    append(data + 1 + i * kBytes, steps);

  coverage::TileCoverage engine(field, settings);
  Region shapes;
  double perimeters_m = 0;
  for (const coverage::WorkedStep& step : steps) {
    engine.add(step);
    for (const coverage::Quad& quad : step.quads) {
      const Polygon polygon{{quad.begin(), quad.end()}, {}};
      perimeters_m += perimeter(polygon.outer);
      for (const Polygon& part : made_valid(polygon)) shapes.push_back(oriented(part));
    }
  }
  const double tolerance_m2 = 1e-6 * (1 + perimeters_m);
  demand(std::abs(engine.areas().covered_m2 - (shapes.empty() ? 0 : area(unite(shapes)))) <= tolerance_m2);
  demand(std::abs(engine.areas().gross_m2 - area(shapes)) <= tolerance_m2);
  demand_same(engine.areas(), testing::literal_coverage(field, steps), tolerance_m2);
  for (const LandClass what : {LandClass::kCovered, LandClass::kMissed, LandClass::kRepeated})
    for (const Polygon& polygon : engine.region(what)) demand(!find_invalidity(polygon));
  return 0;
}
