// Cells of a sweep are the ground, whatever the direction: no land lost, none counted twice.

#include <gtest/gtest.h>

#include "properties/random_field.h"
#include "properties/seeds.h"
#include "tramline/decomposition/candidate_directions.h"
#include "tramline/decomposition/cells.h"
#include "tramline/decomposition/decompose.h"
#include "tramline/decomposition/events.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"

namespace tramline {
namespace {

TEST(CellProperties, CellsAndSubfieldsAreTheGroundInEveryEdgeDirection) {
  for (int i = 0; i < testing::case_count(30); ++i) {
    testing::SeededRandom random(i);
    const Field field = testing::random_field(random, 6);
    const Region ground = body_of(field);
    PlanSettings settings;
    settings.merge_threshold = Angle::degrees(10);
    for (const Direction sweep : candidate_directions(field)) {
      double cells_m2 = 0, subfields_m2 = 0;
      Region shapes;
      for (const Cell& cell : sweep_cells(ground, sweep, Angle::degrees(180), CellDirection::kRectangle)) {
        cells_m2 += area(cell.shape);
        shapes.push_back(cell.shape);
        // Cuts end within a micrometre of vertices: a corner may be that much off 180 degrees.
        ASSERT_TRUE(split_events(cell.shape, Angle::degrees(180.01)).empty()) << "sweep " << sweep.degrees();
      }
      for (const Subfield& subfield : decompose(ground, sweep, settings)) {
        subfields_m2 += area(subfield.shape);
        ASSERT_FALSE(find_invalidity(subfield.shape)) << "sweep " << sweep.degrees();
      }
      ASSERT_NEAR(cells_m2, area(ground), 1e-6) << "sweep " << sweep.degrees();
      ASSERT_NEAR(subfields_m2, area(ground), 1e-6) << "sweep " << sweep.degrees();
      ASSERT_NEAR(area(unite(shapes)), area(ground), 1e-2) << "sweep " << sweep.degrees();
    }
  }
}

}  // namespace
}  // namespace tramline
