#pragma once
// What it takes to work the passes that are left, roughly.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline {

/// Whether no pass along the same boundary has to come before this one. Both by place in PassTask::passes.
bool has_its_turn(const PassTask& task, const std::vector<bool>& worked, std::size_t place);

/// From one lane to another so far apart, whatever the headings, m: two arcs, or two quarter circles and a
/// straight line where they are farther apart.
double lane_change_m(double apart_m, double radius_m);

/// The least time of the ways that work passes once some are worked, by dynamic programming over sets of
/// passes (Held and Karp 1962). It is an estimate: ways lead straight, whatever the land, and between passes
/// that do not lie beside one another from where they are near others or near the gate. All passes are
/// closed, and left where they were entered. Not for several threads: what was asked for is remembered.
class PassesAhead {
 public:
  /// Of more passes nothing is foreseen, and where some are open: land in which these lie may be too narrow
  /// to turn on.
  static constexpr std::size_t kMost = 8;

  /// Keeps nothing of the task. O(2^p·(p·k)²) steps for p passes and k ≤ 24 places on each.
  explicit PassesAhead(const PassTask& task);

  /// From where the last pass was left, s. `worked`: by place in PassTask::passes. 0 where nothing is
  /// foreseen. O(p²·k) for each set of passes and place that is met on the way and was not met before.
  double onward_s(const std::vector<bool>& worked, Point left) const;

  /// About the least of that once one more pass is worked, wherever that is left, s.
  double least_s(const std::vector<bool>& worked) const;

 private:
  /// Bit i stands for the pass at place i of PassTask::passes.
  using WorkedSet = std::uint32_t;
  /// Places all along a pass.
  struct ClosePlaces {
    std::vector<Point> all;
    double apart_m = 0;  ///< the next one, at most
    /// The index of the one nearest to a point, where one is nearer than this. What is far off is passed over
    /// in leaps.
    std::optional<std::size_t> nearest(Point to, double within_m) const;
  };
  static ClosePlaces close_places(const std::vector<PassEntry>& entries);
  static WorkedSet set_of(const std::vector<bool>& worked);
  double seconds(Point from, Point to) const;
  void find_places(const PassTask& task);
  void find_times(const PassTask& task);
  double between_places_s(WorkedSet worked, Point left) const;
  template <typename Beside>
  double along_neighbours_s(WorkedSet worked, Point left, const Beside& beside) const;
  double from_place_s(WorkedSet worked, std::size_t last, std::size_t place) const;
  double& at(WorkedSet worked, std::size_t node) { return from_s_[worked * nodes_ + node]; }
  double at(WorkedSet worked, std::size_t node) const { return from_s_[worked * nodes_ + node]; }

  double radius_m_;
  double near_m_;  ///< passes beside one another are nearer
  double speed_mps_;
  std::optional<Point> gate_;
  std::vector<ClosePlaces> along_{};          ///< by pass
  std::vector<std::size_t> first_along_{};    ///< by pass: the number of its first place, of those on all
  std::vector<std::vector<Point>> places_{};  ///< by pass: where it is near others, or the gate
  std::size_t nodes_ = 0;                     ///< places of all passes, numbered one pass after another
  std::vector<std::size_t> first_node_{};
  std::vector<WorkedSet> in_turn_{};  ///< by set of worked passes: those that may come next
  std::vector<double> from_s_{};      ///< by set and node, where the last pass was left
  /// By number of a place, once asked for: of every pass the place nearest to it, where one is near.
  mutable std::vector<std::vector<std::optional<std::size_t>>> beside_{};
  mutable std::unordered_map<std::uint64_t, double> from_place_s_{};  ///< by number of the place, and set
};

}  // namespace tramline
