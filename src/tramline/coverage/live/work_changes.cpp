#include "tramline/coverage/live/work_changes.h"

namespace tramline::coverage {

WorkChanges changes_since(SeenWork& seen, const WorkedDrive& drive, RepeatRule repeat) {
  WorkChanges out;
  out.all = !seen.any;
  const Engine& engine = drive.engine();
  out.tiles = engine.tiles_since(out.all ? 0 : seen.stamp, repeat);
  out.grain_m = engine.grain_m();
  seen = {true, seen.rebuilds, engine.stamp()};
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
