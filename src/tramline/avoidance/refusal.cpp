#include "tramline/avoidance/refusal.h"

namespace tramline {

const char* sentence(Refusal refusal) {
  switch (refusal) {
    case Refusal::kNone:
      return "";
    case Refusal::kNoRoomBetween:
      return "there is no room between the obstacles";
    case Refusal::kNotBlocked:
      return "the track's end is no obstacle's doing";
    case Refusal::kNoWayBack:
      return "no way on this side comes back to the track";
    case Refusal::kNoSide:
      return "the obstacle has no side to pass on";
    case Refusal::kEndsBefore:
      return "the track ends before a detour could";
    case Refusal::kLeavesField:
      return "it would leave the field";
    case Refusal::kPassesHardBoundary:
      return "its swath would pass the hard boundary";
    case Refusal::kEntersPassable:
      return "its swath would enter a passable obstacle";
    case Refusal::kFarTooExpensive:
      return "it would cost far more than a cut";
    case Refusal::kBesideOthers:
      return "detours beside it are in the way";
    case Refusal::kNotWorthTheWay:
      return "tracks here are not worth the way to them";
    case Refusal::kVersleijenEndsBefore:
      return "the track ends before the detour could";
    case Refusal::kTooTight:
      return "it is too tight in the middle";
    case Refusal::kNoRoomBeside:
      return "it would leave the track by more than it may";
    case Refusal::kMeetsObstacle:
      return "it would meet an obstacle";
    case Refusal::kSeveralObstacles:
      return "there are several obstacles";
    case Refusal::kTooWide:
      return "the obstacle is too wide across the track";
    case Refusal::kVersleijenOtherSide:
      return "the paper's rule passes on the other side";
  }
  return "";
}

}  // namespace tramline
