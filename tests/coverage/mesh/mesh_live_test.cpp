// The engine of meshes while the drive goes on, against the whole log at once.

#include <gtest/gtest.h>

#include <cstdlib>
#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "coverage/logs.h"
#include "coverage/random_log.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/coverage/live/live_coverage.h"
#include "tramline/coverage/live/work_changes.h"
#include "tramline/coverage/mesh/mesh_tiles.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;

const Region kField{
    {{{0, 0}, {60, 0}, {60, 25}, {30, 30}, {0, 25}}, {{{20, 8}, {20, 12}, {26, 12}, {26, 8}}}}};

struct MeshRound {
  WorkLog log;
  EvaluateSettings settings;
};

void for_mesh_rounds(int rounds, const std::function<void(const MeshRound&, std::mt19937_64&)>& look) {
  const char* told = std::getenv("TRAMLINE_SEED");
  const std::uint64_t seed = told != nullptr ? std::strtoull(told, nullptr, 10) : std::random_device{}();
  SCOPED_TRACE("TRAMLINE_SEED=" + std::to_string(seed));
  std::mt19937_64 random(seed);
  for (int i = 0; i < rounds; ++i) {
    SCOPED_TRACE(i);
    MeshRound round{random_log(random), {}};
    round.settings.engine = EngineKind::kMesh;
    round.settings.mesh_m = i % 2 == 0 ? 0.05 : 0.13;
    round.settings.drive.width_m = 5;
    if (i % 3 == 0) round.settings.repeat = RepeatRule::kStrict;
    look(round, random);
  }
}

void expect_same(const CoverageAreas& a, const CoverageAreas& b) {
  EXPECT_EQ(a.gross_m2, b.gross_m2);
  EXPECT_EQ(a.covered_m2, b.covered_m2);
  EXPECT_EQ(a.covered_inside_m2, b.covered_inside_m2);
  EXPECT_EQ(a.outside_m2, b.outside_m2);
  EXPECT_EQ(a.repeated_m2, b.repeated_m2);
  EXPECT_EQ(a.sliver_m2, b.sliver_m2);
  EXPECT_EQ(a.missed_m2, b.missed_m2);
  EXPECT_EQ(a.not_recorded_m2, b.not_recorded_m2);
  EXPECT_EQ(a.worked_times_m2[0], b.worked_times_m2[0]);
  EXPECT_EQ(a.worked_times_m2[1], b.worked_times_m2[1]);
}

// Areas are whole numbers of meshes: they are the same to the last digit, after every fix.
TEST(MeshLive, IsTheWholeLogAtOnce) {
  std::size_t compared = 0;
  for_mesh_rounds(30, [&](const MeshRound& round, std::mt19937_64&) {
    const auto& [log, settings] = round;
    LiveCoverage live(kField, settings);
    for (std::size_t i = 0; i < log.fixes.size(); ++i) {
      live.add(log.fixes[i], log.booms);
      const bool last = i + 1 == log.fixes.size();
      if (i < 1 || (i % 29 != 0 && !last)) continue;
      live.settle();
      WorkLog so_far = log;
      so_far.fixes.resize(i + 1);
      const Coverage whole = evaluate(so_far, kField, settings, {});
      const Coverage now = live.figures(so_far);
      expect_same(live.areas(), whole.areas);
      expect_same(now.areas, whole.areas);
      ASSERT_TRUE(now.meshes && whole.meshes);
      EXPECT_EQ(now.meshes->covered.now, whole.meshes->covered.now);
      EXPECT_EQ(now.meshes->covered.most, whole.meshes->covered.most);
      EXPECT_EQ(now.meshes->missed.now, whole.meshes->missed.now);
      EXPECT_EQ(now.meshes->missed.most, whole.meshes->missed.most);
      EXPECT_GE(whole.meshes->missed.most, whole.meshes->missed.now);
      ++compared;
      if (!last) continue;
      const Coverage end = live.coverage(so_far);
      EXPECT_EQ(end.covered, whole.covered);
      EXPECT_EQ(end.repeated, whole.repeated);
      EXPECT_EQ(end.missed, whole.missed);
    }
  });
  EXPECT_GT(compared, 60U);
}

// However seldom somebody asks, the tiles that changed add up to the whole of it.
TEST(MeshLive, WhoFollowsTheTilesHasAllLand) {
  for_mesh_rounds(12, [&](const MeshRound& round, std::mt19937_64& random) {
    const auto& [log, settings] = round;
    LiveCoverage live(kField, settings);
    SeenWork seen;
    std::map<TileIndex, TileWork> tiles;
    std::size_t sent = 0, frames = 0, afresh = 0;
    for (std::size_t i = 0; i < log.fixes.size(); ++i) {
      live.add(log.fixes[i], log.booms);
      const bool last = i + 1 == log.fixes.size();
      if (last) live.settle();
      if (!last && !std::bernoulli_distribution(0.3)(random)) continue;
      WorkChanges changes = changes_since(seen, live, settings.repeat);
      if (changes.all) tiles.clear();
      afresh += changes.all ? 1 : 0;
      EXPECT_EQ(changes.grain_m, live.drive() == nullptr ? 0 : settings.mesh_m);
      sent += changes.tiles.size();
      ++frames;
      for (TileWork& tile : changes.tiles) tiles.insert_or_assign(tile.index, std::move(tile));
      double covered_m2 = 0, repeated_m2 = 0;
      for (const auto& [index, tile] : tiles) {
        covered_m2 += area(tile.covered);
        repeated_m2 += area(tile.repeated);
      }
      ASSERT_NEAR(covered_m2, live.areas().covered_m2, 1e-6);
      ASSERT_NEAR(repeated_m2, live.areas().repeated_m2, 1e-6);
    }
    EXPECT_TRUE(changes_since(seen, live, settings.repeat).tiles.empty());
    if (frames > 20 && afresh == 1) {
      EXPECT_LT(sent, frames * tiles.size() / 2) << "frames have all tiles, not what changed";
    }
  });
}

TEST(MeshTiles, ByHand) {
  MeshTiles tiles(10);
  const MeshRegion box = mesh_region({{{-5, -5}, {25, -5}, {25, 5}, {-5, 5}}}, 1);
  EXPECT_TRUE(tiles.changed_since(0).empty());
  tiles.touch(box);
  tiles.end_step();
  // An edge along the grid lies in the meshes above or to the right of it, so that the box holds the corners
  // from -4 to 25 and from -4 to 5: columns -1 to 2, rows -1 and 0.
  EXPECT_EQ(tiles.changed_since(0).size(), 8U);
  EXPECT_TRUE(tiles.changed_since(tiles.stamp()).empty());
  EXPECT_EQ(tiles.part(box, {-1, -1}).corners_inside(), 4 * 4);
  EXPECT_EQ(tiles.part(box, {0, 0}).corners_inside(), 10 * 6);
  EXPECT_EQ(tiles.part(box, {2, 0}).corners_inside(), 6 * 6);
  EXPECT_EQ(tiles.part(box, {3, 0}).corners_inside(), 0);
  const std::uint64_t before = tiles.stamp();
  tiles.end_step();
  EXPECT_EQ(tiles.stamp(), before) << "nothing was touched";
  tiles.touch(mesh_region({{{2, 2}, {4, 2}, {4, 4}, {2, 4}}}, 1));
  tiles.end_step();
  EXPECT_EQ(tiles.changed_since(before), (std::vector<TileIndex>{{0, 0}}));
}

}  // namespace
}  // namespace tramline::coverage
