#pragma once
// What searches for ways have found to lead nowhere.

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/connection/pose_key.h"

namespace tramline {

/// From which poses of a roadmap no way leads to an end. A search that fails goes through all that can be
/// reached from where it begins; where others begin there, it need not be gone through again. For one thread.
class Unreachable {
 public:
  /// By pose of the roadmap: 1 where no way leads on, 0 where one may.
  using From = std::vector<unsigned char>;

  explicit Unreachable(std::size_t poses) : poses_(poses) {}

  /// From where no way leads to the end; null where nothing is known of it. Stays where it is, and learns.
  const From* to(const Pose& end) const;
  /// From where no way leads to any of the ends. O(ends · poses).
  From to_any(const std::vector<Pose>& ends) const;
  /// From these no way leads to the end, besides those known already. Precondition: one number a pose.
  void add(const Pose& end, const From& nowhere);
  /// From nowhere on the roadmap a way leads to the end.
  void add_all(const Pose& end) { add(end, From(poses_, 1)); }

 private:
  std::size_t poses_;
  std::unordered_map<PoseKey, From, PoseHash> to_end_{};
};

}  // namespace tramline
