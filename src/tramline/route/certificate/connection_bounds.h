#pragma once
// The least times of connections, from which the bound of a route is made.

#include <cstddef>

namespace tramline::order {

/// Lower bounds of the times between nodes, s. Nodes 2·i and 2·i + 1 are the ends of line i; then come the
/// gates: where the route has to start, where it has to end. Pure and symmetric.
class ConnectionBounds {
 public:
  ConnectionBounds() = default;
  ConnectionBounds(const ConnectionBounds&) = default;
  ConnectionBounds& operator=(const ConnectionBounds&) = default;
  virtual ~ConnectionBounds() = default;

  virtual std::size_t lines() const = 0;  ///< at least one
  virtual std::size_t gates() const = 0;  ///< 0, 1 or 2
  /// No connection of nodes a and b takes less. Asked for nodes of two lines, or of a line and a gate: two
  /// gates are never joined.
  virtual double between(std::size_t a, std::size_t b) const = 0;
  /// At most between(a, b), and quicker to compute: decides which of these need not be known.
  virtual double least(std::size_t a, std::size_t b) const = 0;

  std::size_t nodes() const { return 2 * lines() + gates(); }
};

}  // namespace tramline::order
