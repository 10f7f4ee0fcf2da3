#pragma once
// From the values of a time log to what worked: boom, work state, states of sections.

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// The machine of one time log. Values hold until another is recorded.
///
/// Where a log tells of several devices, the one counts that says most about what works; of its elements, the
/// sections, where their states or widths are logged, else the first with a width. Sections stand where their
/// offsets say (DDI 135, positive to the right), or side by side in the order of their numbers from left to
/// right where the offsets are not known; widths are what is logged (67), else what the device describes (67,
/// 70, 68). Condensed states (161-176) count the sections by their numbers. Setpoints (290-305) say what was
/// asked for, not what was done, and are not read. The applied rate is the first of the device's that is
/// logged, as volume, mass or count for an area (2, 7, 12).
class LoggedMachine {
 public:
  LoggedMachine(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);

  /// Takes over the values of a record. O(values).
  void update(const TimeLogRecord& record);
  /// Sets boom, work, sections and rate of a fix. O(1) until one of them changes, then O(sections · log).
  void describe(Fix& fix, BoomList& booms);
  /// Of the rates.
  AmountUnit rate_unit() const;
  /// What was assumed, one sentence each.
  const std::vector<std::string>& notes() const { return notes_; }

 private:
  using Key = std::pair<std::string, unsigned>;  ///< element, DDI

  bool is_logged(const std::string& element, unsigned ddi) const;
  std::optional<std::int64_t> value(const DeviceElement& element, unsigned ddi) const;
  std::optional<double> width_m(const DeviceElement& element) const;
  std::optional<bool> state_of_section(std::size_t section) const;
  WorkState master() const;
  Boom boom_of_sections(std::vector<std::size_t>& order) const;

  void describe_anew(Fix& fix, BoomList& booms) const;
  void choose_device(const std::vector<DeviceElement>& elements);
  void choose_elements();
  void choose_rate();
  double rate_per_ha() const;

  const TimeLogHeader& header_;
  std::map<Key, std::int64_t> values_;
  std::vector<DeviceElement> elements_;  ///< of the device that counts
  std::vector<DeviceElement> sections_;  ///< by number; empty: the machine is one
  std::optional<DeviceElement> whole_;   ///< has the width of the machine
  std::optional<Key> rate_;              ///< where the applied rate is logged
  std::vector<std::string> notes_;
  std::optional<Fix> described_;  ///< by the values as they are
};

}  // namespace tramline::io
