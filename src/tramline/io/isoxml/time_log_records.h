#pragma once
// The records of a time log (TLG00001.bin).

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "tramline/geometry/point.h"
#include "tramline/io/isoxml/time_log_header.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// One record as written.
struct TimeLogRecord {
  std::size_t number = 0;  ///< in the file, from 1
  double time_s = 0;       ///< since 1970-01-01T00:00; machines write local time
  Point lonlat_deg;        ///< NaN: the record has none
  int status = -1;         ///< of the position, ISO 11783-10 PTN@D; -1: not recorded
  std::vector<std::pair<std::size_t, std::int32_t>> values;  ///< index in the header's list, value
};

/// Parses a time log one record after the other. An impossible record (a time after midnight, a value that
/// the header does not list) means that bytes were lost or added: parsing goes on at the next offset where a
/// record of the same day, near the last position, begins and is followed by another. The bytes between are
/// skipped and reported.
class TimeLogRecords {
 public:
  /// Both have to outlive this.
  TimeLogRecords(const TimeLogHeader& header, std::string_view bytes);

  /// The next record; nullopt after the last. O(its size), after damage O(bytes skipped).
  std::optional<TimeLogRecord> next();
  const SkippedRecords& skipped() const { return skipped_; }

 private:
  enum class Fault { kNone, kCutOff, kTime, kValue };
  struct Parsed {
    TimeLogRecord record;
    std::size_t end = 0;
    unsigned day = 0;
    Fault fault = Fault::kNone;
  };

  Parsed parse(std::size_t at) const;
  bool log_without_faults(const Parsed& parsed) const;
  std::optional<std::size_t> find_next(std::size_t from) const;

  const TimeLogHeader& header_;
  std::string_view bytes_;
  std::size_t at_ = 0;
  std::size_t number_ = 0;
  /// Day and place of a record.
  struct Anchor {
    unsigned day = 0;
    Point lonlat_deg;
  };
  void remember(const Parsed& parsed);
  static bool near(const Anchor& anchor, const Parsed& parsed);

  std::optional<Anchor> trusted_;  ///< of the last record that fits with another
  std::optional<Anchor> last_;
  SkippedRecords skipped_;
};

}  // namespace tramline::io
