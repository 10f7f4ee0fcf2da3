#pragma once
// The headland pass that comes next.

#include <cstddef>
#include <map>
#include <optional>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/passes/nearest_entries.h"
#include "tramline/route/passes/passes_ahead.h"
#include "tramline/route/passes/worked_pass.h"

namespace tramline {

/// Whether a choice counts what lies ahead once it is worked (PassesAhead), or is the nearest.
enum class Foresight { kAhead, kNone };

/// Chooses of the passes of a task that are not worked yet, and whose turn it is, the one that takes least,
/// and where to enter it. Not for several threads.
class NextPass {
 public:
  /// Nothing is worked yet. What the task refers to outlives the object.
  explicit NextPass(const PassTask& task, Foresight foresight = Foresight::kAhead);

  /// From now on this pass is worked, by its index into Headland::passes. Precondition: it is one of the
  /// task.
  void work(std::size_t pass);

  /// Where nothing came before: the outermost pass, or the innermost where passes go outwards, from its
  /// beginning. Precondition of all that follow: some pass is not worked.
  WorkedPass first() const;

  struct Chosen {
    WorkedPass pass;
    double more_s = 0;  ///< what lies ahead of it takes, more than the least that may
  };
  /// From where the route is (the way of the axle up to there). Of the direct ways with room the one that
  /// takes least with what lies ahead; where none of those to the nearest entries has any, the way of least
  /// cost to one of these. O(e) for e entries, besides the ways. Precondition: `left` is not empty.
  Chosen after(const SteeredPath& left) const;

  /// About what the way from a pose takes, and `more_s` of the choice it leads to: the least of all choices,
  /// as the straight line to them is long. O(e) at most; entries that are far off are passed over in leaps.
  double about_s(const Pose& left) const;

 private:
  /// What may be entered next, with what lies ahead of it more than the least that may, s, once it was asked
  /// for.
  struct Choices {
    /// Entries of one pass in one sense, which follow one another along it.
    struct Run {
      std::size_t first = 0, end = 0;  ///< places in `all`
      double apart_m = 0;              ///< from one to the next, at most
    };
    std::vector<EntryChoice> all{};
    std::vector<Run> runs{};
    double least_s = 0;
    mutable std::vector<std::optional<double>> more_s{};
  };
  std::vector<bool> worked_with(std::size_t pass) const;
  const Choices& choices() const;
  static void add(const PassEntry& entry, std::size_t pass, Choices& choices);
  double more_s(const Choices& choices, std::size_t i) const;
  template <typename Enough, typename Meet>
  void meet_sooner(const Pose& left, const Choices& choices, const Enough& enough_s, const Meet& meet) const;
  Chosen by_search(const SteeredPath& left, NearestEntries& nearest, const Choices& choices) const;
  Chosen to_any(const SteeredPath& left, const Choices& choices, const std::vector<std::size_t>& some) const;

  PassTask task_;
  std::optional<PassesAhead> ahead_{};
  std::vector<bool> worked_;                                ///< by place in PassTask::passes
  mutable std::map<std::vector<bool>, Choices> choices_{};  ///< by what is worked
};

}  // namespace tramline
