// Plan files changed by others, or by chance: a sentence, never a crash.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>

#include "support/refusals.h"
#include "support/small_plan.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using testing_support::bytes_of;
using testing_support::damaged;
using testing_support::mentions;
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
  std::string after(const std::function<void(GDALDataset&)>& change) const {
    io::write_plan(small_plan(), file_);
    {
      CPLPushErrorHandler(CPLQuietErrorHandler);
      const GDALDatasetUniquePtr data(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
      change(*data);
      CPLPopErrorHandler();
    }
    return read();
  }
  std::string after_sql(const char* statement) const {
    return after([&](GDALDataset& data) { data.ExecuteSQL(statement, nullptr, nullptr); });
  }
  std::string read() const {
    try {
      io::read_plan_file(file_);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      EXPECT_NE(std::string(error.what()).find(file_.filename().string()), std::string::npos) << error.what();
      return error.what();
    }
    return "";
  }
  fs::path file_;
};

TEST_F(DamagedPlan, missing_parts_are_named) {
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

TEST_F(DamagedPlan, changed_figures_are_read_beside_what_the_shapes_say) {
  EXPECT_EQ(after_sql("UPDATE tracks SET length_m = 5 WHERE fid = 2"), "");
  const io::PlanFile file = io::read_plan_file(file_);
  int apart = 0;
  for (const io::DerivedNumber& number : file.derived)
    if (std::abs(number.stored - number.from_shape) > 1e-6) ++apart;
  EXPECT_EQ(apart, 1);
}

TEST_F(DamagedPlan, deleted_tracks_leave_a_gap_in_the_order) {
  EXPECT_EQ(after_sql("DELETE FROM tracks WHERE fid = 1"), "");
  EXPECT_EQ(io::read_plan_file(file_).track_order, std::vector<int>{2});
}

/// Whatever the bytes, reading ends in a plan or in one sentence.
TEST_F(DamagedPlan, random_bytes_never_crash_the_reader) {
  const std::string whole = bytes_of(file_);
  std::mt19937 random(3);
  for (int i = 0; i < 150; ++i) {
    std::ofstream(file_, std::ios::binary) << damaged(whole, 1 + i, random);
    read();
  }
}

}  // namespace
}  // namespace tramline
