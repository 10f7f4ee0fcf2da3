#include "tramline/planner/turned_ground.h"

namespace tramline {

TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame) {
  TurnedGround out{frame.to_track(task.ground.hard),
                   frame.to_track(task.ground.passable),
                   {},
                   frame.to_track(task.ground.beyond)};
  if (task.settings.boundary == EdgeKind::kHard) out.field = {{frame.to_track(task.field.outer), {}}};
  return out;
}

}  // namespace tramline
