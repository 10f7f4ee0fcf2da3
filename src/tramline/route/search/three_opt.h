#pragma once
// The move 3-opt: three connections exchanged (Lin 1965).

#include <cstddef>

#include "tramline/route/search/closed_tour.h"

namespace tramline::order {

/// Takes away the connections of ends a, b and c, and connects the mate of a with b, the mate of b with c,
/// and the mate of c with a: a run of lines of any length is moved elsewhere, turned round or not (Or-opt, of
/// Or 1976), or two runs are turned round where they are.
class ThreeOpt {
 public:
  ThreeOpt(const ClosedTour& tour, End a, End b, End c);

  /// Whether the connections are three and what results is one ring.
  bool is_valid() const { return is_valid_; }
  /// What the tour costs less, s. Precondition: is_valid().
  double gain(const ClosedTour& tour) const;
  /// Precondition: is_valid().
  void apply(ClosedTour& tour) const;

 private:
  End a_, b_, c_;
  End mate_of_a_, mate_of_b_, mate_of_c_;
  bool is_valid_ = false;
};

}  // namespace tramline::order
