#include "tramline/route/search/two_opt.h"

#include <cassert>

namespace tramline::order {

double TwoOpt::gain(const ClosedTour& tour) const {
  assert(is_valid_);
  return tour.mate_s(a_) + tour.mate_s(b_) - tour.between(a_, b_) -
         tour.between(tour.mate(a_), tour.mate(b_));
}

}  // namespace tramline::order
