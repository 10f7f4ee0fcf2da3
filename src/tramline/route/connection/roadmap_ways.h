#pragma once
// The ways between poses of a roadmap that have room.

#include <cstddef>
#include <deque>
#include <functional>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tramline/route/connection/arc_room.h"
#include "tramline/route/connection/driving_ground.h"
#include "tramline/route/connection/pose_key.h"
#include "tramline/route/connection/roadmap.h"
#include "tramline/route/connection/unreachable.h"

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

  /// Words to a pose from others of the roadmap are no longer, m.
  double longest_word_m() const;

  /// A way with room. Those that are given out stay where they are.
  struct Way {
    SteeredPath path;
    double cost_s = 0;  ///< cost_seconds()
  };

  /// Dubins words to a pose of the roadmap, of which the shortest has a length.
  struct Word {
    std::size_t to = 0;
    double length_m = 0;
    bool looked = false;       ///< for one that has room
    const Way* way = nullptr;  ///< null where none has
  };
  /// The shortest words from a pose to poses of other lines ahead of it that lead on.
  std::vector<Word>& changes(std::size_t pose);
  /// The words from any pose to those of the roadmap within reach that are no longer than longest_word_m().
  std::vector<Word>& words_from(const Pose& pose);
  /// Looks for the way of one of changes(), if it has room.
  const Way* change(std::size_t from, Word& word);
  /// The first with room of words_from() to a pose.
  const Way* word(const Pose& from, Word& word);
  /// The first word with room between any two poses; null where none has.
  const Way* word(const Pose& from, const Pose& to);
  /// The way along the line to the pose that follows; null where it has no room.
  const Way* along(std::size_t pose);

  /// Whether a word of no more than longest_word_m() with room leads from any pose of the roadmap to this
  /// one.
  bool is_entered(const Pose& end);
  /// What searches over this roadmap have found to lead nowhere.
  Unreachable& unreachable() { return unreachable_; }

  /// How many poses all searches over this roadmap have reached: what they took, on any machine.
  std::size_t reached() const { return reached_; }
  void count_reached() { ++reached_; }

 private:
  /// Of the words that lead on; or, between any poses, of all.
  enum class Words { kLeadOn, kAll };
  std::optional<Way> way_along(const RoadmapPose& from) const;
  std::optional<Way> first_with_room(const Pose& from, const Pose& to, Words words);
  const Way* looked_for(const Pose& from, Word& word, Words words);

  Roadmap roadmap_;
  const DrivingGround& ground_;
  double reach_m_;
  std::optional<ArcRoom> arc_room_{};  ///< where the machine steers at once and tows nothing
  /// Once it was looked for: a way, or none.
  using Found = std::optional<std::optional<Way>>;
  std::vector<std::optional<std::vector<Word>>> changes_;
  std::unordered_map<PoseKey, std::vector<Word>, PoseHash> words_from_{};
  std::deque<Way> ways_{};  ///< of words from the roadmap and to it
  std::vector<Found> along_;
  std::unordered_map<PosePairKey, std::optional<Way>, PoseHash> by_word_{};
  std::unordered_map<PoseKey, bool, PoseHash> entered_{};
  Unreachable unreachable_;
  std::size_t reached_ = 0;
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
  /// RoadmapWays::reached(); 0 where none was asked for.
  std::size_t reached() const { return ways_ ? ways_->reached() : 0; }

 private:
  std::function<Roadmap()> build_;
  const DrivingGround& ground_;
  std::optional<RoadmapWays> ways_{};
};

}  // namespace tramline
