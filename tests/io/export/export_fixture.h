#pragma once
// A plan in a file to export, and what was exported read back.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline::io {

/// A field near Neubrandenburg with a track of 3 km across degrees, one with a detour, and layers with
/// nothing in them.
Plan sample_plan();

class ExportTest : public testing::Test {
 protected:
  void SetUp() override {
    GDALAllRegister();
    unsetenv("SOURCE_DATE_EPOCH");
    write_plan(sample_plan(), plan_file());
  }
  void TearDown() override { unsetenv("SOURCE_DATE_EPOCH"); }
  std::filesystem::path plan_file() const { return folder_ / "plan.gpkg"; }
  /// Every vertex as it is, where no tolerance is given.
  ExportReport exported(const char* name, const char* crs = "", const std::vector<std::string>& layers = {},
                        double tolerance_m = 0) const {
    return export_plan({plan_file(), folder_ / name, crs, layers, tolerance_m});
  }
  std::optional<std::string> refusal(const char* name, const char* crs = "",
                                     const std::vector<std::string>& layers = {}) const {
    try {
      exported(name, crs, layers);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      EXPECT_FALSE(std::filesystem::exists(folder_ / name));
      return error.what();
    }
    return std::nullopt;
  }
  GDALDatasetUniquePtr open(const std::string& path) const {
    GDALDatasetUniquePtr out(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
    EXPECT_NE(out, nullptr) << path;
    return out;
  }
  testing_support::TemporaryFolder folder_;
};

/// A line, or the outer ring of a polygon.
const OGRSimpleCurve* curve_of(const OGRGeometry* shape);

}  // namespace tramline::io
