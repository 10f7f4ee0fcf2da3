#pragma once
// Derives boom, work state, states of sections, rate and counters from the values of a time log.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/logged_devices.h"
#include "tramline/io/isoxml/logged_rate.h"
#include "tramline/io/isoxml/logged_values.h"
#include "tramline/io/isoxml/part_states.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"
#include "tramline/io/isoxml/working_parts.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The machine of one time log, which may be several devices (logged_devices.h). Its boom consists of the
/// stretches that its parts work (working_parts.h), section by section where their states differ
/// (part_states.h). A part without a logged state works when anything does, unless the log has states of
/// other parts of the same whole. Setpoints (290-305) are requests, not results, and are not read.
class LoggedMachine {
 public:
  /// `header` has to outlive this.
  LoggedMachine(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);
  LoggedMachine(const LoggedMachine&) = delete;
  LoggedMachine& operator=(const LoggedMachine&) = delete;

  /// Takes over the values of a record. O(values).
  void update(const TimeLogRecord& record);
  /// Sets boom, work, sections and rate of a fix. O(1) until one of them changes, then O(sections · log).
  void describe(Fix& fix, BoomList& booms);
  /// The unit of the rates.
  AmountUnit rate_unit() const { return rate_.unit(); }
  /// Ids of the relevant devices.
  const std::vector<std::string>& devices() const { return logged_.devices; }
  /// The elements of these devices.
  const std::vector<DeviceElement>& elements() const { return logged_.elements; }
  /// The assumptions made, one sentence each.
  std::vector<std::string> notes() const;

 private:
  /// One section of the boom, with the element that has its state.
  struct Piece {
    Section place;
    std::size_t bearer = 0;  ///< element that switches it
  };

  /// The sources of the state of one element, apart from those common to all.
  struct Bearer {
    std::vector<StateSource> sources;
    bool follows = false;  ///< works when anything does
  };

  ElementValues element_values() const;
  bool parts_are_logged(std::size_t element) const;
  void find_pieces();
  void find_bearers(const std::vector<std::size_t>& elements);
  std::size_t bearer_of(std::size_t element) const;
  void find_common_sources(const std::vector<std::size_t>& elements);
  std::vector<std::size_t> without_width() const;
  void describe_anew(Fix& fix, BoomList& booms);

  LoggedDevices logged_;
  DeviceTree tree_;
  LoggedValues values_;
  PartStates states_;
  LoggedRate rate_;
  std::vector<bool> parts_logged_;
  std::vector<std::string> notes_;

  std::optional<std::vector<Piece>> pieces_;  ///< for the present positions, from left to right
  std::vector<StateSource> common_;           ///< of all pieces
  std::map<std::size_t, Bearer> bearers_;
  std::optional<Fix> described_;  ///< for the present values
};

}  // namespace tramline::io
