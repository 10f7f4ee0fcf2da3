#pragma once
// What a search is run with: threads, and whoever asked for it, who is told of its progress and may end it.

#include <memory>

#include "tramline/planner/progress.h"

namespace tramline {

/// Passed down to everything that takes long. Copies belong to the same search: they share its progress, and
/// the wish that it end. Safe to use from several threads at once. It does not change what a search finds,
/// unless the progress wants an end.
class SearchContext {
 public:
  /// `threads` 0: as many as there are cores. Without a progress nobody ends the search.
  explicit SearchContext(int threads = 0, Progress progress = {});

  int threads() const { return threads_; }

  /// For a step of the search that is one of many done at the same time.
  SearchContext on_one_thread() const;
  /// For a search within the search: its steps are not those that the progress is told of.
  SearchContext uncounted() const;

  /// So many of all steps are done: tells the progress at once.
  void count(int done, int total) const;
  /// Tells the progress the last counts again, at most some fifty times a second and never twice at once. To
  /// be called now and then by everything that takes long: what the progress throws ends the search here.
  void report() const;
  /// Is the search to end with what it has? Reports. Whoever is told so has to leave out what could still
  /// better the plan.
  bool has_to_end() const;
  /// Has has_to_end() said so to anyone?
  bool cut_short() const;

 private:
  class SharedProgress;
  int threads_;
  bool counts_ = true;
  std::shared_ptr<SharedProgress> shared_;  ///< none: nobody is to be told
};

}  // namespace tramline
