// What is worked near a place, of strips and of tracks along a curve at once, against polygon booleans.

#include "tramline/cost/worked/worked_ground.h"

#include <gtest/gtest.h>

#include <random>

#include "tramline/geometry/offset/parallel.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/tracks/curved_tracks.h"
#include "tramline/tracks/straight_tracks.h"
#include "tramline/tracks/tolerances.h"

namespace tramline::worked_ground_test {

constexpr double kWidth = 3;
constexpr EndCriterion kCover{false, kWidthTolerance};

Ring ring_of(const Box& box) {
  return {{box.min_x, box.min_y}, {box.max_x, box.min_y}, {box.max_x, box.max_y}, {box.min_x, box.max_y}};
}

TrackFamily strips_at(double degrees, const Polygon& subfield) {
  const StripGrid grid{TrackFrame(Direction::clockwise_from_north(Angle::degrees(degrees))), 0.7, kWidth};
  return straight_tracks(grid, grid.frame.to_track(Region{subfield}).front(), {}, kCover);
}

/// Arcs about the origin.
TrackFamily arcs(const Polygon& subfield) {
  const Path reference{{{75, 0}, {0, 75}, 1 / 75.0}, {{0, 75}, {-75, 0}, 1 / 75.0}};
  return curved_tracks(parallel_family(reference, -7, 6, {6, kWidth}), kWidth, {EdgeIndex(Region{subfield})},
                       kCover);
}

/// Out to one side and back, 20 m long. In the family's plane.
TrackDetour detour_of(const TrackFamily& family, const Track& track, double at) {
  TrackDetour out;
  out.from = at;
  out.to = at + 20;
  const auto place = [&](double along) {
    if (track.path.empty()) return Point{family.grid.centre(track.index), along};
    return path_along(track, 0, along).back().to;
  };
  const Point from = place(out.from), to = place(out.to);
  out.path = {{from, to, 0.02}};
  out.length_m = length(out.path);
  return out;
}

Region in_field(const Path& path, const TrackFrame& frame) {
  return {{band(moved(path, [&](Point p) { return frame.to_field(p); }), kWidth, 1e-6), {}}};
}

struct Scene {
  std::vector<TrackFamily> families;
  std::vector<std::vector<Region>> worked;  ///< by family and track, in the field's frame
};

/// Every other track or so is worked, and some of them with a detour.
Scene worked_by_chance(std::vector<TrackFamily> families, WorkedGround& ground, std::mt19937_64& random) {
  std::uniform_int_distribution<int> one_in_two(0, 1), one_in_three(0, 2);
  Scene out{std::move(families), {}};
  for (std::size_t f = 0; f < out.families.size(); ++f) {
    const TrackFamily& family = out.families[f];
    out.worked.emplace_back();
    for (std::size_t k = 0; k < family.tracks.size(); ++k) {
      const Track& track = family.tracks[k];
      out.worked.back().emplace_back();
      if (one_in_two(random) == 0 || track.stretches.empty()) continue;
      TrackWork work;
      const Interval whole = track.stretches.front();
      const bool bends = one_in_three(random) == 0 && whole.length() > 30;
      if (bends) {
        work.detours.push_back(detour_of(family, track, whole.from + 5));
        work.on_track = {{whole.from, whole.from + 5}, {whole.from + 25, whole.to}};
      } else {
        work.on_track = {whole};
      }
      Region& region = out.worked.back().back();
      const auto add = [&](const Path& path) { region = unite(region, in_field(path, family.grid.frame)); };
      for (const Interval& part : work.on_track) {
        const double across = family.grid.centre(track.index);
        add(track.path.empty() ? straight_path({across, part.from}, {across, part.to})
                               : path_along(track, part.from, part.to));
      }
      for (const TrackDetour& detour : work.detours) add(detour.path);
      ground.set(f, k, std::move(work));
    }
  }
  return out;
}

TEST(WorkedGround, IsWhatPolygonBooleansFindWhateverTheFamilies) {
  const Polygon west{ring_of({-45, 55, 0, 95}), {}}, east{ring_of({0, 55, 45, 95}), {}};
  const std::uint64_t seed = std::random_device{}();
  SCOPED_TRACE(seed);
  std::mt19937_64 random(seed);
  int met = 0;
  const std::vector<std::vector<TrackFamily>> scenes{{strips_at(20, west), strips_at(110, east)},
                                                     {arcs(west), strips_at(35, east)},
                                                     {strips_at(70, west), arcs(east)},
                                                     {arcs({ring_of({-45, 55, 45, 95}), {}})}};
  for (const std::vector<TrackFamily>& families : scenes) {
    WorkedGround ground(families);
    const Scene scene = worked_by_chance(families, ground, random);
    for (int i = 0; i < 20; ++i) {
      std::uniform_real_distribution<double> x(-40, 30), y(60, 85), size(1, 12);
      const std::size_t home = i % 2 == 0 ? 0 : families.size() - 1;
      const TrackFrame& frame = families[home].grid.frame;
      const Point corner = frame.to_track(Point{x(random), y(random)});
      const Box window{corner.x, corner.y, corner.x + size(random), corner.y + size(random)};
      const std::size_t except = static_cast<std::size_t>(i) % families[home].tracks.size();

      RisingCurves curves;
      append_box(window, Layer::kBody, window, curves);
      append_box(window, Layer::kNew, window, curves);
      ground.append_covered(home, window, {window}, except, curves);
      const double left_m2 = newly_covered_area(curves);

      const Region seen = frame.to_field(Region{{ring_of(window), {}}});
      Region taken;
      for (std::size_t f = 0; f < families.size(); ++f)
        for (std::size_t k = 0; k < families[f].tracks.size(); ++k)
          if (!(f == home && k == except)) taken = unite(taken, intersection(scene.worked[f][k], seen));
      const double expected_m2 = area(seen) - area(intersection(taken, seen));
      EXPECT_NEAR(left_m2, expected_m2, 2e-3) << i;
      met += expected_m2 < area(seen) - 0.1 && expected_m2 > 0.1 ? 1 : 0;
      if (families.size() > 1 || !ground.is_alone(home, window, except)) continue;
      for (std::size_t k = 0; k < families[home].tracks.size(); ++k) {
        if (k == except) continue;
        for (const TrackDetour& detour : ground.at(home, k).detours)
          EXPECT_LT(area(intersection(in_field(detour.path, frame), seen)), 1e-6) << "it is not alone";
      }
    }
  }
  EXPECT_GT(met, 20) << "scenes that say nothing";
}

}  // namespace tramline::worked_ground_test
