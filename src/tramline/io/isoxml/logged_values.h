#pragma once
// The latest values of a time log for the elements of a tree.

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"

namespace tramline::io {

/// Values hold until others are recorded. Header and tree have to outlive this.
class LoggedValues {
 public:
  LoggedValues(const TimeLogHeader& header, const DeviceTree& tree);

  /// The kinds of values that a record changed.
  struct Change {
    bool places = false;  ///< widths and offsets
    bool states = false;
  };
  /// Takes over the values of a record. O(values).
  Change update(const TimeLogRecord& record);

  /// Whether the log has such values at all.
  bool is_logged(std::size_t element, unsigned ddi) const { return logged_.contains({element, ddi}); }
  bool has_condensed_states(std::size_t element) const;
  /// The value logged last.
  std::optional<std::int64_t> logged(std::size_t element, unsigned ddi) const;
  /// The value logged last, or failing that the one in the device description.
  std::optional<std::int64_t> value(std::size_t element, unsigned ddi) const;

 private:
  using Key = std::pair<std::size_t, unsigned>;  ///< element, data dictionary identifier

  const DeviceTree& tree_;
  /// Keys of the header's values; nullopt: not of an element of the tree.
  std::vector<std::optional<Key>> keys_;
  std::vector<bool> fixed_;  ///< by the header
  std::map<Key, std::optional<std::int64_t>> logged_;
};

}  // namespace tramline::io
