#include "tramline/route/search/three_opt.h"

#include <cassert>

namespace tramline::order {

ThreeOpt::ThreeOpt(const ClosedTour& tour, End a, End b, End c)
    : a_(a), b_(b), c_(c), mate_of_a_(tour.mate(a)), mate_of_b_(tour.mate(b)), mate_of_c_(tour.mate(c)) {
  if (b == a || b == mate_of_a_ || c == a || c == mate_of_a_ || c == b || c == mate_of_b_) return;
  // As the tour is driven when it leaves a for the mate of a: lines after that mate.
  const bool forward = tour.is_left(a);
  const auto lines_after = [&](End end) {
    const std::size_t from = tour.place(mate_of_a_), to = tour.place(end);
    return forward ? (to >= from ? to - from : to + tour.lines() - from)
                   : (from >= to ? from - to : from + tour.lines() - to);
  };
  const bool leaves_by_b = tour.is_left(b) == forward, leaves_by_c = tour.is_left(c) == forward;
  if (leaves_by_b) {
    // Connecting the mate of a with b would close a ring of the run between them; c has to be in it.
    const std::size_t last = lines_after(b);
    is_valid_ = lines_after(c) <= last && lines_after(mate_of_c_) <= last;
  } else {
    // The run from the mate of a to the mate of b is turned round.
    const bool turned = lines_after(c) <= lines_after(mate_of_b_);
    is_valid_ = turned == leaves_by_c;
  }
}

double ThreeOpt::gain(const ClosedTour& tour) const {
  assert(is_valid_);
  return tour.mate_s(a_) + tour.mate_s(b_) + tour.mate_s(c_) - tour.between(mate_of_a_, b_) -
         tour.between(mate_of_b_, c_) - tour.between(mate_of_c_, a_);
}

void ThreeOpt::apply(ClosedTour& tour) const {
  assert(is_valid_);
  const bool leaves_by_b = tour.is_left(b_) == tour.is_left(a_);
  const bool leaves_by_c = tour.is_left(c_) == tour.is_left(a_);
  if (!leaves_by_b) {
    tour.exchange(mate_of_a_, b_);
    tour.exchange(mate_of_b_, c_);
  } else if (leaves_by_c) {  // two runs change places: both turned round together, then each
    tour.exchange(a_, b_);
    tour.exchange(a_, mate_of_c_);
    tour.exchange(b_, mate_of_a_);
  } else {
    tour.exchange(a_, mate_of_c_);
    tour.exchange(mate_of_a_, b_);
  }
}

}  // namespace tramline::order
