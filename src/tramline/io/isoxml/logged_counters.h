#pragma once
// The machine's own counters, from a time log.

#include <cstddef>
#include <map>
#include <vector>

#include "tramline/io/fixes/counter_total.h"
#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/io/isoxml/time_log_records.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Total area (116, m²), effective total distance (117, mm) and effective total time (119, s) of the relevant
/// elements, or failing that of any. Where several elements have the same counter, the largest total is used:
/// it is that of the whole machine.
class LoggedCounters {
 public:
  LoggedCounters(const TimeLogHeader& header, const std::vector<DeviceElement>& elements);

  void update(const TimeLogRecord& record);
  MachineCounters totals() const;

 private:
  struct Counter {
    unsigned ddi = 0;
    CounterTotal total;
  };

  double largest(unsigned ddi) const;

  std::map<std::size_t, Counter> counters_;  ///< by the index in the header
};

}  // namespace tramline::io
