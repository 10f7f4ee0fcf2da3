#pragma once
// The context of a search: its threads, and the callback that receives its progress and may end it.

#include <memory>

#include "tramline/planner/progress.h"

namespace tramline {

/// Passed down to everything that takes long. Copies belong to the same search: they share its progress and
/// the request to end it. Safe to use from several threads at once. It does not change what a search finds,
/// unless the progress callback ends the search, but how much of the plan is filled in (for_layout()),
/// whether a bound is proven (without_bound()), and what is told besides (without_sweep()).
class SearchContext {
 public:
  /// `threads` 0: as many as there are cores. Without a progress callback the search runs to its end.
  explicit SearchContext(int threads = 0, Progress progress = {});

  int threads() const { return threads_; }

  /// A context for one of many steps of the search that run at the same time.
  SearchContext on_one_thread() const;
  /// A context for a search within the search, whose steps are not reported to the callback.
  SearchContext uncounted() const;

  /// A context for a step that takes the part [from, to] of the whole, of 0 to 1: what it counts is told as
  /// that part, in thousandths of the whole, and never less than was told before. Steps may have steps.
  SearchContext for_part(double from, double to) const;
  /// Tells that the part so far is done, of 0 to 1 of the step. Only in a context of for_part().
  void reach(double share) const;

  /// A context for a search of whose plan only subfields and pieces are needed: it is not finished with
  /// overlaps, encounters, figures, a bound and layers.
  SearchContext for_layout() const;
  bool wants_layout_only() const { return layout_only_; }

  /// A context for a search that need not prove how near its result is to the best: it leaves out what
  /// takes long and rarely finds anything cheaper: branch and bound, and the plans of the sweep.
  SearchContext without_bound() const;
  bool wants_bound() const { return bound_; }

  /// A context for a search whose result need not list the candidates of the sweep: they are looked at only
  /// where the search needs them itself.
  SearchContext without_sweep() const;
  bool wants_sweep() const { return sweep_; }

  /// Sets how many of all steps are done and calls the callback at once.
  void count(int done, int total) const;
  /// Calls the callback with the last counts again, at most some fifty times a second and never twice at
  /// once. Everything that takes long has to call this now and then: an exception from the callback ends the
  /// search here.
  void report() const;
  /// Whether the search is to end with what it has. Reports. A caller that receives true has to skip whatever
  /// could still improve the plan.
  bool has_to_end() const;
  /// Whether has_to_end() has returned true to any caller.
  bool cut_short() const;

 private:
  class SharedProgress;
  int threads_;
  bool counts_ = true;
  bool layout_only_ = false;
  bool bound_ = true;
  bool sweep_ = true;
  bool in_parts_ = false;
  double from_ = 0, to_ = 1;                ///< of the whole
  std::shared_ptr<SharedProgress> shared_;  ///< null: there is no callback
};

}  // namespace tramline
