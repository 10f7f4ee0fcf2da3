#pragma once
// The move Or-opt: a few lines driven one after the other are moved elsewhere (Or 1976).

#include <cstddef>

#include "tramline/route/search/closed_tour.h"

namespace tramline::order {

/// The most lines that are moved together.
inline constexpr std::size_t kMostLinesMoved = 3;

/// Takes the run of `count` lines that ends with end a out of the tour and puts it between end b and the mate
/// of b, so that a and b are connected; so the run is turned round or not, as b asks.
class OrOpt {
 public:
  /// Precondition: 1 ≤ count ≤ kMostLinesMoved.
  OrOpt(const ClosedTour& tour, End a, std::size_t count, End b);

  /// Whether b and its mate are outside of the run, and some line is left where it was taken out.
  bool is_valid() const { return is_valid_; }
  /// What the tour costs less, s. Precondition: is_valid().
  double gain(const ClosedTour& tour) const;
  void apply(ClosedTour& tour) const;

 private:
  End a_, b_;
  End z_ = 0;  ///< the other end of the run
  bool is_valid_ = false;
};

}  // namespace tramline::order
