#pragma once
// Which elements of a machine work: work states (DDI 141) and condensed states (161-176).

#include <cstddef>
#include <optional>
#include <vector>

#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/logged_values.h"

namespace tramline::io {

/// Where the log tells the state of an element: its own, or that of what it is part of.
struct StateSource {
  enum class Kind { kWorkState, kCondensed, kAnyCondensed };
  std::size_t element = 0;  ///< logs it
  Kind kind = Kind::kWorkState;
  std::size_t place = 0;  ///< in the condensed states, from 0

  friend bool operator==(const StateSource& a, const StateSource& b) = default;
};

/// The sources of states of each element, found once. Tree and values have to outlive this.
///
/// An element works if nothing on the way from it to the root of its device says that it does not. Condensed
/// states count the sections of the element that logs them by their numbers, those of its device where it has
/// none, and row units where there are no sections; of an element without either, any state on is on. Where
/// no element on the way logs a state, that of the first other element of the tree counts for all.
class PartStates {
 public:
  PartStates(const DeviceTree& tree, const LoggedValues& values);

  /// From the element to the root. Empty: the log does not tell.
  std::vector<StateSource> sources_of(std::size_t element) const;
  /// Every one on, as far as they are known; nullopt: none is.
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
