#pragma once
// Reads a log line by line; its first lines determine the format.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geodesy/crs.h"
#include "tramline/geometry/polygon/region.h"
#include "tramline/io/log/csv_log.h"
#include "tramline/io/log/nmea_log.h"
#include "tramline/io/log/read_log.h"
#include "tramline/io/log/width_unit.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// Makes fixes of the lines of a CSV or NMEA stream as they come.
/// Some conclusions of read_log() need the whole log: whether x and y are degrees, the unit of widths, which
/// positions are strays, the date of fixes before the first date, and that the machine worked before a first
/// line said otherwise (state_lines.h). Fixes are returned according to the lines so far; settle() returns
/// the log that read_log() would read from them, and later fixes agree with it.
class LineLog {
 public:
  enum class Kind { kOpen, kCsv, kNmea };

  /// options.log is not used. `place`: name for messages, "the stream". Throws bad_input for an unknown CRS.
  LineLog(LogOptions options, std::string place);

  /// The fixes of this line, as a rule one or none; several where it determines the format of the log. With
  /// NMEA the fix of an epoch comes with the first line of the next. Throws bad_input for a table without the
  /// columns that are needed, and where 8 KiB are neither table nor NMEA. O(line).
  std::vector<Fix> add(std::string_view line);
  /// The fix of an epoch that is still open, at the end of the stream.
  std::vector<Fix> finish();

  Kind kind() const { return kind_; }
  /// Frame of the fixes.
  Positions positions() const { return positions_; }
  /// The booms of the fixes so far.
  std::span<const Boom> booms() const { return booms_; }
  /// Whether the log itself has columns for the width and the work of the machine.
  OwnColumns own_columns() const;
  std::size_t lines() const { return lines_; }
  /// Of the last fix; unknown for tables.
  FixQuality quality() const { return nmea_ ? nmea_->quality() : FixQuality::kUnknown; }

  /// Whether returned fixes may have to be read again in another way, ...
  bool doubtful() const { return doubtful_ || urgent_; }
  /// ... and whether they have to be now.
  bool urgent() const { return urgent_; }
  /// The log so far as read_log() reads it; empty before the first usable fix. Its name is the caller's.
  /// O(fixes).
  WorkLog settle();
  /// The same without fixes and booms, as far as it is known without looking at all of them. O(1).
  WorkLog head() const;

 private:
  std::vector<Fix> add_known(std::string_view line);
  std::optional<Fix> taken(Fix fix);
  void recognise(std::string_view line, std::vector<Fix>& out);
  Positions named_positions() const;
  void renew_booms();
  const StateLines* states() const;

  LogOptions options_;
  std::string place_;
  std::optional<Crs> crs_;
  Kind kind_ = Kind::kOpen;
  std::vector<std::string> held_;  ///< before the kind is known
  std::size_t held_bytes_ = 0;
  std::optional<CsvLog> csv_;
  std::optional<NmeaLog> nmea_;
  std::size_t lines_ = 0;

  std::vector<Fix> raw_;
  std::vector<RecordedDistance> distances_;
  Positions positions_ = Positions::kLonLat;
  bool decided_ = false;  ///< on positions_, by a whole log
  double width_unit_m_ = 1;
  std::vector<Boom> booms_;
  Box box_;                               ///< of the longitudes and latitudes
  std::vector<std::string> whole_notes_;  ///< notes that need the whole log, from the last settle()
  SkippedRecords impossible_;             ///< positions, besides what the readers skip
  bool undated_ = false;                  ///< a fix came out before the date
  bool unstated_ = false;                 ///< ... or before the first line on work
  bool doubtful_ = false;
  bool urgent_ = false;
};

/// "$GPGGA," or the like anywhere in the text.
bool has_sentence(std::string_view text);

}  // namespace tramline::io
