#include "tramline/io/log/nmea_log.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/fixes/civil_time.h"
#include "tramline/io/fixes/course_heading.h"
#include "tramline/io/fixes/most_fixes.h"
#include "tramline/io/fixes/number_text.h"
#include "tramline/io/fixes/places.h"

namespace tramline::io {

/// Fields of one sentence; those that are missing are empty.
class NmeaLog::Fields {
 public:
  explicit Fields(std::string_view body) {
    while (true) {
      const std::size_t comma = body.find(',');
      fields_.push_back(trimmed(body.substr(0, comma)));
      if (comma == std::string_view::npos) break;
      body.remove_prefix(comma + 1);
    }
  }

  std::string_view text(std::size_t i) const { return i < fields_.size() ? fields_[i] : std::string_view(); }
  double number(std::size_t i) const {
    return number_in(text(i)).value_or(std::numeric_limits<double>::quiet_NaN());
  }

  /// "hhmmss.ss", seconds since midnight.
  std::optional<double> time_s(std::size_t i) const {
    const std::string_view time = text(i);
    if (time.size() < 6) return std::nullopt;
    const auto hours = digits_in(time.substr(0, 2)), minutes = digits_in(time.substr(2, 2));
    const auto seconds = number_in(time.substr(4));
    if (!hours || !minutes || !seconds || *hours > 23 || *minutes > 59 || *seconds < 0 || *seconds >= 61)
      return std::nullopt;
    return 3600.0 * static_cast<double>(*hours) + 60.0 * static_cast<double>(*minutes) + *seconds;
  }

  /// "dddmm.mmmm" and the letter after it, degrees; NaN for anything else.
  double degrees(std::size_t i, char negative, char positive) const {
    const double value = number(i);
    const std::string_view letter = text(i + 1);
    const bool is_side = letter.size() == 1 && (letter[0] == negative || letter[0] == positive);
    const double whole = std::floor(value / 100), minutes = value - 100 * whole;
    if (!is_side || !(value >= 0) || !(minutes < 60)) return std::numeric_limits<double>::quiet_NaN();
    return (letter[0] == negative ? -1 : 1) * (whole + minutes / 60);
  }

 private:
  std::vector<std::string_view> fields_;
};

namespace {

constexpr double kKnot_mps = 1852.0 / 3600;

/// The two hexadecimal digits of a checksum.
std::optional<unsigned> checksum_in(std::string_view text) {
  if (text.size() < 2) return std::nullopt;
  unsigned out = 0;
  for (const char c : lower_case(text.substr(0, 2))) {
    const std::size_t digit = std::string_view("0123456789abcdef").find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    out = 16 * out + static_cast<unsigned>(digit);
  }
  return out;
}

unsigned checksum_of(std::string_view body) {
  unsigned out = 0;
  for (const char c : body) out ^= static_cast<unsigned char>(c);
  return out;
}

/// The sixth field of GGA.
FixQuality quality_of_gga(std::string_view digit) {
  if (digit == "1") return FixQuality::kSingle;
  if (digit == "2" || digit == "3" || digit == "9") return FixQuality::kDifferential;
  if (digit == "4") return FixQuality::kRtkFixed;
  if (digit == "5") return FixQuality::kRtkFloat;
  return digit == "6" || digit == "7" || digit == "8" ? FixQuality::kEstimated : FixQuality::kUnknown;
}

/// The mode of RMC, from NMEA 2.3 on.
FixQuality quality_of_rmc(std::string_view letter) {
  if (letter == "A") return FixQuality::kSingle;
  if (letter == "D" || letter == "P") return FixQuality::kDifferential;
  if (letter == "R") return FixQuality::kRtkFixed;
  if (letter == "F") return FixQuality::kRtkFloat;
  return letter == "E" || letter == "M" || letter == "S" ? FixQuality::kEstimated : FixQuality::kUnknown;
}

/// "GPGGA" is "GGA"; proprietary sentences have no such kind.
std::string_view kind_of(std::string_view address) {
  return address.size() == 5 && address[0] != 'P' ? address.substr(2) : std::string_view();
}

}  // namespace

const char* name(FixQuality quality) {
  switch (quality) {
    case FixQuality::kSingle:
      return "single";
    case FixQuality::kDifferential:
      return "differential";
    case FixQuality::kRtkFloat:
      return "rtk float";
    case FixQuality::kRtkFixed:
      return "rtk fixed";
    case FixQuality::kEstimated:
      return "estimated";
    case FixQuality::kUnknown:
      break;
  }
  return "";
}

double NmeaLog::elapsed_s(const Epoch& epoch) {
  if (!epoch.of_day_s) return std::numeric_limits<double>::quiet_NaN();
  has_times_ = true;
  // Half a day back is midnight; less is an epoch out of order.
  if (last_of_day_s_ && *last_of_day_s_ - *epoch.of_day_s > 0.5 * kDay_s) days_s_ += kDay_s;
  last_of_day_s_ = epoch.of_day_s;
  if (epoch.date_days) {
    const double day_s = kDay_s * static_cast<double>(*epoch.date_days);
    if (!midnight_s_) midnight_s_ = day_s - days_s_;
    days_s_ = day_s - *midnight_s_;
  }
  return days_s_ + *epoch.of_day_s;
}

std::optional<Fix> NmeaLog::finish() {
  if (!began_) return std::nullopt;
  began_ = false;
  const Epoch epoch = std::exchange(epoch_, {});
  const double time_s = elapsed_s(epoch);
  if (epoch.no_fix) {
    skipped_.add(epoch.record, "the receiver had no position");
    return std::nullopt;
  }
  if (!epoch.lonlat_deg) return std::nullopt;
  if (std::string fault = fault_of_lonlat(*epoch.lonlat_deg); !fault.empty()) {
    skipped_.add(epoch.record, std::move(fault));
    return std::nullopt;
  }
  quality_ = epoch.quality;
  Fix fix = epoch.state;
  fix.record = epoch.record;
  fix.time_s = time_s;
  fix.position = *epoch.lonlat_deg;
  fix.speed_mps = epoch.speed_mps;
  fix.heading = std::isnan(epoch.heading_deg) ? heading_of_course(epoch.course_deg, epoch.speed_mps)
                                              : heading_of_degrees(epoch.heading_deg);
  return fix;
}

std::optional<Fix> NmeaLog::epoch_at(std::string_view kind, std::optional<double> of_day_s) {
  std::optional<Fix> done;
  const bool timed = of_day_s && epoch_.of_day_s;
  const bool again = (kind == "GGA" && epoch_.has_gga) || (kind == "RMC" && epoch_.has_rmc);
  const bool same = began_ && (timed ? *of_day_s == *epoch_.of_day_s : !again);
  if (!same) {
    done = finish();
    began_ = true;
  }
  if (of_day_s) epoch_.of_day_s = of_day_s;
  epoch_.has_gga |= kind == "GGA";
  epoch_.has_rmc |= kind == "RMC";
  return done;
}

void NmeaLog::place(const Fields& fields, std::size_t latitude) {
  const Point lonlat = {fields.degrees(latitude + 2, 'W', 'E'), fields.degrees(latitude, 'S', 'N')};
  if (epoch_.lonlat_deg) return;
  epoch_.record = line_;
  epoch_.lonlat_deg = lonlat;
  states_.apply(epoch_.state, booms_, {});
}

void NmeaLog::read_gga(const Fields& fields) {
  if (fields.text(6) == "0" || fields.text(6).empty()) {
    epoch_.no_fix = true;
    epoch_.record = line_;
    return;
  }
  epoch_.quality = quality_of_gga(fields.text(6));
  place(fields, 2);
}

void NmeaLog::read_rmc(const Fields& fields) {
  if (const std::string_view date = fields.text(9); date.size() == 6) {
    const auto day = digits_in(date.substr(0, 2)), month = digits_in(date.substr(2, 2)),
               year = digits_in(date.substr(4, 2));
    if (day && month && year) epoch_.date_days = days_to(*year + (*year >= 80 ? 1900 : 2000), *month, *day);
  }
  if (fields.text(2) == "V") {
    epoch_.no_fix = true;
    epoch_.record = line_;
    return;
  }
  if (epoch_.quality == FixQuality::kUnknown) epoch_.quality = quality_of_rmc(fields.text(12));
  place(fields, 3);
  if (const double knots = fields.number(7); !std::isnan(knots)) epoch_.speed_mps = knots * kKnot_mps;
  if (const double course = fields.number(8); !std::isnan(course)) epoch_.course_deg = course;
}

void NmeaLog::read_vtg(const Fields& fields) {
  // Before NMEA 2.3 the numbers had no letters between them.
  const bool has_letters = fields.text(2) == "T";
  const double knots = fields.number(has_letters ? 5 : 3);
  if (const double course = fields.number(1); !std::isnan(course)) epoch_.course_deg = course;
  if (!std::isnan(knots)) epoch_.speed_mps = knots * kKnot_mps;
}

void NmeaLog::read_heading(std::string_view kind, const Fields& fields) {
  if (kind == "THS" && fields.text(2) == "V") return;
  if (const double heading = fields.number(1); !std::isnan(heading)) epoch_.heading_deg = heading;
}

void NmeaLog::read_zda(const Fields& fields) {
  const auto day = digits_in(fields.text(2)), month = digits_in(fields.text(3)),
             year = digits_in(fields.text(4));
  if (day && month && year) epoch_.date_days = days_to(*year, *month, *day);
}

std::optional<Fix> NmeaLog::add(std::string_view line) {
  ++line_;
  if (line.starts_with('#') && states_.add(line, line_, skipped_)) return std::nullopt;
  // A sentence that was cut off may run into the next one.
  const std::size_t start = line.rfind('$');
  if (start == std::string_view::npos) {
    // Reports of ships and the like begin with "!"; blank lines are no loss.
    if (const std::string_view text = trimmed(line); !text.empty() && text.front() != '!')
      skipped_.add(line_, "no sentence");
    return std::nullopt;
  }
  line = trimmed(line.substr(start + 1));
  const std::size_t star = line.find('*');
  const std::string_view body = line.substr(0, star);
  if (star == std::string_view::npos) {
    if (has_checksums_) {
      skipped_.add(line_, "the sentence is cut off");
      return std::nullopt;
    }
  } else {
    const auto checksum = checksum_in(line.substr(star + 1));
    if (!checksum || *checksum != checksum_of(body)) {
      skipped_.add(line_, "the checksum is wrong");
      return std::nullopt;
    }
    has_checksums_ = true;
  }
  ++sentences_;
  const Fields fields(body);
  const std::string_view kind = kind_of(fields.text(0));
  std::optional<Fix> done;
  if (kind == "GGA" || kind == "RMC" || kind == "ZDA") {
    done = epoch_at(kind, fields.time_s(1));
    if (kind == "GGA") read_gga(fields);
    if (kind == "RMC") read_rmc(fields);
    if (kind == "ZDA") read_zda(fields);
  } else if (kind == "VTG" || kind == "HDT" || kind == "THS") {
    began_ = true;
    if (kind == "VTG")
      read_vtg(fields);
    else
      read_heading(kind, fields);
  }
  return done;
}

WorkLog work_log_of(const NmeaLog& nmea, std::vector<Fix> fixes) {
  assert(!fixes.empty());
  WorkLog log;
  log.fixes = std::move(fixes);
  log.booms = nmea.booms();
  log.skipped = nmea.skipped();
  log.clock = !nmea.has_times() ? Clock::kNone : nmea.midnight_s() ? Clock::kUtc : Clock::kOfDay;
  if (nmea.midnight_s())
    for (Fix& fix : log.fixes) fix.time_s += *nmea.midnight_s();
  work_before(log, nmea.states());
  skip_strays(log);
  return log;
}

WorkLog read_nmea_log(Lines& lines, const std::string& place) {
  NmeaLog nmea;
  std::vector<Fix> fixes;
  std::string line;
  while (lines.next(line)) {
    const auto fix = nmea.add(line);
    if (!fix) continue;
    require_room_for_fix(fixes.size(), place);
    fixes.push_back(*fix);
  }
  if (const auto fix = nmea.finish()) fixes.push_back(*fix);
  if (fixes.empty())
    throw bad_input(
        fmt::format("{} has no GGA or RMC sentence with a position and a right checksum ({} lines "
                    "were skipped)",
                    place, nmea.skipped().count));
  WorkLog log = work_log_of(nmea, std::move(fixes));
  if (!lines.cut_off().empty()) log.notes.push_back(lines.cut_off() + "; the sentences before were read");
  return log;
}

}  // namespace tramline::io
