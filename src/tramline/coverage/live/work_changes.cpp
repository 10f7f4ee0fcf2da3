#include "tramline/coverage/live/work_changes.h"

#include <utility>

namespace tramline::coverage {
namespace {

std::vector<TileWork> tiles_since(std::uint64_t stamp, const TileCoverage& tiles, RepeatRule repeat) {
  std::vector<TileCoverage::Change> covered = tiles.changes_since(stamp, Ground::kCovered);
  std::vector<TileCoverage::Change> repeated =
      tiles.changes_since(stamp, repeat == RepeatRule::kStrict ? Ground::kAgain : Ground::kRepeated);
  std::vector<TileWork> out;
  out.reserve(covered.size());
  for (std::size_t i = 0; i < covered.size(); ++i)
    out.push_back({covered[i].index, std::move(covered[i].ground), std::move(repeated[i].ground)});
  return out;
}

}  // namespace

WorkChanges changes_since(SeenWork& seen, const WorkedDrive& drive, RepeatRule repeat) {
  WorkChanges out;
  out.all = !seen.any;
  const TileCoverage* tiles = drive.engine().tiles();
  if (tiles != nullptr) out.tiles = tiles_since(out.all ? 0 : seen.stamp, *tiles, repeat);
  seen = {true, seen.rebuilds, tiles != nullptr ? tiles->stamp() : 0};
  return out;
}

WorkChanges changes_since(SeenWork& seen, const LiveCoverage& live, RepeatRule repeat) {
  if (seen.rebuilds != live.rebuilds()) seen = {};
  seen.rebuilds = live.rebuilds();
  if (live.drive() != nullptr) return changes_since(seen, *live.drive(), repeat);
  WorkChanges out;
  out.all = !seen.any;
  seen.any = true;
  return out;
}

}  // namespace tramline::coverage
