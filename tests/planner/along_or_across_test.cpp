// What Versleijen found (§3.1 and §4.1): plans of least overlap run across a field's longest edge, plans of
// fewest turns along it. docs/findings.md has the figures.

#include <gtest/gtest.h>

#include <algorithm>

#include "tramline/admission/admit.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/vector/read_vector.h"
#include "tramline/planner/plan_field.h"

namespace tramline {
namespace {

Field example(const std::string& name) {
  io::VectorQuery query;
  query.file = TRAMLINE_SOURCE_DIR "/examples/" + name;
  const RawDataset dataset = io::read_vector(query);
  const RawLayer& layer = dataset.layers.front();
  const Crs crs(layer.crs);
  AdmissionContext context;
  context.file = query.file;
  context.layer = layer.name;
  context.crs = &crs;
  context.winding = dataset.winding;
  return admit(layer.features.front(), context).fields.front();
}

/// Wherever the ring has edges in a row on one line, this takes the longest of them alone.
Direction longest_edge(const Ring& ring) {
  double longest = 0;
  Direction out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()];
    if (distance(a, b) <= longest) continue;
    longest = distance(a, b);
    out = Direction::along(a, b);
  }
  return out;
}

Direction main_direction(const Plan& plan) {
  return std::max_element(plan.subfields.begin(), plan.subfields.end(),
                          [](const Subfield& a, const Subfield& b) { return area(a.shape) < area(b.shape); })
      ->direction;
}

// Versleijen's convention: under the centre rule a track's end overlaps as much as it leaves uncovered.
Plan plan_for(const Field& field, const Objective& objective) {
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.end_rule = EndRule::kCentre;
  settings.avoid = Avoidance::kCut;  // detours cost overlap of their own
  return plan_field(field, Machine{}, objective, settings);
}

// By hand, for w = 3 m, the field's tongue cut off straight and its obstacles left aside. Where a swath ends
// at an edge that it meets at an angle φ, a triangle with the legs w/2 and w/2·cot φ is worked beyond the
// edge. An edge of length ℓ is met by ℓ·sin φ / w swaths, so it costs
// ℓ·sin φ / w · w²/8·cot φ = (w/8)·ℓ·cos φ: what counts is how far the edge runs along the tracks. Edges that
// lie within one swath are not met. In the frame of tools/draw_examples.py, with the road on the x axis:
//
//   tracks along the road (0°)       lane 17 + hedge 352 + cut 50 + brook 13 = 432 m,
//                                    (3/8)·432 = 162 m²; 166 m across the tracks: 56 of them
//   tracks along the brook (95.7°)   road 37 + lane 135 + hedge 99 + cut 3 = 274 m, and the brook within one
//                                    swath, (3/8)·274 = 103 m²; 400 m across the tracks: 134 of them
//
// Tracks along the road work half as much again twice; tracks across it are more than twice as many. The
// tongue has a direction of its own in both plans and adds tracks to both, and overlap above all to the plan
// across the road, whose tracks run into the tongue's long side. What is left of either gain is asserted
// below: the order of overlaps, and half as many turns again.
TEST(AlongOrAcross, OverlapWantsTracksAcrossTheLongestEdgeAndTurnsAlongIt) {
  const Field field = example("roadside.geojson");
  const Direction edge = longest_edge(field.outer);
  const Plan least_overlap = plan_for(field, {1, 0, 0, 0});
  const Plan fewest_turns = plan_for(field, {0, 0, 1, 0});
  EXPECT_GT(angle_between(main_direction(least_overlap), edge).degrees(), 45);
  EXPECT_LT(angle_between(main_direction(fewest_turns), edge).degrees(), 45);
  EXPECT_LT(least_overlap.tally.overlap_m2, fewest_turns.tally.overlap_m2);
  EXPECT_LT(1.5 * fewest_turns.tally.turns, least_overlap.tally.turns);
}

}  // namespace
}  // namespace tramline
