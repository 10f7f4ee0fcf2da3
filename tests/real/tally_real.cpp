// The closed-form tally of a grid against polygon clipping: every curated real field × directions × end
// rules.
//
//   tally_real [DIRECTIONS]
//
// Prints a line for every field on which the two roads differ by more than a millionth of its area, and the
// greatest difference; exit code 1 where there is one.

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <string>

#include "real/real_fields.h"
#include "real/spread.h"
#include "tramline/avoidance/obstacles/obstacle_classification.h"
#include "tramline/cost/grid/grid_tally.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing {
namespace {

constexpr double kWidth = 6;
constexpr double kTolerance = 1e-6;

/// Useful area of all swaths by cutting each out of the polygon.
double useful_m2(const Polygon& turned, const LaidTracks& tracks) {
  Region swaths;
  for (const LaidPiece& piece : tracks.pieces) {
    const double left = tracks.grid.line(piece.track), right = tracks.grid.line(piece.track + 1);
    swaths.push_back({{{left, piece.from}, {right, piece.from}, {right, piece.to}, {left, piece.to}}, {}});
  }
  return swaths.empty() ? 0 : area(intersection(unite(swaths), {turned}));
}

/// The greatest difference between the two roads, as a share of the part's area.
double difference(const ClassifiedGround& ground, const Polygon& part, int directions,
                  std::mt19937_64& random) {
  double most = 0;
  for (int i = 0; i < directions; ++i)
    for (const EndRule rule : {EndRule::kCentre, EndRule::kCover, EndRule::kInside, EndRule::kCheapest}) {
      const TrackFrame frame(Direction::clockwise_from_north(
          Angle::degrees(std::uniform_real_distribution<double>(0, 180)(random))));
      const TurnedGround around{
          frame.to_track(ground.hard), frame.to_track(ground.passable), {}, frame.to_track(ground.beyond)};
      const EndCriterion criterion = end_criterion(rule, {}, kWidth);
      const double origin_m = std::uniform_real_distribution<double>(0, kWidth)(random);
      const GridTally quick(frame, part, around, {kWidth, 2 * kWidth, criterion});
      const Polygon& turned = quick.subfield().shape;
      const LaidTracks tracks =
          cut_pieces(straight_tracks({frame, origin_m, kWidth}, turned, around, criterion), 2 * kWidth);
      const Tally sum = quick.at(origin_m);
      const double useful = useful_m2(turned, tracks);
      most = std::max({most, std::abs(sum.worked_m2 - sum.overlap_m2 - useful) / area(part),
                       std::abs(area(part) - sum.uncovered_m2 - useful) / area(part),
                       sum.pieces == static_cast<int>(tracks.pieces.size()) ? 0.0 : 1.0});
    }
  return most;
}

int run(int argc, char** argv) {
  const auto fields = read_or_say();
  if (!fields) return 0;
  const int directions = argc > 1 ? std::atoi(argv[1]) : 100;
  std::vector<double> most(fields->features().size(), 0);
  tbb::parallel_for(std::size_t{0}, most.size(), [&](std::size_t i) {
    thread_local const Crs crs(fields->dataset.layers.front().crs);  // one serves one thread at a time
    std::mt19937_64 random(i);
    for (const Field& field : admitted(*fields, crs, fields->features()[i])) {
      const ClassifiedGround ground = classify_obstacles(field, kWidth);
      for (const Polygon& part : ground.plannable)
        if (area(part) > kWidth * kWidth)
          most[i] = std::max(most[i], difference(ground, part, directions, random));
      if (most[i] > kTolerance) fmt::print("  {}: differs by {:.3g} of its area\n", field.id, most[i]);
    }
  });
  const Spread spread = spread_of(most);
  fmt::print(
      "{} features × {} directions × 4 end rules: greatest difference, as a share of the area: median "
      "{:.2g}, "
      "at most {:.2g}\n",
      most.size(), directions, spread.median, spread.most);
  return spread.most > kTolerance ? 1 : 0;
}

}  // namespace
}  // namespace tramline::testing

int main(int argc, char** argv) { return tramline::testing::run(argc, argv); }
