#pragma once
// What of a drive is new to somebody who follows it.

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/coverage/live/live_coverage.h"
#include "tramline/coverage/tiles/tile_frame.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline::coverage {

/// What one reader has of a drive: nothing at first.
struct SeenWork {
  bool any = false;
  std::size_t rebuilds = 0;  ///< LiveCoverage::rebuilds() then; tiles of another drive are nothing to it
  std::uint64_t stamp = 0;   ///< TileCoverage::stamp() then
};

/// Ground of one square tile, all of it; local metres. Tiles do not overlap, so that those of a reader may
/// be put side by side.
struct TileWork {
  TileIndex index;
  Region covered;
  Region repeated;
};

struct WorkChanges {
  bool all = false;  ///< what the reader had before counts no more
  std::vector<TileWork> tiles;
};

/// The tiles that changed since `seen`, which is brought up to date. A reader who puts each in the place of
/// the one of its index, and forgets all that came before one with `all`, has the drive's covered and
/// repeated ground: region() of the same, but for rounding (TileCoverage::region). Nothing with another
/// engine than the exact one. O(tiles) and O(cells) of those that changed.
WorkChanges changes_since(SeenWork& seen, const WorkedDrive& drive, RepeatRule repeat);
/// The same while the drive goes on; `all` after every rebuild.
WorkChanges changes_since(SeenWork& seen, const LiveCoverage& live, RepeatRule repeat);

}  // namespace tramline::coverage
