#pragma once
// The elements of the machines of a time log as a tree.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "tramline/io/isoxml/task_data.h"

namespace tramline::io {

/// Kinds of device elements (ISO 11783-10, DET@C).
namespace element_kind {
inline constexpr unsigned kDevice = 1, kFunction = 2, kBin = 3, kSection = 4, kUnit = 5, kConnector = 6,
                          kNavigation = 7;
}

/// A section or a unit of one: a part of the working width.
bool is_small_part(const DeviceElement& element);

/// Elements by their indices in a list, with their parents and children. An element whose parent is missing
/// is a root; so is one element of each cycle of parents, and any element nested deeper than in any real
/// machine.
class DeviceTree {
 public:
  DeviceTree() = default;
  /// `elements`: of one device or of several; object ids count within a device. O(n log n).
  explicit DeviceTree(std::vector<DeviceElement> elements);

  std::size_t size() const { return elements_.size(); }
  const DeviceElement& operator[](std::size_t i) const { return elements_[i]; }
  std::optional<std::size_t> parent(std::size_t i) const { return parents_[i]; }
  /// The children in the order of their numbers.
  const std::vector<std::size_t>& children(std::size_t i) const { return children_[i]; }
  /// The roots of each device, by their numbers, device by device in the order given.
  const std::vector<std::vector<std::size_t>>& devices() const { return devices_; }
  /// The element itself, its parent and so on.
  std::vector<std::size_t> path_to_root(std::size_t i) const;
  bool is_within(std::size_t i, std::size_t ancestor) const;

 private:
  void cut_circles();
  void sort_by_number(std::vector<std::size_t>& places) const;

  std::vector<DeviceElement> elements_;
  std::vector<std::optional<std::size_t>> parents_;
  std::vector<std::vector<std::size_t>> children_;
  std::vector<std::vector<std::size_t>> devices_;
};

}  // namespace tramline::io
