#pragma once
// The log of a machine at work: fixes as recorded, before anything is concluded from them.

#include <bitset>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "tramline/geometry/angle.h"
#include "tramline/geometry/point.h"
#include "tramline/geometry/polygon/region.h"

namespace tramline {

/// One section of a machine, given by the offsets of its two ends from the middle of the machine, metres,
/// positive to the left. left_m > right_m; the two are equal where the section has no width and works
/// nothing.
struct Section {
  double left_m = 0;
  double right_m = 0;

  friend bool operator==(const Section& a, const Section& b) = default;
};

/// The sections of a machine at one time, from left to right; a machine without sections is one section.
/// Empty: the machine works nothing.
using Boom = std::vector<Section>;

/// The number of section states that ISO 11783-11 condenses into sixteen values (DDI 161-176).
inline constexpr std::size_t kMostSections = 256;
/// No machine works wider, m: where a log says so, it is wrong.
inline constexpr double kWidestMachine_m = 500;
using SectionStates = std::bitset<kMostSections>;

enum class WorkState : std::uint8_t { kUnknown, kOff, kOn };

/// The unit of applied amounts.
enum class AmountUnit : std::uint8_t { kUnknown, kLitres, kKilograms, kSeeds };
/// "l", "kg", "seeds"; "" where it is not known.
const char* name(AmountUnit unit);

/// One record of a log. What was not recorded is NaN, unknown or -1.
struct Fix {
  double time_s = std::numeric_limits<double>::quiet_NaN();  ///< see WorkLog::clock
  Point position;                                            ///< see WorkLog::positions
  Heading heading;                                           ///< NaN: not recorded
  double speed_mps = std::numeric_limits<double>::quiet_NaN();
  double rate_per_ha = std::numeric_limits<double>::quiet_NaN();  ///< applied, in WorkLog::rate_unit
  int boom = -1;  ///< index into WorkLog::booms; -1: the log does not say how wide the machine worked
  WorkState work = WorkState::kUnknown;
  bool has_sections = false;  ///< the states of sections are known
  SectionStates sections;     ///< set for the working ones, in the order of the boom
  int unit = 0;               ///< fixes of different units (machines, rows of one machine) are never joined
  int shape = -1;             ///< index into WorkLog::shapes of the shape it worked; -1: none
  std::size_t record = 0;     ///< position in the file, from 1: line of a text, record of a binary file
};

/// One record that was not used.
struct SkippedRecord {
  std::size_t record = 0;
  std::string why;
};

/// Skipped records: all are counted, the first kListed are listed.
struct SkippedRecords {
  static constexpr std::size_t kListed = 100;
  std::size_t count = 0;
  std::vector<SkippedRecord> listed;

  void add(std::size_t record, std::string why);
  /// Appends those of another reader.
  void add(const SkippedRecords& others);
};

/// The increase of the machine's own counters over a log. NaN: not recorded.
struct MachineCounters {
  double area_m2 = std::numeric_limits<double>::quiet_NaN();
  double distance_m = std::numeric_limits<double>::quiet_NaN();  ///< at work
  double seconds = std::numeric_limits<double>::quiet_NaN();     ///< at work

  /// Whether any counter was recorded.
  bool any() const;
  /// Adds the counters of a log that follows. A counter that only one of the two has is kept as it is.
  void add(const MachineCounters& next);
};

/// The frame of positions.
enum class Positions : std::uint8_t {
  kLonLat,  ///< WGS 84 longitude and latitude, degrees
  kLocal,   ///< metres, in the field's frame or in a plain plane
};

/// The meaning of Fix::time_s.
enum class Clock : std::uint8_t {
  kNone,   ///< no times
  kUtc,    ///< seconds since 1970-01-01T00:00 UTC (or local time where the log does not say)
  kOfDay,  ///< seconds since midnight
  kOther,  ///< seconds since a moment that is not known
};

/// A log: its fixes in the order of the file.
struct WorkLog {
  std::string name;  ///< file, and the log within it: "TASKDATA.zip/TLG00001"
  Positions positions = Positions::kLonLat;
  Clock clock = Clock::kNone;
  AmountUnit rate_unit = AmountUnit::kUnknown;  ///< of Fix::rate_per_ha
  std::vector<Boom> booms;                      ///< each distinct boom once
  std::vector<Fix> fixes;
  /// Land recorded as worked, as polygons in the frame of the positions. Where there are any, every fix has
  /// one, and nothing is worked between fixes. Oriented.
  std::vector<Polygon> shapes;
  SkippedRecords skipped;
  MachineCounters counters;
  std::vector<std::string> notes;  ///< what the reader assumed, one sentence each
};

/// Keeps the fixes for which `fault` returns an empty text, in their order; the others are counted as skipped
/// and listed with the text.
template <class Fault>
void skip_faulty(WorkLog& log, Fault fault) {
  auto kept = log.fixes.begin();
  for (Fix& fix : log.fixes) {
    std::string why = fault(fix);
    if (why.empty())
      *kept++ = fix;
    else
      log.skipped.add(fix.record, std::move(why));
  }
  log.fixes.erase(kept, log.fixes.end());
}

}  // namespace tramline
