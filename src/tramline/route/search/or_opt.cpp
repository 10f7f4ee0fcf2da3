#include "tramline/route/search/or_opt.h"

#include <cassert>

namespace tramline::order {

OrOpt::OrOpt(const ClosedTour& tour, End a, std::size_t count, End b) : a_(a), b_(b) {
  assert(1 <= count && count <= kMostLinesMoved);
  if (count + 2 > tour.lines()) return;
  const bool forward = !tour.is_left(a);
  std::size_t at = tour.place(a);
  const std::size_t place_of_b = tour.place(b);
  bool has_b = place_of_b == at;
  for (std::size_t i = 1; i < count; ++i) {
    at = forward ? tour.next(at) : tour.previous(at);
    has_b = has_b || place_of_b == at;
  }
  z_ = forward ? tour.left(at) : tour.entered(at);
  is_valid_ = !has_b && b != tour.mate(a) && b != tour.mate(z_);
}

double OrOpt::gain(const ClosedTour& tour) const {
  assert(is_valid_);
  const End mate_of_a = tour.mate(a_), mate_of_z = tour.mate(z_), mate_of_b = tour.mate(b_);
  return tour.mate_s(a_) + tour.mate_s(z_) + tour.mate_s(b_) - tour.between(a_, b_) -
         tour.between(z_, mate_of_b) - tour.between(mate_of_a, mate_of_z);
}

void OrOpt::apply(ClosedTour& tour) const {
  const End mate_of_a = tour.mate(a_), mate_of_z = tour.mate(z_), mate_of_b = tour.mate(b_);
  if (tour.is_left(b_) != tour.is_left(z_)) {
    tour.exchange(z_, mate_of_b);
    tour.exchange(mate_of_a, mate_of_z);
  } else {
    tour.exchange(z_, b_);
    tour.exchange(mate_of_a, mate_of_z);
    tour.exchange(b_, a_);
  }
}

}  // namespace tramline::order
