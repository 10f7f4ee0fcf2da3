#pragma once
// The move 2-opt: two connections exchanged (Croes 1958).

#include "tramline/route/search/closed_tour.h"

namespace tramline::order {

/// Connects ends a and b, and what they were connected with; the part of the tour between is turned round.
class TwoOpt {
 public:
  TwoOpt(const ClosedTour& tour, End a, End b) : a_(a), b_(b), is_valid_(tour.may_exchange(a, b)) {}

  bool is_valid() const { return is_valid_; }
  /// What the tour costs less, s. Precondition: is_valid().
  double gain(const ClosedTour& tour) const;
  void apply(ClosedTour& tour) const { tour.exchange(a_, b_); }

 private:
  End a_, b_;
  bool is_valid_;
};

}  // namespace tramline::order
