// How numbers look in plan files.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <numbers>
#include <regex>

#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

namespace fs = std::filesystem;

/// Negative zeros wherever arithmetic may leave one; of the kinds of shape one each.
Plan plan_of_negative_zeros(bool geodetic) {
  const double zero = -0.0;
  const Ring ring{{zero, zero}, {10, zero}, {10, 10}, {zero, 10}};
  Plan plan;
  plan.field.id = "zeros";
  plan.field.outer = ring;
  plan.field.frame = {geodetic, zero, zero, zero, zero};
  plan.field.repairs = {{"hole", "hole 1", {zero, zero}, zero}};
  plan.field.obstacles = {{{ring, {}}, ObstacleKind::kObstacle, ""}};
  plan.body = {{ring, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::radians(zero))}};
  TrackPiece piece{{zero, zero}, {10, zero}, 0, 0};
  piece.detours = {{{{{zero, zero}, {10, zero}, zero}}, Passing::kLeft, {0}}};
  plan.pieces = {piece, {{zero, zero}, {zero, 10}, 0, 1}};
  plan.dropped = {{{zero, zero}, {zero, 1}, 0}};
  plan.encounters = {{0, 0, {zero, zero}, {0}, Passing::kLeft, {true, zero, ""}, {true, zero, ""}}};
  plan.tally.overlap_m2 = zero;
  plan.cost = zero;
  plan.settings.clearance_m = zero;
  plan.settings.merge_threshold = Angle::degrees(zero);
  return plan;
}

bool negative_zero(double value) { return value == 0 && std::signbit(value); }

void expect_plain(const OGRGeometry* shape, const std::string& place) {
  if (shape == nullptr) return;
  char* text = nullptr;
  shape->exportToWkt(&text);
  EXPECT_FALSE(std::regex_search(text, std::regex("-0[ ,)]"))) << place << ": " << text;
  CPLFree(text);
}

/// Every coordinate, number and text of the file. Returns how many features there are.
int expect_no_negative_zero(const fs::path& file) {
  const std::regex in_text(R"((^|[^0-9.e])-0(\.0*)?($|[^0-9.]))");
  int features = 0;
  const GDALDatasetUniquePtr data(GDALDataset::Open(file.c_str(), GDAL_OF_VECTOR));
  for (OGRLayer* layer : data->GetLayers()) {
    for (const OGRFeatureUniquePtr& feature : *layer) {
      ++features;
      const std::string place = std::string(layer->GetName()) + " " + std::to_string(feature->GetFID());
      expect_plain(feature->GetGeometryRef(), place);
      for (int i = 0; i < feature->GetFieldCount(); ++i) {
        const std::string text = feature->GetFieldAsString(i);
        EXPECT_FALSE(std::regex_search(text, in_text)) << place << ": " << text;
        if (feature->GetFieldDefnRef(i)->GetType() == OFTReal) {
          EXPECT_FALSE(negative_zero(feature->GetFieldAsDouble(i)))
              << place << ", " << feature->GetFieldDefnRef(i)->GetNameRef();
        }
      }
    }
  }
  return features;
}

TEST(PlainNumbers, ZeroHasNoSign) {
  for (const bool geodetic : {false, true}) {
    const fs::path file =
        fs::temp_directory_path() / ("tramline-zeros-" + std::to_string(getpid()) + ".gpkg");
    io::write_plan(plan_of_negative_zeros(geodetic), file);
    EXPECT_GT(expect_no_negative_zero(file), 10);
    fs::remove(file);
  }
}

TEST(PlainNumbers, DegreesAreThoseThatWereAskedFor) {
  Plan plan;
  for (int tenths = 0; tenths <= 3600; ++tenths) {
    plan.settings.merge_threshold = Angle::degrees(tenths / 10.0);
    const std::string written = io::metadata_of(plan)["settings.merge_threshold_deg"];
    std::string asked = std::to_string(tenths / 10);
    if (tenths % 10 != 0) asked.append(1, '.').append(std::to_string(tenths % 10));
    EXPECT_EQ(written, asked);
  }
}

// Degrees nobody typed: not shortened beyond what the radians say.
TEST(PlainNumbers, DegreesAreTrue) {
  Plan plan;
  for (int i = 1; i <= 1000; ++i) {
    const double radians = std::fmod(i * std::numbers::phi, std::numbers::pi);
    plan.settings.merge_threshold = Angle::radians(radians);
    io::Metadata metadata = io::metadata_of(plan);
    EXPECT_EQ(std::stod(metadata["settings.merge_threshold_rad"]), radians);
    const double degrees = std::stod(metadata["settings.merge_threshold_deg"]);
    EXPECT_LE(std::abs(degrees - radians * 180 / std::numbers::pi), 1e-15 * 180);
  }
}

TEST(PlainNumbers, AreAsShortAsReadingBackAllows) {
  Plan plan;
  plan.settings.clearance_m = 0.1;
  plan.machine.width_m = 1.0 / 3;
  io::Metadata metadata = io::metadata_of(plan);
  EXPECT_EQ(metadata["settings.clearance_m"], "0.1");
  EXPECT_EQ(std::stod(metadata["machine.width_m"]), 1.0 / 3);
}

}  // namespace
}  // namespace tramline
