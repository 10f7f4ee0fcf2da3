// Coverage files changed by others or by chance, and files of another kind: a sentence, never a crash.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "io/changed_file.h"
#include "io/coverage/two_passes.h"
#include "support/refusals.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/coverage/write_coverage.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using testing_support::mentions;
using testing_support::read_damaged_copies;
using testing_support::refusal_of_file;
using testing_support::run_sql;

namespace fs = std::filesystem;

Coverage with_slices() {
  Coverage out = two_passes();
  out.slices = {{5, out.areas, 1, 1, {}, 0.5}};
  return out;
}

class DamagedCoverage : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() / ("tramline-damaged-coverage-" + std::to_string(getpid()) + ".gpkg");
    io::write_coverage(with_slices(), file_);
  }
  void TearDown() override { fs::remove(file_); }

  /// What reading says after a change made through GDAL; "" when it says nothing.
  std::string after_sql(const std::string& statement) const {
    io::write_coverage(with_slices(), file_);
    run_sql(file_, statement);
    return read();
  }
  std::string read() const {
    return refusal_of_file(file_, [this] { io::read_coverage(file_); });
  }
  fs::path file_;
};

TEST_F(DamagedCoverage, MissingPartsAreNamed) {
  EXPECT_EQ(read(), "");
  for (const std::string layer :
       {"field", "covered", "repeated", "missed", "not_recorded", "multiplicity", "gaps", "track"})
    EXPECT_TRUE(mentions(after_sql("DROP TABLE " + layer), "'" + layer + "'")) << layer;
  EXPECT_EQ(after_sql("DROP TABLE layer_styles"), "");
  EXPECT_EQ(after_sql("DROP TABLE slices"), "");
  EXPECT_TRUE(mentions(after_sql("DELETE FROM metadata WHERE key = 'areas.missed_m2'"), "'areas.missed_m2'"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = '20,0' WHERE key = 'width_m'"), "'20,0'"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = '' WHERE key = 'width_m'"), "width_m"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = 'inf' WHERE key = 'worked_s'"), "finite"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = '-1' WHERE key = 'fixes'"), "'-1'"));
  EXPECT_TRUE(mentions(after_sql("UPDATE metadata SET value = '{\"record\":1}' WHERE key = 'skipped.listed'"),
                       "JSON list"));
  EXPECT_TRUE(
      mentions(after_sql("UPDATE metadata SET value = '3' WHERE key = 'format_version'"), "format_version"));
  EXPECT_TRUE(mentions(after_sql("UPDATE covered SET geom = NULL"), "layer covered, feature 1"));
  EXPECT_TRUE(mentions(after_sql("UPDATE gaps SET number = NULL"), "number"));
  EXPECT_TRUE(mentions(after_sql("UPDATE gaps SET x = 9e999"), "layer gaps, feature 1"));
  EXPECT_TRUE(mentions(after_sql("UPDATE track SET run = 0 WHERE fid = 2"), "layer track, feature 2: run"));
  EXPECT_TRUE(mentions(after_sql("UPDATE multiplicity SET times = 4 WHERE fid = 1"), "times is 4"));
  EXPECT_TRUE(mentions(after_sql("UPDATE multiplicity SET times = 2 WHERE fid = 1"), "times is 2 again"));
  EXPECT_TRUE(mentions(after_sql("UPDATE slices SET fixes = -5"), "fixes is negative"));
}

// Version 1 knew nothing of ground that was not recorded.
TEST_F(DamagedCoverage, OlderFilesAreRead) {
  io::write_coverage(with_slices(), file_);
  for (const char* statement :
       {"DROP TABLE not_recorded", "DELETE FROM metadata WHERE key = 'areas.not_recorded_m2'",
        "ALTER TABLE slices DROP COLUMN not_recorded_m2",
        "UPDATE metadata SET value = '1' WHERE key = 'format_version'"})
    run_sql(file_, statement);
  const Coverage read = io::read_coverage(file_);
  EXPECT_TRUE(read.not_recorded.empty());
  EXPECT_EQ(read.areas.not_recorded_m2, 0);
  EXPECT_EQ(read.slices.at(0).areas.not_recorded_m2, 0);
  EXPECT_EQ(read.areas.missed_m2, with_slices().areas.missed_m2);
}

TEST_F(DamagedCoverage, FilesOfAnotherKindAreToldApart) {
  Plan plan;
  plan.field.outer = {{0, 0}, {10, 0}, {10, 10}};
  io::write_plan(plan, file_);
  EXPECT_TRUE(mentions(read(), "'tramline coverage'")) << read();
  EXPECT_TRUE(mentions(read(), "'tramline plan'")) << read();

  io::write_coverage(two_passes(), file_);
  try {
    io::read_plan(file_);
    ADD_FAILURE() << "a coverage file was read as a plan";
  } catch (const Error& error) {
    EXPECT_TRUE(mentions(error.what(), "'tramline coverage'")) << error.what();
  }

  std::ofstream(file_, std::ios::trunc) << "lon,lat\n13,52\n";
  EXPECT_TRUE(mentions(read(), "tramline evaluate")) << read();
  fs::remove(file_);
  EXPECT_TRUE(mentions(read(), "no such file"));

  RegisterOGRGeoPackage();
  {
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
    const GDALDatasetUniquePtr data(driver->Create(file_.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    data->CreateLayer("parcels", nullptr, wkbPolygon);
  }
  EXPECT_TRUE(mentions(read(), "'metadata'")) << read();
  EXPECT_TRUE(mentions(read(), "coverage file written by tramline evaluate")) << read();
}

TEST_F(DamagedCoverage, AFileCutOffIsKnownAtOnce) {
  fs::resize_file(file_, fs::file_size(file_) - 5000);
  EXPECT_TRUE(mentions(read(), "cut off"));
}

/// Whatever the bytes, reading ends in an evaluation or in one sentence.
TEST_F(DamagedCoverage, RandomBytesNeverCrashTheReader) {
  read_damaged_copies(file_, [this] { read(); });
}

}  // namespace
}  // namespace tramline
