#pragma once
// A tour as a ring of lines, of which local search changes connections.

#include <cstddef>
#include <vector>

#include "tramline/route/search/closed_costs.h"

namespace tramline::order {

/// A ring over the lines of the costs and the outside (ClosedCosts). Every end has one connection, to its
/// mate; the two ends of a line are in its place, and the tour enters the line by one and leaves it by the
/// other. The sense in which the ring is gone round means nothing.
class ClosedTour {
 public:
  /// Precondition: the tour has every line of the costs once.
  ClosedTour(const Tour& tour, ClosedCosts& costs);

  std::size_t lines() const { return entered_.size(); }
  std::size_t place(End end) const { return place_[line_of(end)]; }
  /// Whether the tour leaves the line by this end.
  bool is_left(End end) const { return entered_[place(end)] != end; }
  /// By which the line in a place is entered and left; places are counted round the ring.
  End entered(std::size_t place) const { return entered_[place]; }
  End left(std::size_t place) const { return other_end(entered_[place]); }
  std::size_t next(std::size_t place) const { return place + 1 == entered_.size() ? 0 : place + 1; }
  std::size_t previous(std::size_t place) const { return (place == 0 ? entered_.size() : place) - 1; }

  End mate(End end) const { return mate_[end]; }
  /// The cost of the connection to the mate.
  double mate_s(End end) const { return mate_s_[end]; }
  double between(End a, End b) const { return costs_.between(a, b); }
  End start() const { return costs_.start(); }
  End finish() const { return costs_.finish(); }

  /// Connects a with b, and what they were connected with: turns the part between round, or all the rest.
  /// O(n). Precondition: both ends are left or both are entered, and they are two.
  void exchange(End a, End b);
  /// Whether exchange() would leave one ring.
  bool may_exchange(End a, End b) const { return a != b && is_left(a) == is_left(b); }

  /// The exchanges made since the last keep(), in number, and back to an earlier number.
  std::size_t changes() const { return changes_.size(); }
  void undo_to(std::size_t changes);
  void keep() { changes_.clear(); }
  /// The ends whose connections were changed since the change of this number.
  std::vector<End> changed_since(std::size_t change) const;

  /// Without the outside, from start to finish.
  Tour open() const;

 private:
  struct Change {
    End a = 0, b = 0, mate_of_a = 0, mate_of_b = 0;  ///< as they were
  };
  void change(End a, End b);
  void turn(std::size_t first, std::size_t last);
  void connect(End a, End b);

  ClosedCosts& costs_;
  std::vector<End> entered_;        ///< by place
  std::vector<std::size_t> place_;  ///< by line
  std::vector<End> mate_;           ///< by end
  std::vector<double> mate_s_;      ///< by end
  std::vector<Change> changes_;
};

}  // namespace tramline::order
