// Real logs evaluated: against figures found elsewhere, and the stream against the batch.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "real/real_fields.h"
#include "real/real_logs.h"
#include "tramline/coverage/evaluate.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing {
namespace {

using coverage::EvaluateSettings;

/// A harvester's log and its field, with what two other programs found for it, m² (see the data's own notes).
struct Harvest {
  const char* log;
  const char* partfield;
  double field_m2;
  double gross_m2;
  double union_m2;
  double inside_m2;
};

constexpr Harvest kHarvests[] = {
    {"isoxml_sh2020_TLG00001.csv", "iso-timelogs/ValidTimeLogs-PFD-2", 43992.7, 48454.3, 42480.9, 41232.8},
    {"isoxml_sh2020_TLG00002.csv", "iso-timelogs/ValidTimeLogs-PFD-3", 36978.7, 41665.5, 36122.3, 35153.8},
    {"isoxml_sh2020_TLG00003.csv", "iso-timelogs/ValidTimeLogs-PFD-4", 18142.6, 19927.8, 17328.3, 16907.8},
    {"isoxml_sh2020_TLG00005.csv", "iso-timelogs/ValidTimeLogs-PFD-6", 15381.7, 18226.3, 15685.0, 14811.1},
    {"isoxml_sh2020_TLG00008.csv", "iso-timelogs/ValidTimeLogs-PFD-8", 57175.9, 64850.0, 56620.8, 54577.0},
};

/// The mode those figures were found in.
EvaluateSettings by_segments() {
  EvaluateSettings out;
  out.drive.quads = coverage::QuadShape::kSegment;
  out.drive.switching = coverage::Switching::kStep;
  return out;
}

class RealCoverage : public ::testing::Test {
 protected:
  void SetUp() override {
    fields_ = read_real_fields();
    if (!fields_) GTEST_SKIP() << no_real_fields();
  }

  std::optional<RealFields> fields_;
};

TEST_F(RealCoverage, HarvestsAreAsOtherProgramsFoundThem) {
  for (const Harvest& harvest : kHarvests) {
    SCOPED_TRACE(harvest.log);
    const Field field = field_named(*fields_, harvest.partfield);
    const WorkLog log = real_log(harvest.log, field.frame);
    const Coverage done = coverage::evaluate(log, ground_of(field), by_segments(), {});
    EXPECT_NEAR(area_m2(field), harvest.field_m2, 1e-3 * harvest.field_m2);
    EXPECT_NEAR(done.areas.gross_m2, harvest.gross_m2, 1e-3 * harvest.gross_m2);
    EXPECT_NEAR(done.areas.covered_m2, harvest.union_m2, 1e-3 * harvest.union_m2);
    EXPECT_NEAR(done.areas.covered_inside_m2, harvest.inside_m2, 1e-3 * harvest.inside_m2);
    EXPECT_NEAR(done.areas.missed_m2, harvest.field_m2 - harvest.inside_m2, 1e-3 * harvest.inside_m2);
  }
}

// The areas kept while driving are those of the union of all quads, and so are the regions.
TEST_F(RealCoverage, TheStreamIsTheBatch) {
  for (const Harvest& harvest : {kHarvests[2], kHarvests[3]}) {
    SCOPED_TRACE(harvest.log);
    const Field field = field_named(*fields_, harvest.partfield);
    const BatchDifference found =
        stream_against_batch(real_log(harvest.log, field.frame), ground_of(field), {});
    EXPECT_LT(found.areas, 1e-6) << "of the worked area";
    EXPECT_LT(found.regions, 1e-6) << "of the worked area";
  }
}

// No log crashes, whatever is in it, and each has worked some ground that no figure contradicts.
TEST_F(RealCoverage, EveryLogIsEvaluated) {
  for (const std::string& name : real_logs()) {
    SCOPED_TRACE(name);
    const WorkLog log = real_log(name);
    EvaluateSettings settings;
    settings.drive.width_m = 6;  // where the log does not say
    const Coverage done = coverage::evaluate(log, {}, settings, {});
    const CoverageAreas& areas = done.areas;
    const double tolerance_m2 = 1e-6 * areas.gross_m2 + 1e-9;
    EXPECT_GT(areas.covered_m2, 10) << "every one of them was recorded at work";
    EXPECT_LE(areas.covered_m2, areas.gross_m2 + tolerance_m2);
    EXPECT_LE(areas.repeated_m2 + areas.sliver_m2, areas.covered_m2 + tolerance_m2);
    EXPECT_NEAR(areas.worked_times_m2[2] + areas.worked_times_m2[3], areas.repeated_m2 + areas.sliver_m2,
                tolerance_m2);
    EXPECT_NEAR(area(done.covered), areas.covered_m2, tolerance_m2);
    EXPECT_EQ(done.fixes, done.fixes_used + done.skipped.count);
  }
}

}  // namespace
}  // namespace tramline::testing
