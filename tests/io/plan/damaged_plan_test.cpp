// Plan files changed by others, or by chance: a sentence, never a crash.

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "io/changed_file.h"
#include "support/refusals.h"
#include "support/small_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using testing_support::mentions;
using testing_support::read_damaged_copies;
using testing_support::refusal_of_file;
using testing_support::run_sql;
using testing_support::small_plan;

namespace fs = std::filesystem;

class DamagedPlan : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() / ("tramline-damaged-" + std::to_string(getpid()) + ".gpkg");
    io::write_plan(small_plan(), file_);
  }
  void TearDown() override { fs::remove(file_); }

  /// What reading says after a change made through GDAL; "" when it says nothing.
  std::string after_sql(const char* statement) const {
    io::write_plan(small_plan(), file_);
    run_sql(file_, statement);
    return read();
  }
  std::string read() const {
    return refusal_of_file(file_, [this] { io::read_plan_file(file_); });
  }
  fs::path file_;
};

TEST_F(DamagedPlan, MissingPartsAreNamed) {
  EXPECT_EQ(read(), "");
  EXPECT_TRUE(mentions(after_sql("DROP TABLE swaths"), "'swaths'"));
  EXPECT_TRUE(mentions(after_sql("DELETE FROM metadata WHERE key = 'cost'"), "'cost'"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = NULL WHERE key = 'cost'"), "layer metadata"));
  EXPECT_TRUE(
      mentions(after_sql("UPDATE metadata SET value = '3,0' WHERE key = 'machine.width_m'"), "'3,0'"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = 'inf' WHERE key = 'cost'"), "finite"));
  EXPECT_TRUE(
      mentions(after_sql("UPDATE metadata SET value = 'round' WHERE key = 'settings.end_rule'"), "'round'"));
  EXPECT_TRUE(
      mentions(after_sql("UPDATE metadata SET value = '1' WHERE key = 'format_version'"), "format_version"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = '[1]' WHERE key = 'warnings'"), "JSON list"));
  EXPECT_TRUE(mentions(after_sql("UPDATE tracks SET geom = NULL WHERE fid = 2"), "layer tracks, feature 2"));
  EXPECT_TRUE(mentions(after_sql("UPDATE tracks SET subfield = NULL WHERE fid = 1"), "subfield"));
  EXPECT_TRUE(mentions(after_sql("DELETE FROM field"), "0 features"));
}

TEST_F(DamagedPlan, ChangedFiguresAreReadBesideWhatTheShapesSay) {
  EXPECT_EQ(after_sql("UPDATE tracks SET length_m = 5 WHERE fid = 2"), "");
  const io::PlanFile file = io::read_plan_file(file_);
  int apart = 0;
  for (const io::DerivedNumber& number : file.derived)
    if (std::abs(number.stored - number.from_shape) > 1e-6) ++apart;
  EXPECT_EQ(apart, 1);
}

TEST_F(DamagedPlan, DeletedTracksLeaveAGapInTheOrder) {
  EXPECT_EQ(after_sql("DELETE FROM tracks WHERE fid = 1"), "");
  EXPECT_EQ(io::read_plan_file(file_).track_order, std::vector<int>{2});
}

/// Whatever the bytes, reading ends in a plan or in one sentence.
TEST_F(DamagedPlan, RandomBytesNeverCrashTheReader) {
  read_damaged_copies(file_, [this] { read(); });
}

}  // namespace
}  // namespace tramline
