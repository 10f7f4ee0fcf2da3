#pragma once
// Changes in a drive's covered land since a reader last looked.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/live/live_coverage.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// The state of a drive that one reader has seen; nothing at first.
struct SeenWork {
  bool any = false;
  /// LiveCoverage::rebuilds() at that time; after a rebuild earlier tiles are obsolete.
  std::size_t rebuilds = 0;
  std::uint64_t stamp = 0;  ///< Engine::stamp() at that time
};

struct WorkChanges {
  bool all = false;  ///< tiles that the reader received earlier are obsolete
  std::vector<TileWork> tiles;
  double grain_m = 0;  ///< Engine::grain_m()
};

/// The tiles that changed since `seen`, which is updated. A reader that replaces each tile by the new one of
/// the same index, and discards all earlier tiles when `all` is set, has the drive's covered and repeated
/// land: the same as region(), up to rounding (TileCoverage::region). O(tiles), and O(cells or meshes) of
/// those that changed.
WorkChanges changes_since(SeenWork& seen, const WorkedDrive& drive, RepeatRule repeat);
/// The same while the drive goes on; `all` after every rebuild.
WorkChanges changes_since(SeenWork& seen, const LiveCoverage& live, RepeatRule repeat);

}  // namespace tramline::coverage
