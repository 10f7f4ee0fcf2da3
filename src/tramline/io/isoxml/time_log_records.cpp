#include "tramline/io/isoxml/time_log_records.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>

#include "tramline/io/fixes/places.h"

namespace tramline::io {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr std::uint32_t kDay_ms = 86400000;
// 1980-01-01 counted from 1970-01-01.
constexpr double kDays1980 = 3652;
// Bytes of the parts of a position, in their order.
constexpr std::array<std::size_t, kPositionParts> kSizes = {4, 4, 4, 1, 2, 2, 1, 4, 2};
// A machine does not get further between two records that bytes were lost between.
constexpr double kNear_deg = 0.1;

/// Reads numbers, least byte first; beyond the end it only remembers that it ran out.
class Cursor {
 public:
  Cursor(std::string_view bytes, std::size_t at) : bytes_(bytes), at_(at) {}

  std::uint32_t unsigned_of(std::size_t size) {
    if (bytes_.size() - at_ < size) {
      at_ = bytes_.size();
      ran_out_ = true;
      return 0;
    }
    std::uint32_t out = 0;
    for (std::size_t i = 0; i < size; ++i)
      out |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes_[at_ + i])) << (8 * i);
    at_ += size;
    return out;
  }
  std::int32_t signed32() { return static_cast<std::int32_t>(unsigned_of(4)); }
  std::size_t at() const { return at_; }
  bool ran_out() const { return ran_out_; }

 private:
  std::string_view bytes_;
  std::size_t at_;
  bool ran_out_ = false;
};

}  // namespace

TimeLogRecords::TimeLogRecords(const TimeLogHeader& header, std::string_view bytes)
    : header_(header), bytes_(bytes) {}

TimeLogRecords::Parsed TimeLogRecords::parse(std::size_t at) const {
  Parsed out;
  Cursor cursor(bytes_, at);
  const std::uint32_t ms = cursor.unsigned_of(4);
  out.day = cursor.unsigned_of(2);
  out.record.time_s = (kDays1980 + out.day) * 86400.0 + ms / 1000.0;
  out.record.lonlat_deg = {header_.fixed_lon_deg.value_or(kNone), header_.fixed_lat_deg.value_or(kNone)};
  for (std::size_t i = 0; i < kPositionParts; ++i) {
    if (!header_.in_record[i]) continue;
    const std::uint32_t part = cursor.unsigned_of(kSizes[i]);
    switch (static_cast<PositionPart>(i)) {
      case PositionPart::kNorth:
        out.record.lonlat_deg.y = static_cast<std::int32_t>(part) / 1e7;
        break;
      case PositionPart::kEast:
        out.record.lonlat_deg.x = static_cast<std::int32_t>(part) / 1e7;
        break;
      case PositionPart::kStatus:
        out.record.status = static_cast<int>(part);
        break;
      default:
        break;
    }
  }
  const std::uint32_t count = cursor.unsigned_of(1);
  for (std::uint32_t i = 0; i < count && !cursor.ran_out(); ++i) {
    const std::uint32_t index = cursor.unsigned_of(1);
    const std::int32_t value = cursor.signed32();
    if (index >= header_.values.size()) out.fault = Fault::kValue;
    out.record.values.emplace_back(index, value);
  }
  if (ms >= kDay_ms) out.fault = Fault::kTime;
  if (cursor.ran_out()) out.fault = Fault::kCutOff;
  out.end = cursor.at();
  return out;
}

bool TimeLogRecords::near(const Anchor& anchor, const Parsed& parsed) {
  if (parsed.day != anchor.day && parsed.day != anchor.day + 1) return false;
  const Point way = parsed.record.lonlat_deg - anchor.lonlat_deg;
  return !(std::abs(way.x) > kNear_deg) && !(std::abs(way.y) > kNear_deg);
}

bool TimeLogRecords::log_without_faults(const Parsed& parsed) const {
  if (parsed.fault != Fault::kNone) return false;
  const Point at = parsed.record.lonlat_deg;
  if (!std::isnan(at.x) && !std::isnan(at.y) && !fault_of_lonlat(at).empty()) return false;
  return !trusted_ || near(*trusted_, parsed);
}

/// A damaged record can look whole; one that is near the record before, or near one trusted already, is.
void TimeLogRecords::remember(const Parsed& parsed) {
  if (!fault_of_lonlat(parsed.record.lonlat_deg).empty()) return;
  const Anchor anchor = {parsed.day, parsed.record.lonlat_deg};
  if (!trusted_ || near(*trusted_, parsed) || (last_ && near(*last_, parsed))) trusted_ = anchor;
  last_ = anchor;
}

std::optional<std::size_t> TimeLogRecords::find_next(std::size_t from) const {
  for (std::size_t at = from; at < bytes_.size(); ++at) {
    Cursor start(bytes_, at);
    if (start.unsigned_of(4) >= kDay_ms) continue;
    const Parsed first = parse(at);
    if (!log_without_faults(first)) continue;
    if (first.end == bytes_.size() || log_without_faults(parse(first.end))) return at;
  }
  return std::nullopt;
}

std::optional<TimeLogRecord> TimeLogRecords::next() {
  while (at_ < bytes_.size()) {
    ++number_;
    Parsed parsed = parse(at_);
    if (parsed.fault == Fault::kNone) {
      at_ = parsed.end;
      parsed.record.number = number_;
      remember(parsed);
      return std::move(parsed.record);
    }
    const auto again = find_next(at_ + 1);
    const std::size_t lost = again.value_or(bytes_.size()) - at_;
    const char* const what = parsed.fault == Fault::kTime    ? "its time is after midnight"
                             : parsed.fault == Fault::kValue ? "it has a value that the header does not list"
                                                             : "it is cut off";
    skipped_.add(number_, fmt::format("{}; {} bytes were passed over{}", what, lost,
                                      again ? " up to the next record" : ", to the end of the file"));
    at_ += lost;
  }
  return std::nullopt;
}

}  // namespace tramline::io
