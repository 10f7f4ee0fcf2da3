#include "coverage/ahead/sprayer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "tramline/coverage/ahead/look_ahead.h"
#include "tramline/coverage/tiles/tile_coverage.h"

namespace tramline::testing {
namespace {

using coverage::Quad;
using coverage::SectionState;
using coverage::TileCoverage;
using coverage::WorkedStep;

/// Valves are followed this finely.
constexpr double kInstant_s = 0.02;

struct Ground {
  double slope = 0;     ///< how far the slanted edges lean to the east, for a metre to the north
  double length_m = 0;  ///< of the edges along the passes
  double height_m = 0;
  double headland_m = 0;  ///< along the passes

  Ring ring(double inset_m, double inset_along_m) const {
    const auto at = [&](double along, double y) { return Point{along + slope * y, y}; };
    return {at(inset_along_m, inset_m), at(length_m - inset_along_m, inset_m),
            at(length_m - inset_along_m, height_m - inset_m), at(inset_along_m, height_m - inset_m)};
  }
};

Ground ground_of(const Sprayer& sprayer) {
  const double slant = sprayer.slant_deg * std::numbers::pi / 180;
  Ground out;
  out.slope = 1 / std::tan(slant);
  out.height_m = sprayer.width_m * (sprayer.passes + 2);
  out.headland_m = sprayer.width_m / std::sin(slant);
  out.length_m = 300 + 2 * out.headland_m;
  return out;
}

/// The headland, sprayed before.
WorkedStep headland(const Ground& ground, double width_m) {
  const Ring outer = ground.ring(0, 0), inner = ground.ring(width_m, ground.headland_m);
  WorkedStep out;
  for (std::size_t i = 0; i < 4; ++i)
    out.quads.push_back({inner[i], outer[i], outer[(i + 1) % 4], inner[(i + 1) % 4]});
  return out;
}

Boom boom_of(int sections, double width_m) {
  Boom out;
  for (int i = 0; i < sections; ++i)
    out.push_back({width_m / 2 - width_m * i / sections, width_m / 2 - width_m * (i + 1) / sections});
  return out;
}

/// A way along one pass: where the middle of the boom is, from headland to headland.
struct Pass {
  Point from;
  double sign = 1;  ///< to the east
  double length_m = 0;

  Point at(double way_m) const { return from + Point{sign * way_m, 0}; }
  Heading heading() const { return Heading::from_to(from, at(1)); }
};

std::vector<Pass> passes(const Sprayer& sprayer, const Ground& ground) {
  std::vector<Pass> out;
  // As far out as the whole boom lies over the headland.
  const double beyond_m = 0.5 * sprayer.width_m * ground.slope + 3;
  for (int i = 0; i < sprayer.passes; ++i) {
    const double y = sprayer.width_m * (i + 1.5);
    const double west = ground.headland_m + ground.slope * y - beyond_m;
    const double east = ground.length_m - ground.headland_m + ground.slope * y + beyond_m;
    const bool eastward = i % 2 == 0;
    out.push_back({{eastward ? west : east, y}, eastward ? 1.0 : -1.0, east - west});
  }
  return out;
}

Sprayed result(const TileCoverage& engine) {
  const CoverageAreas& areas = engine.areas();
  return {areas.gross_m2 - areas.covered_m2, areas.missed_m2};
}

/// What the sections that are on spray from one instant to the next.
void spray(TileCoverage& engine, const Pass& pass, double from_m, double to_m, const Boom& boom,
           const std::vector<char>& on, int run) {
  const Point left{0, pass.sign};
  WorkedStep step{{}, run, to_m, to_m - from_m + boom.front().left_m - boom.back().right_m, 0};
  for (std::size_t i = 0; i < boom.size(); ++i)
    if (on[i] != 0)
      step.quads.push_back({pass.at(from_m) + boom[i].left_m * left, pass.at(from_m) + boom[i].right_m * left,
                            pass.at(to_m) + boom[i].right_m * left, pass.at(to_m) + boom[i].left_m * left});
  if (!step.quads.empty()) engine.add(step);
}

}  // namespace

Sprayed sprayed_looking_ahead(const Sprayer& sprayer, int sections) {
  const Ground ground = ground_of(sprayer);
  const Region field{{ground.ring(0, 0), {}}};
  const Boom boom = boom_of(sections, sprayer.width_m);
  TileCoverage engine(field, {});
  engine.add(headland(ground, sprayer.width_m));
  const int instants = static_cast<int>(std::lround(sprayer.tick_s / kInstant_s));
  int run = 0;
  for (const Pass& pass : passes(sprayer, ground)) {
    ++run;
    std::vector<SectionState> states(boom.size());
    std::vector<char> on(boom.size(), 0);
    for (int tick = 0; tick * sprayer.tick_s * sprayer.speed_mps < pass.length_m; ++tick) {
      const double way_m = tick * sprayer.tick_s * sprayer.speed_mps;
      const coverage::Motion motion{pass.at(way_m), pass.heading(), sprayer.speed_mps};
      const auto ahead = look_ahead(engine, field, motion, boom, states, sprayer.rule);
      for (std::size_t i = 0; i < boom.size(); ++i)
        if (!states[i].turning_s && ahead[i].next && ahead[i].next->command_s < sprayer.tick_s / 2)
          states[i].turning_s = states[i].on ? sprayer.off_valve_s : sprayer.on_valve_s;
      for (int k = 0; k < instants; ++k) {
        for (std::size_t i = 0; i < boom.size(); ++i) {
          if (!states[i].turning_s) continue;
          *states[i].turning_s -= kInstant_s;
          if (*states[i].turning_s >= -kInstant_s / 2) continue;
          states[i] = {!states[i].on, {}};
          on[i] = states[i].on ? 1 : 0;
        }
        const double from_m = way_m + k * kInstant_s * sprayer.speed_mps;
        spray(engine, pass, from_m, from_m + kInstant_s * sprayer.speed_mps, boom, on, run);
      }
    }
  }
  return result(engine);
}

Sprayed sprayed_by_hand(const Sprayer& sprayer, Driver driver) {
  const Ground ground = ground_of(sprayer);
  TileCoverage engine({{ground.ring(0, 0), {}}}, {});
  engine.add(headland(ground, sprayer.width_m));
  const Boom boom = boom_of(1, sprayer.width_m);
  int run = 0;
  for (const Pass& pass : passes(sprayer, ground)) {
    // From where the middle leaves the headland to where it comes to the next.
    const double middle_m = 0.5 * sprayer.width_m * ground.slope + 3;
    const double earlier_m = driver == Driver::kMissesNothing ? 0.5 * sprayer.width_m * ground.slope : 0;
    spray(engine, pass, middle_m - earlier_m, pass.length_m - middle_m + earlier_m, boom, {1}, ++run);
  }
  return result(engine);
}

}  // namespace tramline::testing
