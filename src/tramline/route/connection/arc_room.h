#pragma once
// How far arcs can be driven from poses, and up to them, before the outline leaves the land.

#include <array>
#include <cstddef>
#include <limits>
#include <optional>
#include <unordered_map>

#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/pose_key.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {

/// Room for shortest Dubins words by what is known of their first and last turns. All words that leave a pose
/// to the left begin with the same arc, driven more or less far: where one leaves the land on it, all that
/// follow it as far do. The same holds of their last turns, before a pose. So most words are ruled out
/// without a test, and before they are built. What is found is kept, so one object serves one thread.
class ArcRoom {
 public:
  /// The ground outlives the object. Preconditions: it steers at once; nothing is towed.
  explicit ArcRoom(const DrivingGround& ground) : ground_(ground) {}

  /// The first of the words, or the first few, that has room, as DrivingGround::has_room() has it; nullopt
  /// where none has. `words`: between these poses, on circles of the machine's radius.
  std::optional<SteeredPath> first_with_room(const Pose& from, const Pose& to, const DubinsWords& words,
                                             std::size_t few = std::numeric_limits<std::size_t>::max());

 private:
  /// Of arcs to one side.
  struct Known {
    double has_m = 0;                                          ///< room up to this length
    double lacks_m = std::numeric_limits<double>::infinity();  ///< and none from this one on
  };
  struct AtPose {
    std::optional<bool> on_land{};   ///< whether the outline is, in the pose
    std::array<Known, 2> leaving{};  ///< to the right, and to the left
    std::array<Known, 2> entering{};
  };

  AtPose& at(const Pose& pose);
  /// A turn on which the machine leaves a pose, or on which it enters one.
  bool has_room(const SteeredStretch& turn, std::array<Known, 2>& known) const;
  bool has_room(const SteeredPath& path, AtPose& from, AtPose& to) const;

  const DrivingGround& ground_;
  std::unordered_map<PoseKey, AtPose, PoseHash> known_;
};

}  // namespace tramline
