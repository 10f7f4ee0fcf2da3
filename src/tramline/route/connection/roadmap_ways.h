#pragma once
// The ways between poses of a roadmap that have room.

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tramline/route/connection/arc_room.h"
#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/roadmap.h"

namespace tramline {

/// Ways are found when they are first asked for, and kept: searches over one roadmap meet the same ones again
/// and again. So one object serves one thread.
class RoadmapWays {
 public:
  /// The ground outlives the object.
  RoadmapWays(Roadmap roadmap, const DrivingGround& ground);

  const Roadmap& roadmap() const { return roadmap_; }
  /// Words up to this distance lead to lines of the roadmap, m.
  double reach_m() const { return reach_m_; }

  /// A shortest Dubins word to a pose of another line.
  struct Change {
    std::size_t to = 0;
    double length_m = 0;
  };
  /// The words from a pose to poses of other lines ahead of it that lead on, whether they have room or not.
  const std::vector<Change>& changes(std::size_t pose);

  /// A way with room.
  struct Way {
    SteeredPath path;
    double cost_s = 0;  ///< cost_seconds()
  };
  /// The first word with room of a change; null where none has. Valid until the next call.
  const Way* change(std::size_t from, std::size_t to);
  /// The first word with room between any two poses; null where none has. Valid until the next call.
  const Way* word(const Pose& from, const Pose& to);
  /// The way along the line to the pose that follows; null where it has no room. Valid until the next call.
  const Way* along(std::size_t pose);

 private:
  /// Of the words that lead on; or, between any poses, of all.
  enum class Words { kLeadOn, kAll };
  std::optional<Way> first_with_room(const Pose& from, const Pose& to, Words words);

  /// x, y and heading of two poses.
  using PosePair = std::array<double, 6>;
  struct PosePairHash {
    std::size_t operator()(const PosePair& pair) const;
  };

  Roadmap roadmap_;
  const DrivingGround& ground_;
  double reach_m_;
  std::optional<ArcRoom> arc_room_{};  ///< where the machine steers at once and tows nothing
  std::vector<std::optional<std::vector<Change>>> changes_;
  std::unordered_map<std::uint64_t, std::optional<Way>> by_change_;
  std::unordered_map<std::size_t, std::optional<Way>> along_;
  std::unordered_map<PosePair, std::optional<Way>, PosePairHash> by_word_;
};

/// The ways of a roadmap that is built when it is first asked for: most fields do without. One object serves
/// one thread.
class RoadmapOnDemand {
 public:
  RoadmapOnDemand(std::function<Roadmap()> build, const DrivingGround& ground)
      : build_(std::move(build)), ground_(ground) {}
  RoadmapWays& get() {
    if (!ways_) ways_.emplace(build_(), ground_);
    return *ways_;
  }

 private:
  std::function<Roadmap()> build_;
  const DrivingGround& ground_;
  std::optional<RoadmapWays> ways_{};
};

}  // namespace tramline
