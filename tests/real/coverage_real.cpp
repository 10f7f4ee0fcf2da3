// Every real log: the areas and regions kept while driving against the union of all quads at once. One line
// for each log and way of making quads; exit 1 where any differs by more than a millionth of the worked area.
//
//   coverage_real

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <map>
#include <optional>
#include <string>

#include "real/real_fields.h"
#include "real/real_logs.h"

namespace tramline::testing {
namespace {

constexpr double kMost = 1e-6;  // of the worked area
constexpr double kWidth_m = 6;  // where the log does not say

/// Fields of logs that come with one.
const std::map<std::string, std::string> kPartfields{
    {"isoxml_sh2020_TLG00001.csv", "iso-timelogs/ValidTimeLogs-PFD-2"},
    {"isoxml_sh2020_TLG00002.csv", "iso-timelogs/ValidTimeLogs-PFD-3"},
    {"isoxml_sh2020_TLG00003.csv", "iso-timelogs/ValidTimeLogs-PFD-4"},
    {"isoxml_sh2020_TLG00005.csv", "iso-timelogs/ValidTimeLogs-PFD-6"},
    {"isoxml_sh2020_TLG00008.csv", "iso-timelogs/ValidTimeLogs-PFD-8"},
};

/// Whether the log is as it should be. Prints its line.
bool sound(const RealFields& fields, const std::string& name, const char* way,
           coverage::DriveSettings settings) {
  settings.width_m = kWidth_m;
  BatchDifference found;
  if (const auto partfield = kPartfields.find(name); partfield != kPartfields.end()) {
    const Field field = field_named(fields, partfield->second);
    found = stream_against_batch(real_log(name, field.frame), ground_of(field), settings);
  } else {
    found = stream_against_batch(real_log(name), {}, settings);
  }
  const bool ok = std::max(found.areas, found.regions) <= kMost;
  fmt::print("{:<44} {:<8} areas {:.1e}  regions {:.1e}{}\n", name, way, found.areas, found.regions,
             ok ? "" : "  FAIL");
  std::fflush(stdout);
  return ok;
}

int run() {
  const auto fields = read_or_say();
  if (!fields) return 0;
  coverage::DriveSettings by_segment;
  by_segment.quads = coverage::QuadShape::kSegment;
  by_segment.switching = coverage::Switching::kStep;
  int done = 0, failed = 0;
  for (const std::string& name : real_logs()) {
    failed += sound(*fields, name, "heading", {}) ? 0 : 1;
    failed += sound(*fields, name, "segment", by_segment) ? 0 : 1;
    done += 2;
  }
  fmt::print("{} evaluations against polygon unions, {} fail\n", done, failed);
  return failed == 0 ? 0 : 1;
}

}  // namespace
}  // namespace tramline::testing

int main() {
  try {
    return tramline::testing::run();
  } catch (const std::exception& error) {
    fmt::print(stderr, "coverage_real: {}\n", error.what());
    return 1;
  }
}
