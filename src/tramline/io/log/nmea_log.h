#pragma once
// NMEA 0183: sentences of a receiver, grouped to one fix for each epoch.

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "tramline/io/fixes/boom_list.h"
#include "tramline/io/fixes/lines.h"
#include "tramline/io/log/state_lines.h"
#include "tramline/model/work_log.h"

namespace tramline::io {

/// How a receiver came by a position.
enum class FixQuality : std::uint8_t { kUnknown, kSingle, kDifferential, kRtkFloat, kRtkFixed, kEstimated };
/// "rtk fixed"; "" where it is not known.
const char* name(FixQuality quality);

/// Makes fixes of sentences as they come. Read are GGA and RMC (position), RMC and VTG (course, speed), HDT
/// and THS (true heading), RMC and ZDA (date), of any talker; others are ignored. Sentences with the same
/// time are one epoch, and those without a time belong to the epoch they follow (a second GGA or RMC without
/// a time begins another); so a fix is returned when the next epoch begins. A course is taken as a heading
/// above kCourseHolds_mps only. Lines on work (state_lines.h) apply to the epochs whose position comes after
/// them.
///
/// Skipped and counted: lines without a sentence, wrong checksums, missing checksums where others had one (a
/// truncated line), epochs without a position fix, impossible positions.
class NmeaLog {
 public:
  /// The fix of the epoch that this line ends, if there is one. Fix::record is the number of the line with
  /// its position. O(line).
  std::optional<Fix> add(std::string_view line);
  /// The fix of the last epoch.
  std::optional<Fix> finish();

  /// Fix::time_s counts from the midnight before the first epoch; this is that midnight in seconds from 1970,
  /// once a date was read.
  std::optional<double> midnight_s() const { return midnight_s_; }
  bool has_times() const { return has_times_; }
  /// Of the last fix: as its GGA says or, without one, the mode of its RMC.
  FixQuality quality() const { return quality_; }
  const SkippedRecords& skipped() const { return skipped_; }
  const std::vector<Boom>& booms() const { return booms_.booms(); }
  const StateLines& states() const { return states_; }
  /// The number of sentences of any kind with a correct checksum or none.
  std::size_t sentences() const { return sentences_; }

 private:
  /// The values of the sentences of one epoch so far.
  struct Epoch {
    std::optional<double> of_day_s;
    std::optional<Point> lonlat_deg;
    bool no_fix = false;
    bool has_gga = false;
    bool has_rmc = false;
    std::size_t record = 0;
    double speed_mps = std::numeric_limits<double>::quiet_NaN();
    double course_deg = std::numeric_limits<double>::quiet_NaN();
    double heading_deg = std::numeric_limits<double>::quiet_NaN();
    std::optional<long long> date_days;
    FixQuality quality = FixQuality::kUnknown;
    Fix state;  ///< width and work given by lines at the time of the position
  };
  class Fields;

  void read_gga(const Fields& fields);
  void read_rmc(const Fields& fields);
  void read_vtg(const Fields& fields);
  void read_heading(std::string_view kind, const Fields& fields);
  void read_zda(const Fields& fields);
  void place(const Fields& fields, std::size_t latitude);
  /// Begins a new epoch where the time differs, and returns the fix of the one before.
  std::optional<Fix> epoch_at(std::string_view kind, std::optional<double> of_day_s);
  double elapsed_s(const Epoch& epoch);

  Epoch epoch_;
  bool began_ = false;
  std::size_t line_ = 0;
  std::size_t sentences_ = 0;
  bool has_checksums_ = false;
  bool has_times_ = false;
  std::optional<double> last_of_day_s_;
  double days_s_ = 0;
  FixQuality quality_ = FixQuality::kUnknown;
  std::optional<double> midnight_s_;
  SkippedRecords skipped_;
  StateLines states_;
  BoomList booms_;
};

/// The log of sentences that have all been read. Precondition: at least one fix. O(fixes).
WorkLog work_log_of(const NmeaLog& nmea, std::vector<Fix> fixes);

/// Reads a whole file. Throws bad_input for a file without any position. O(size).
WorkLog read_nmea_log(Lines& lines, const std::string& place);

}  // namespace tramline::io
