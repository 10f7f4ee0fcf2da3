#pragma once
// From the values of a time log to what worked: boom, work state, states of sections, rate and counters.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/isoxml/device_tree.h"
#include "tramline/io/isoxml/logged_rate.h"
#include "tramline/io/isoxml/logged_values.h"
#include "tramline/io/isoxml/part_states.h"
#include "tramline/io/isoxml/telling_devices.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"
#include "tramline/io/isoxml/working_parts.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The machine of one time log, which may be several devices (telling_devices.h). Its boom is what its parts
/// work across (working_parts.h), section by section where their states differ (part_states.h). A part of
/// which the log tells no state works when anything does, unless it tells the states of others of the same
/// whole. Setpoints (290-305) say what was asked for, not what was done, and are not read.
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
  /// Of the rates.
  AmountUnit rate_unit() const { return rate_.unit(); }
  /// Ids of the devices that count.
  const std::vector<std::string>& devices() const { return telling_.devices; }
  /// Of these devices.
  const std::vector<DeviceElement>& elements() const { return telling_.elements; }
  /// What was assumed, one sentence each.
  std::vector<std::string> notes() const;

 private:
  /// One section of the boom, and where its state stands.
  struct Piece {
    Section place;
    std::size_t bearer = 0;  ///< element that switches it
  };

  /// What is told of the state of one element, apart from what is told of all.
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

  TellingDevices telling_;
  DeviceTree tree_;
  LoggedValues values_;
  PartStates states_;
  LoggedRate rate_;
  std::vector<bool> parts_logged_;
  std::vector<std::string> notes_;

  std::optional<std::vector<Piece>> pieces_;  ///< by the places as they are, from left to right
  std::vector<StateSource> common_;           ///< of all pieces
  std::map<std::size_t, Bearer> bearers_;
  std::optional<Fix> described_;  ///< by the values as they are
};

}  // namespace tramline::io
