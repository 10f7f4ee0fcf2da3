#pragma once
// The stretches across the machine that its elements work, from logged or described widths and offsets.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "tramline/io/isoxml/device_tree.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// An element without parts of its own, and the stretch across the machine that it works.
struct WorkingPart {
  std::size_t element = 0;  ///< in the tree
  Section place;
};

/// Access to the values of the elements of a tree at one time.
struct ElementValues {
  /// The value as logged, or failing that as described.
  std::function<std::optional<std::int64_t>(std::size_t element, unsigned ddi)> value;
  /// Whether the log has the width of the element itself by now.
  std::function<bool(std::size_t element)> width_logged;
  /// Whether the log has widths or states of parts of the element.
  std::function<bool(std::size_t element)> parts_logged;
};

/// The parts of all devices. The working width is the union of their stretches, so that disks and the roller
/// behind them count once. Bins, connectors and navigation references work nothing.
/// An element with parts is as wide as these are together, unless its own width (67) is logged and nothing is
/// logged of the parts; parts without a width share the remaining width of the whole. Offsets across (135)
/// count from the device's reference point. Parts are positioned by their offsets. Parts of one whole without
/// offsets, or all at the same one, stand behind one another where their offsets along (134) differ, where
/// the width of the whole is nearer to that of the widest than to the sum, or where that is not known and
/// they are functions; else side by side from left to right by their numbers, in the middle of the whole.
/// Rows of units (type 5) work up to half way to the next. O(elements · log).
std::vector<WorkingPart> working_parts(const DeviceTree& tree, const ElementValues& values);

/// Width of an element, m: logged or described (67), else described (70, 68); nullopt where none is possible.
std::optional<double> width_of(std::size_t element, const ElementValues& values);

}  // namespace tramline::io
