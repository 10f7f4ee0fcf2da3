#pragma once
// How a search is stopped: whoever asked for it is called again and again, and may throw, or want an end.

#include <atomic>
#include <cstdint>
#include <mutex>

#include "tramline/planner/progress.h"

namespace tramline {

/// While it lives, beat() on its thread, and on those that work for it in for_each_index(), calls the
/// progress with the last counts, at most some fifty times a second and never twice at once. What the
/// progress throws ends the search. It does not change what a search finds. The progress has to be alive as
/// long.
class Pulse {
 public:
  explicit Pulse(const Progress& progress);
  Pulse(const Pulse&) = delete;
  Pulse& operator=(const Pulse&) = delete;
  ~Pulse();

  /// To be given to searches in place of the progress: passes on counts at once, and remembers them.
  Progress counter();
  /// Has something been left out because the progress wanted an end?
  bool cut_short() const { return cut_short_; }

 private:
  friend void beat();
  friend bool has_to_end();
  Demand count(int done, int total);
  void call();
  void call_if_due();

  const Progress& progress_;
  Pulse* outer_;
  std::mutex mutex_;
  std::atomic<std::int64_t> due_ns_ = 0;
  int done_ = 0, total_ = 0;
  std::atomic<bool> ending_ = false, cut_short_ = false;
};

/// Called now and then by everything that takes long.
void beat();

/// Is the search to end with what it has? Beats. Whoever is told so has to leave out what could still better
/// the plan.
bool has_to_end();

/// The pulse of a thread, for another one that works for it.
class PulseOfThread {
 public:
  PulseOfThread();

  /// Makes it the pulse of this thread while the object lives.
  class Borrowed {
   public:
    explicit Borrowed(const PulseOfThread& lender);
    Borrowed(const Borrowed&) = delete;
    Borrowed& operator=(const Borrowed&) = delete;
    ~Borrowed();

   private:
    Pulse* before_;
  };

 private:
  Pulse* pulse_;
};

}  // namespace tramline
