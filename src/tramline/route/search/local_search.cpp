#include "tramline/route/search/local_search.h"

#include "tramline/route/search/or_opt.h"
#include "tramline/route/search/two_opt.h"
#include "tramline/route/tolerances.h"

namespace tramline::order {
namespace {

/// Moves that connect two ends, of all kinds.
class MovesAbout {
 public:
  explicit MovesAbout(ClosedTour& tour) : tour_(tour) {}

  void look_at(End a, End b) {
    const TwoOpt exchange(tour_, a, b);
    if (exchange.is_valid()) {
      const double gain = exchange.gain(tour_);
      if (gain > gain_) {
        gain_ = gain;
        run_ = 0;
        a_ = a;
        b_ = b;
      }
    }
    for (std::size_t count = 1; count <= kMostLinesMoved; ++count) {
      look_at_run(a, count, b);
      look_at_run(b, count, a);
    }
  }

  /// What the best of them gained, s; 0 if none gains.
  double apply_best() {
    if (gain_ <= kSameTime_s) return 0;
    if (run_ == 0)
      TwoOpt(tour_, a_, b_).apply(tour_);
    else
      OrOpt(tour_, a_, run_, b_).apply(tour_);
    return gain_;
  }

 private:
  void look_at_run(End a, std::size_t count, End b) {
    const OrOpt move(tour_, a, count, b);
    if (!move.is_valid()) return;
    const double gain = move.gain(tour_);
    if (gain <= gain_) return;
    gain_ = gain;
    run_ = count;
    a_ = a;
    b_ = b;
  }

  ClosedTour& tour_;
  double gain_ = kSameTime_s;
  std::size_t run_ = 0;  ///< lines moved; 0: an exchange
  End a_ = 0, b_ = 0;
};

}  // namespace

LocalSearch::LocalSearch(ClosedTour& tour, const Neighbours& neighbours)
    : tour_(tour), neighbours_(neighbours), chain_(tour, neighbours), waits_(tour.lines(), false) {}

void LocalSearch::wait(End end) {
  if (waits_[line_of(end)]) return;
  waits_[line_of(end)] = true;
  waiting_.push_back(line_of(end));
}

double LocalSearch::run() {
  double gained = 0;
  for (std::size_t next = 0; next < waiting_.size(); ++next) {
    const std::size_t line = waiting_[next];
    waits_[line] = false;
    for (const End end : {2 * line, 2 * line + 1})
      while (const double gain = improve_at(end)) gained += gain;
  }
  waiting_.clear();
  return gained;
}

/// One move or chain that gains, and its gain, s; 0 if there is none.
double LocalSearch::improve_at(End end) {
  const std::size_t changes = tour_.changes();
  double gain = best_move(end);
  if (gain == 0) gain = chain_.improve(end);
  if (gain > 0)
    for (const End changed : tour_.changed_since(changes)) wait(changed);
  return gain;
}

double LocalSearch::best_move(End end) {
  MovesAbout moves(tour_);
  for (const End near : neighbours_[end]) {
    if (tour_.between(end, near) >= tour_.mate_s(end)) break;
    moves.look_at(end, near);
  }
  for (const End outside : {tour_.start(), tour_.finish()})
    if (line_of(end) != line_of(outside) && tour_.between(end, outside) < tour_.mate_s(end))
      moves.look_at(end, outside);
  return moves.apply_best();
}

}  // namespace tramline::order
