#include "tramline/planner/candidate/turned_ground.h"

namespace tramline {

TurnedGround turned_ground(const SearchTask& task, const TrackFrame& frame) {
  return {frame.to_track(task.ground.hard), frame.to_track(task.ground.passable),
          frame.to_track(task.hard_field), frame.to_track(task.ground.beyond)};
}

}  // namespace tramline
