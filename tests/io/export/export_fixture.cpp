#include "io/export/export_fixture.h"

namespace tramline::io {

Plan sample_plan() {
  Plan plan;
  plan.field.id = "Große Breite";
  plan.field.outer = {{-1600, -300}, {1600, -280}, {1580, 310}, {-1590, 300}};
  plan.field.obstacles = {
      {{{{10, 10}, {14, 10}, {14, 13}, {10, 13}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  plan.field.frame = {true, 13.2612345, 53.5512345, 0, 0};
  plan.field.source = {"fields.gpkg", "parcels", 7, 0};
  plan.field.source.input_crs = "EPSG:25833";
  plan.machine = {"sprayer", 6, 5, 2};
  plan.body = {{plan.field.outer, {{{10, 10}, {10, 13}, {14, 13}, {14, 10}}}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  TrackPiece straight{{-1500.123, 200.5}, {1499.877, 201.25}, 0, 0, false, true, false};
  TrackPiece round{{-200, 5}, {200, 5}, 0, 1, true, false, false};
  round.detours = {{{{{-30, 5}, {-24, 4}, -2 / 37.0}, {{-24, 4}, {-12, 4}, 0}, {{-12, 4}, {0, 5}, 2 / 145.0}},
                    Passing::kLeft,
                    {0}}};
  TrackPiece bend{{-100, 40}, {-60, 50}, 0, 2};
  bend.curve = {{{-100, 40}, {-80, 40}, 0}, {{-80, 40}, {-60, 50}, 1 / 25.0}};
  plan.pieces = {straight, round, bend};
  plan.headland.ground = {{{{-1600, -300}, {1600, -280}, {1590, -270}, {-1590, -290}}, {}}};
  plan.headland.passes = {{{{{10, 100}, {50, 100}, 0},
                            {{50, 100}, {50, 120}, 0.1},
                            {{50, 120}, {10, 120}, 0},
                            {{10, 120}, {10, 100}, 0.1}},
                           1,
                           true,
                           {}}};
  plan.uncovered = {{{{7, 5}, {8, 5}, {8, 6}}, {}}, {{{7, 15}, {8, 15}, {8, 16}}, {}}};
  plan.tally.pieces = 3;
  return plan;
}

const OGRSimpleCurve* curve_of(const OGRGeometry* shape) {
  if (wkbFlatten(shape->getGeometryType()) == wkbPolygon) return shape->toPolygon()->getExteriorRing();
  return shape->toSimpleCurve();
}

}  // namespace tramline::io
