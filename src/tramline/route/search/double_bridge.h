#pragma once
// The kick: four connections changed in a way that exchanges do not undo (Martin, Otto and Felten 1991).

#include <array>
#include <cstddef>

#include "tramline/route/search/closed_tour.h"

namespace tramline::order {

/// Three runs of lines that follow one another, driven in the opposite order and none turned round: of A B C
/// D the tour becomes A D C B.
class DoubleBridge {
 public:
  /// Of the ring from `place` on the runs B, C and D, `counts` lines long.
  DoubleBridge(std::size_t place, const std::array<std::size_t, 3>& counts)
      : place_(place), counts_(counts) {}

  /// Whether each run has a line and one at least is in none.
  bool is_valid(const ClosedTour& tour) const;
  /// What the tour costs less, s; mostly it costs more. Precondition: is_valid().
  double gain(const ClosedTour& tour) const;
  /// Proportional to the lines of the runs. Precondition: is_valid().
  void apply(ClosedTour& tour) const;

 private:
  /// The ends of the runs, and those before and after them, as the tour drives them.
  struct Ends {
    End before, b_first, b_last, c_first, c_last, d_first, d_last, after;
  };
  Ends ends(const ClosedTour& tour) const;

  std::size_t place_;
  std::array<std::size_t, 3> counts_;
};

}  // namespace tramline::order
