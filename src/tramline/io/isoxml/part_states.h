#pragma once
// The states of the elements of a machine: work states (DDI 141) and condensed states (161-176).

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/logged_values.h"

namespace tramline::io {

/// A source of the state of an element in the log: its own state, or that of an element it is part of.
struct StateSource {
  enum class Kind { kWorkState, kCondensed, kAnyCondensed };
  std::size_t element = 0;  ///< the element for which it is logged
  Kind kind = Kind::kWorkState;
  std::size_t place = 0;  ///< index in the condensed states, from 0

  friend bool operator==(const StateSource& a, const StateSource& b) = default;
};

/// The sources of states of each element, found once. Tree and values have to outlive this.
/// An element works unless a source on the way from it to the root of its device says that it does not.
/// Condensed states refer, in the order of their numbers, to the sections of the element they are logged for,
/// or to those of its device where it has none, or to row units where there are no sections; for an element
/// without either, any state that is on counts as on. Where no element on the way has a logged state, that of
/// the first other element of the tree applies to all.
class PartStates {
 public:
  PartStates(const DeviceTree& tree, const LoggedValues& values);

  /// The sources from the element to the root. Empty: the log has none.
  std::vector<StateSource> sources_of(std::size_t element) const;
  /// Whether all known states of the sources are on; nullopt: none is known.
  std::optional<bool> state(const std::vector<StateSource>& sources) const;

 private:
  struct Condensed {
    std::size_t element = 0;
    std::vector<std::size_t> numbered;
  };

  std::vector<std::size_t> numbered(std::size_t element) const;
  std::optional<bool> state(const StateSource& source) const;

  const DeviceTree& tree_;
  const LoggedValues& values_;
  std::vector<Condensed> condensed_;
};

}  // namespace tramline::io
