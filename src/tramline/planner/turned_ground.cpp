#include "tramline/planner/turned_ground.h"

namespace tramline {

TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame) {
  TurnedGround out{frame.to_track(task.ground.hard),
                   frame.to_track(task.ground.passable),
                   {},
                   frame.to_track(task.ground.beyond)};
  // With a headland behind it the body's edge is soft: no straight swath that works any of the body, however
  // far its end rule lets it run on, leaves a headland of a width.
  const bool hard = task.settings.boundary == EdgeKind::kHard && task.settings.headlands == 0;
  if (hard) out.field = {{frame.to_track(task.field.outer), {}}};
  return out;
}

}  // namespace tramline
