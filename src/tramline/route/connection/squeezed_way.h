#pragma once
// Ways where the machine has no room: along the land all the same.

#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "tramline/route/connection/connector.h"

namespace tramline {

/// Lines to follow for a machine that is narrower than in fact.
using RoadmapFor = std::function<Roadmap(const DrivingGround& narrowed)>;

/// Finds ways that leave the land as little as need be. The shortest way between two ends without room for
/// the machine may lead straight across the land of others; one on which a narrower machine has room keeps to
/// headlands and corridors, and sticks out in their bends alone. One object serves one thread.
class SqueezedWays {
 public:
  /// `connector`: that of the machine. `body`: the land of the tracks. Connector, field and land outlive
  /// the object.
  SqueezedWays(const Connector& connector, const Field& field, const Region& body, RoadmapFor roadmap_for);
  ~SqueezedWays();

  /// The way of a narrower machine from `left` to `entered`, where this one leaves the land by less on it
  /// than on `way`; or else `way`. It backs where nothing else leads along the land, as out of a spur, and
  /// only where the machine itself has room. Machines are narrowed step by step, and a towed one never: how
  /// far it swings out is not known of its width. Precondition: the way has no room.
  Way along_the_land(Way way, const SteeredPath& left, const SteeredPath& entered);

 private:
  struct Narrowed;
  enum class Backing { kNone, kAsNeeded };

  /// That of the machine that is narrowed by so many steps and one.
  const Connector& narrowed(std::size_t step);
  /// A way on which the machine leaves the land by clearly less than this.
  std::optional<Way> nearer_the_land(double missing_m, const SteeredPath& left, const SteeredPath& entered,
                                     Backing backing);

  const Connector& connector_;
  const Field& field_;
  const Region& body_;
  RoadmapFor roadmap_for_;
  std::vector<std::unique_ptr<Narrowed>> narrowed_;
};

}  // namespace tramline
