#pragma once
// The least times of connections, from which the bound of a route is made.

#include <cstddef>
#include <vector>

namespace tramline::order {

/// Lower bounds of the times between nodes, s. Nodes 2·i and 2·i + 1 are the ends of line i; then come the
/// gates: where the route has to start, where it has to end; then rings: lines that are driven once round,
/// from any place on them back to it. A route joins every end and every gate once, and every ring twice, but
/// for those where it starts and finishes. Pure and symmetric.
class ConnectionBounds {
 public:
  ConnectionBounds() = default;
  ConnectionBounds(const ConnectionBounds&) = default;
  ConnectionBounds& operator=(const ConnectionBounds&) = default;
  virtual ~ConnectionBounds() = default;

  virtual std::size_t lines() const = 0;
  virtual std::size_t gates() const = 0;  ///< 0, 1 or 2
  virtual std::size_t rings() const { return 0; }
  /// No connection of nodes a and b takes less. Asked for nodes that may_join().
  virtual double between(std::size_t a, std::size_t b) const = 0;
  /// At most between(a, b), and quicker to compute: decides which of these need not be known.
  virtual double least(std::size_t a, std::size_t b) const = 0;

  std::size_t nodes() const { return 2 * lines() + gates() + rings(); }

  /// What a node belongs to: lines, then gates, then rings.
  std::size_t members() const { return lines() + gates() + rings(); }
  std::size_t member_of(std::size_t node) const { return node < 2 * lines() ? node / 2 : node - lines(); }
  /// The two ends of a line; the one node of anything else.
  std::vector<std::size_t> nodes_of(std::size_t member) const {
    if (member < lines()) return {2 * member, 2 * member + 1};
    return {member + lines()};
  }
  bool is_gate(std::size_t node) const { return node >= 2 * lines() && node < 2 * lines() + gates(); }
  bool is_ring(std::size_t node) const { return node >= 2 * lines() + gates(); }
  /// Nodes of two members, of which one is no gate.
  bool may_join(std::size_t a, std::size_t b) const {
    return member_of(a) != member_of(b) && !(is_gate(a) && is_gate(b));
  }
  /// How many connections a route makes there, where it neither starts nor finishes.
  std::size_t connections(std::size_t node) const { return is_ring(node) ? 2 : 1; }
};

}  // namespace tramline::order
