#include "tramline/route/search/double_bridge.h"

#include <algorithm>
#include <cassert>

namespace tramline::order {

bool DoubleBridge::is_valid(const ClosedTour& tour) const {
  return *std::min_element(counts_.begin(), counts_.end()) > 0 &&
         counts_[0] + counts_[1] + counts_[2] < tour.lines();
}

DoubleBridge::Ends DoubleBridge::ends(const ClosedTour& tour) const {
  assert(is_valid(tour));
  const auto place_after = [&](std::size_t lines) { return (place_ + lines) % tour.lines(); };
  const std::size_t b = place_after(0), c = place_after(counts_[0]);
  const std::size_t d = place_after(counts_[0] + counts_[1]);
  const std::size_t a = place_after(counts_[0] + counts_[1] + counts_[2]);
  const auto left_before = [&](std::size_t place) { return tour.left(tour.previous(place)); };
  return {left_before(b), tour.entered(b), left_before(c), tour.entered(c),
          left_before(d), tour.entered(d), left_before(a), tour.entered(a)};
}

double DoubleBridge::gain(const ClosedTour& tour) const {
  const Ends at = ends(tour);
  return tour.mate_s(at.before) + tour.mate_s(at.b_last) + tour.mate_s(at.c_last) + tour.mate_s(at.d_last) -
         tour.between(at.before, at.d_first) - tour.between(at.d_last, at.c_first) -
         tour.between(at.c_last, at.b_first) - tour.between(at.b_last, at.after);
}

void DoubleBridge::apply(ClosedTour& tour) const {
  const Ends at = ends(tour);
  tour.exchange(at.before, at.d_last);   // all three turned round together: D C B, each the wrong way
  tour.exchange(at.before, at.d_first);  // then one by one
  tour.exchange(at.d_last, at.c_first);
  tour.exchange(at.c_last, at.b_first);
}

}  // namespace tramline::order
