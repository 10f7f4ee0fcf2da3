#pragma once
// What the connections between the ends of lines cost, by which orders of lines are compared.

#include <cstddef>

#include "tramline/route/order/lines.h"

namespace tramline::order {

/// Connection times between the ends of lines, s: those of one field, or those that a test makes up. Pure:
/// the same ends cost the same every time. Finite.
class EndCosts {
 public:
  EndCosts() = default;
  EndCosts(const EndCosts&) = default;
  EndCosts& operator=(const EndCosts&) = default;
  virtual ~EndCosts() = default;

  virtual std::size_t lines() const = 0;
  /// From leaving a line by one end to entering another line by the other end. Symmetric.
  virtual double between(End a, End b) const = 0;
  /// At most between(a, b), and quicker to compute where it is worth it.
  virtual double least(End a, End b) const { return between(a, b); }
  /// Before the first line, which is entered by this end: from the gate, or from what is worked before.
  virtual double at_start(End entered) const;
  /// After the last line, which is left by this end.
  virtual double at_finish(End left) const;
};

/// The sum of all connections of a tour, start and finish included, s. Precondition: the tour has every line
/// of the costs once.
double connection_s(const Tour& tour, const EndCosts& costs);

}  // namespace tramline::order
