#include "tramline/coverage/drive/heading_check.h"

#include <fmt/format.h>

#include <cmath>

namespace tramline::coverage {
namespace {

/// The moment by the clock of the log, as far as it is one: "2020-05-01 08:15:00", "08:15:00", "12.5 s".
std::string moment_text(double time_s, Clock clock) {
  if (std::isnan(time_s) || clock == Clock::kNone) return "";
  if (clock == Clock::kOther) return fmt::format(" at {:.10g} s", time_s);
  constexpr double kDay_s = 86400;
  const double of_day_s = time_s - kDay_s * std::floor(time_s / kDay_s);
  const auto seconds = static_cast<int>(of_day_s);
  return fmt::format(" at {:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60);
}

const char* in_words(HeadingReading reading) {
  return reading == HeadingReading::kMath ? "anticlockwise from east" : "clockwise from north";
}

}  // namespace

const char* name(HeadingReading reading) {
  switch (reading) {
    case HeadingReading::kCompass:
      return "compass";
    case HeadingReading::kMath:
      return "math";
    case HeadingReading::kFromTrack:
      break;
  }
  return "from-track";
}

Heading heading_read_as(HeadingReading reading, const Fix& fix) {
  if (reading == HeadingReading::kFromTrack || std::isnan(fix.heading.degrees())) return Heading{};
  if (reading == HeadingReading::kCompass) return fix.heading;
  return Heading::clockwise_from_north(Angle::degrees(90) - fix.heading.angle());
}

bool contradicts(Heading heading, Heading course) {
  return std::abs(dot(heading.unit(), course.unit())) < std::cos(kHeadingOff.radians());
}

void HeadingCheck::count(Tally& tally, Heading heading, Heading course, const Fix& fix) {
  if (!contradicts(heading, course)) return;
  if (++tally.off > 1) return;
  tally.record = fix.record;
  tally.time_s = fix.time_s;
  tally.at = fix.position;
}

void HeadingCheck::add(const Fix& fix, Continuity continuity) {
  const Begin here{fix.position, fix.time_s};
  const auto [begin, first] = begin_.try_emplace(fix.unit, here);
  if (first || continuity == Continuity::kBroken) {
    begin->second = here;
    return;
  }
  const Begin from = begin->second;
  const double way_m = distance(from.position, fix.position);
  if (way_m < kHeadingBase_m) return;
  begin->second = here;
  const double seconds = fix.time_s - from.time_s;  // NaN without times: nothing is known against it
  if (way_m < kHeadingSpeed_mps * seconds || std::isnan(fix.heading.degrees())) return;
  const Heading course = Heading::from_to(from.position, fix.position);
  ++steps_;
  count(compass_, heading_read_as(HeadingReading::kCompass, fix), course, fix);
  count(math_, heading_read_as(HeadingReading::kMath, fix), course, fix);
}

bool HeadingCheck::contradictory(const Tally& tally) const {
  return static_cast<double>(tally.off) > kHeadingShare * static_cast<double>(steps_);
}

std::optional<HeadingContradiction> HeadingCheck::contradiction(HeadingReading reading) const {
  if (reading == HeadingReading::kFromTrack || steps_ < kLeastHeadingSteps) return std::nullopt;
  const Tally& found = tally(reading);
  if (!contradictory(found)) return std::nullopt;
  const HeadingReading other =
      reading == HeadingReading::kMath ? HeadingReading::kCompass : HeadingReading::kMath;
  const bool other_fits = !contradictory(tally(other));
  HeadingContradiction out;
  out.read_as = name(reading);
  out.steps = steps_;
  out.off = found.off;
  out.better = name(other_fits ? other : HeadingReading::kFromTrack);
  out.better_off = other_fits ? tally(other).off : 0;
  out.record = found.record;
  out.time_s = found.time_s;
  out.at = found.at;
  return out;
}

std::string warning_on(const HeadingContradiction& found, Clock clock) {
  const bool math = found.better == name(HeadingReading::kMath);
  const std::string advice =
      found.better == name(HeadingReading::kFromTrack)
          ? "no reading of the angles fits: unless the machine moves sideways, give --headings from-track"
          : fmt::format("read as angles {}, {} of {} agree: give --headings {}",
                        in_words(math ? HeadingReading::kMath : HeadingReading::kCompass),
                        found.steps - found.better_off, found.steps, found.better);
  return fmt::format(
      "the headings of the log contradict the way driven: {} of {} steps ({:.0f} %) are more than 45° off, "
      "first at record {}{}; {}",
      found.off, found.steps, 100 * found.share(), found.record, moment_text(found.time_s, clock), advice);
}

}  // namespace tramline::coverage
