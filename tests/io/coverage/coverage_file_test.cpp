// Coverage files: what is written comes back, GDAL finds the areas it says, the same evaluation gives the
// same bytes, and a failure leaves nothing behind.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <numbers>

#include "io/coverage/two_passes.h"
#include "support/refusals.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/coverage/read_coverage.h"
#include "tramline/io/coverage/write_coverage.h"

namespace tramline {
namespace {

using testing_support::bytes_of;
using testing_support::error_of;
using testing_support::TemporaryFolder;

namespace fs = std::filesystem;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

/// The passes turned and moved, so that no number has few decimals, over a field with an obstacle and with
/// names and remarks that need quoting.
Coverage odd_passes() {
  Coverage out = two_passes();
  const double c = std::cos(0.3), s = std::sin(0.3);
  const auto move = [&](Point& p) { p = {c * p.x - s * p.y + 1.0 / 3, s * p.x + c * p.y - 0.1}; };
  const auto move_ring = [&](Ring& ring) { std::for_each(ring.begin(), ring.end(), move); };
  const auto move_region = [&](Region& region) {
    for (Polygon& polygon : region) {
      move_ring(polygon.outer);
      std::for_each(polygon.holes.begin(), polygon.holes.end(), move_ring);
    }
  };
  out.not_recorded = {{box_ring(2, 30, 6, 38), {}}};
  out.areas.not_recorded_m2 = 32 + 1.0 / 3;
  out.field[0].holes = {reversed(box_ring(2, 2, 3, 3)), reversed(box_ring(5, 5, 7, 6))};
  for (Region* region : {&out.field, &out.covered, &out.repeated, &out.missed, &out.not_recorded,
                         &out.worked_times[1], &out.worked_times[2]})
    move_region(*region);
  for (Gap& gap : out.gaps) {
    move_ring(gap.shape.outer);
    move(gap.centre);
    gap.area_m2 += 0.1;
    gap.widest_m = 4 + 1.0 / 3;
  }
  for (DrivenLine& driven : out.lines) std::for_each(driven.line.begin(), driven.line.end(), move);
  out.frame = {true, 13.123456789012345, 52.98765432109876, 0, 0};
  out.log = "TASKDATA.zip/TLG00001 \"é\" 'x'";
  out.field_id = "north \"40\" 'acre' é";
  out.width_m = 20 + 1.0 / 3;
  out.areas.gross_m2 += 0.1;
  out.areas.sliver_m2 = 1e-7 / 3;
  out.worked_s = 42 + 1.0 / 3;
  out.fixes = 5'000'000'000;
  out.slices = {
      {100, {1, 2, 3, 4, 5, 6, 7, 7.5, {8, 9, 10, 11}}, 12, 13, {}, 0.1},
      {200, {1.1, 2, 3, 4, 5, 6, kNan, kNan, {kNan, kNan, kNan, kNan}}, 5'000'000'000, 23, {}, 1.0 / 3}};
  return out;
}

class CoverageFileTest : public testing::Test {
 protected:
  void SetUp() override { unsetenv("SOURCE_DATE_EPOCH"); }
  fs::path file() const { return folder_ / "coverage.gpkg"; }
  TemporaryFolder folder_;
};

/// Every number of the areas, for comparison to the bit; NaN equals NaN.
std::vector<double> numbers_of(const CoverageAreas& areas) {
  std::vector<double> out{areas.gross_m2,   areas.covered_m2,     areas.covered_inside_m2,
                          areas.outside_m2, areas.repeated_m2,    areas.sliver_m2,
                          areas.missed_m2,  areas.not_recorded_m2};
  out.insert(out.end(), areas.worked_times_m2.begin(), areas.worked_times_m2.end());
  for (double& number : out)
    if (std::isnan(number)) number = -1;
  return out;
}

void expect_same_numbers(const Coverage& a, const Coverage& b) {
  EXPECT_EQ(a.log, b.log);
  EXPECT_EQ(a.field_id, b.field_id);
  EXPECT_EQ(a.frame, b.frame);
  EXPECT_EQ(a.width_m, b.width_m);
  EXPECT_EQ(a.engine, b.engine);
  EXPECT_EQ(numbers_of(a.areas), numbers_of(b.areas));
  EXPECT_EQ(a.fixes, b.fixes);
  EXPECT_EQ(a.fixes_used, b.fixes_used);
  EXPECT_EQ(a.runs, b.runs);
  EXPECT_EQ(a.worked_s, b.worked_s);
  EXPECT_EQ(a.skipped.count, b.skipped.count);
  ASSERT_EQ(a.skipped.listed.size(), b.skipped.listed.size());
  for (std::size_t i = 0; i < a.skipped.listed.size(); ++i) {
    EXPECT_EQ(a.skipped.listed[i].record, b.skipped.listed[i].record);
    EXPECT_EQ(a.skipped.listed[i].why, b.skipped.listed[i].why);
  }
  EXPECT_EQ(a.warnings, b.warnings);
  ASSERT_EQ(a.slices.size(), b.slices.size());
  for (std::size_t i = 0; i < a.slices.size(); ++i) {
    EXPECT_EQ(a.slices[i].fixes, b.slices[i].fixes);
    EXPECT_EQ(numbers_of(a.slices[i].areas), numbers_of(b.slices[i].areas));
    EXPECT_EQ(a.slices[i].covered_rings, b.slices[i].covered_rings);
    EXPECT_EQ(a.slices[i].missed_regions, b.slices[i].missed_regions);
    EXPECT_EQ(a.slices[i].seconds, b.slices[i].seconds);
  }
}

TEST_F(CoverageFileTest, ComesBackToTheBit) {
  const Coverage coverage = odd_passes();
  io::write_coverage(coverage, file());
  const Coverage read = io::read_coverage(file());
  expect_same_numbers(read, coverage);
  EXPECT_EQ(read.field, coverage.field);
  EXPECT_EQ(read.covered, coverage.covered);
  EXPECT_EQ(read.repeated, coverage.repeated);
  EXPECT_EQ(read.missed, coverage.missed);
  EXPECT_EQ(read.not_recorded, coverage.not_recorded);
  EXPECT_TRUE(read.worked_times[0].empty());
  // Of the two parts worked once the western one has 16·40 m², the eastern one 20·5 m² more: it comes first.
  EXPECT_EQ(read.worked_times[1], (Region{coverage.worked_times[1][1], coverage.worked_times[1][0]}));
  EXPECT_EQ(read.worked_times[2], coverage.worked_times[2]);
  EXPECT_TRUE(read.worked_times[3].empty());
  ASSERT_EQ(read.gaps.size(), 1u);
  EXPECT_EQ(read.gaps[0].number, 1);
  EXPECT_EQ(read.gaps[0].shape, coverage.gaps[0].shape);
  EXPECT_EQ(read.gaps[0].centre, coverage.gaps[0].centre);
  EXPECT_EQ(read.gaps[0].area_m2, coverage.gaps[0].area_m2);
  EXPECT_EQ(read.gaps[0].widest_m, coverage.gaps[0].widest_m);
  ASSERT_EQ(read.lines.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(read.lines[i].run, coverage.lines[i].run);
    EXPECT_EQ(read.lines[i].line, coverage.lines[i].line);
    EXPECT_EQ(read.lines[i].from_s, coverage.lines[i].from_s);
    EXPECT_EQ(read.lines[i].to_s, coverage.lines[i].to_s);
  }
}

TEST_F(CoverageFileTest, APlainFrameIsWrittenInTheInputPlane) {
  Coverage coverage = odd_passes();
  coverage.frame = {false, 0, 0, 500123.4, 5800456.7};
  io::write_coverage(coverage, file());
  const Coverage read = io::read_coverage(file());
  EXPECT_EQ(read.frame, coverage.frame);
  ASSERT_EQ(read.covered.size(), 1u);
  ASSERT_EQ(read.covered[0].outer.size(), coverage.covered[0].outer.size());
  for (std::size_t i = 0; i < coverage.covered[0].outer.size(); ++i)
    EXPECT_LT(distance(read.covered[0].outer[i], coverage.covered[0].outer[i]), 1e-9);
  EXPECT_LT(distance(read.gaps[0].centre, coverage.gaps[0].centre), 1e-9);
  EXPECT_LT(distance(read.lines[1].line[1], coverage.lines[1].line[1]), 1e-9);

  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  ASSERT_NE(data, nullptr);
  const OGRFeatureUniquePtr gap(data->GetLayerByName("gaps")->GetNextFeature());
  EXPECT_NEAR(gap->GetFieldAsDouble("x"), 500123.4 + coverage.gaps[0].centre.x, 1e-9);
  EXPECT_FALSE(gap->IsFieldSetAndNotNull(gap->GetFieldIndex("lon_deg")));
}

/// What GDAL, which knows nothing of ours, measures and counts.
TEST_F(CoverageFileTest, GdalFindsTheLayersAndTheirFigures) {
  io::write_coverage(two_passes(), file());
  RegisterOGRGeoPackage();
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  ASSERT_NE(data, nullptr);
  const auto areas = [&](const char* name) {
    std::vector<double> out;
    OGRLayer* layer = data->GetLayerByName(name);
    if (layer == nullptr) return out;
    for (const auto& feature : *layer) {
      const OGRGeometry* shape = feature->GetGeometryRef();
      const double measured = wkbFlatten(shape->getGeometryType()) == wkbPolygon
                                  ? shape->toPolygon()->get_Area()
                                  : shape->toMultiPolygon()->get_Area();
      EXPECT_EQ(feature->GetFieldAsDouble("area_m2"), measured) << name;
      out.push_back(measured);
    }
    return out;
  };
  using Areas = std::vector<double>;
  EXPECT_EQ(areas("field"), (Areas{1600}));
  EXPECT_EQ(areas("covered"), (Areas{1540}));
  EXPECT_EQ(areas("repeated"), (Areas{160}));
  EXPECT_EQ(areas("missed"), (Areas{160}));
  EXPECT_EQ(areas("multiplicity"), (Areas{1380, 160}));
  EXPECT_EQ(areas("gaps"), (Areas{160}));

  std::vector<std::string> runs;
  std::vector<double> lengths;
  for (const auto& feature : *data->GetLayerByName("track")) {
    const int run = feature->GetFieldIndex("run");
    runs.push_back(feature->IsFieldSetAndNotNull(run) ? feature->GetFieldAsString(run) : "NULL");
    lengths.push_back(feature->GetFieldAsDouble("length_m"));
  }
  EXPECT_EQ(runs, (std::vector<std::string>{"1", "NULL", "2"}));
  EXPECT_EQ(lengths[0], 40);
  EXPECT_DOUBLE_EQ(lengths[1], std::sqrt(208) + std::sqrt(113));
  EXPECT_EQ(lengths[2], 45);

  std::map<std::string, std::string> metadata;
  for (const auto& row : *data->GetLayerByName("metadata"))
    metadata[row->GetFieldAsString("key")] = row->GetFieldAsString("value");
  EXPECT_EQ(metadata["format"], "tramline coverage");
  EXPECT_EQ(metadata["format_version"], "2");
  EXPECT_EQ(metadata["areas.covered_m2"], "1540");
  EXPECT_EQ(metadata["areas.worked_times_1_m2"], "1380");
  EXPECT_EQ(metadata["field.id"], "square");
  EXPECT_EQ(metadata["log"], "drive.csv");
  EXPECT_EQ(metadata["engine"], "exact");
  EXPECT_EQ(metadata["runs"], "2");
  EXPECT_EQ(metadata["skipped.listed"], R"([{"record":3,"why":"no position"}])");
  EXPECT_FALSE(metadata["program_version"].empty());
  EXPECT_EQ(data->GetLayerByName("slices"), nullptr);
}

/// M = a(1 − e²) / (1 − e² sin²φ)^1.5 metres of northing make a radian of latitude. Over 20 m M changes by
/// 1e-8 of itself, so the formula is good to a micrometre.
TEST_F(CoverageFileTest, GapsHaveAPlaceOnEarth) {
  Coverage coverage = two_passes();
  coverage.gaps[0].centre = {0, 20};
  io::write_coverage(coverage, file());
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  const OGRFeatureUniquePtr gap(data->GetLayerByName("gaps")->GetNextFeature());
  const double sine = std::sin(52 * std::numbers::pi / 180), e2 = 0.00669437999014;
  const double meridian_m = 6378137.0 * (1 - e2) / std::pow(1 - e2 * sine * sine, 1.5);
  EXPECT_NEAR(gap->GetFieldAsDouble("lon_deg"), 13, 1e-12);
  EXPECT_NEAR(gap->GetFieldAsDouble("lat_deg"), 52 + 20 / meridian_m * 180 / std::numbers::pi, 1e-11);
  EXPECT_EQ(gap->GetFieldAsDouble("x"), 0);
  EXPECT_EQ(gap->GetFieldAsDouble("y"), 20);
  EXPECT_EQ(gap->GetFieldAsDouble("widest_m"), 4);
}

TEST_F(CoverageFileTest, PolygonsAreSortedBySizeThenFromWestAndSouth) {
  const Polygon large{box_ring(50, 50, 53, 53), {}}, east{box_ring(9, 0, 11, 1), {}},
      north{box_ring(3, 8, 5, 9), {}}, south{box_ring(3, 1, 4, 3), {}};
  for (const Region& given : {Region{east, south, large, north}, Region{north, large, south, east}}) {
    Coverage coverage = two_passes();
    coverage.field = coverage.covered = coverage.repeated = coverage.missed = given;
    io::write_coverage(coverage, file());
    const Coverage read = io::read_coverage(file());
    const Region sorted{large, south, north, east};
    EXPECT_EQ(read.field, sorted);
    EXPECT_EQ(read.covered, sorted);
    EXPECT_EQ(read.repeated, sorted);
    EXPECT_EQ(read.missed, sorted);
  }
}

TEST_F(CoverageFileTest, AnEvaluationOfNothingHasEveryLayer) {
  io::write_coverage(Coverage{}, file());
  const Coverage read = io::read_coverage(file());
  EXPECT_TRUE(read.field.empty());
  EXPECT_TRUE(read.covered.empty());
  EXPECT_TRUE(read.lines.empty());
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  for (const char* layer :
       {"field", "covered", "repeated", "missed", "not_recorded", "multiplicity", "gaps", "track"}) {
    ASSERT_NE(data->GetLayerByName(layer), nullptr) << layer;
    EXPECT_EQ(data->GetLayerByName(layer)->GetFeatureCount(), 0) << layer;
  }
}

TEST_F(CoverageFileTest, WhatIsNotKnownComesBackAsNotKnown) {
  Coverage coverage = two_passes();
  coverage.worked_s = kNan;
  coverage.areas.worked_times_m2.fill(kNan);
  coverage.worked_times = {};
  coverage.gaps[0].widest_m = kNan;
  coverage.lines[0].from_s = coverage.lines[0].to_s = kNan;
  io::write_coverage(coverage, file());
  const Coverage read = io::read_coverage(file());
  EXPECT_TRUE(std::isnan(read.worked_s));
  for (const double m2 : read.areas.worked_times_m2) EXPECT_TRUE(std::isnan(m2));
  EXPECT_TRUE(std::isnan(read.gaps[0].widest_m));
  EXPECT_TRUE(std::isnan(read.lines[0].from_s));
  EXPECT_EQ(read.lines[1].from_s, 120);
}

/// Areas that were counted without their shapes make features all the same.
TEST_F(CoverageFileTest, CountedAreasNeedNoShape) {
  Coverage coverage = two_passes();
  coverage.worked_times = {};
  io::write_coverage(coverage, file());
  EXPECT_TRUE(io::read_coverage(file()).worked_times[1].empty());
  const GDALDatasetUniquePtr data(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
  OGRLayer* layer = data->GetLayerByName("multiplicity");
  ASSERT_EQ(layer->GetFeatureCount(), 2);
  EXPECT_EQ(OGRFeatureUniquePtr(layer->GetNextFeature())->GetFieldAsDouble("area_m2"), 1380);
}

TEST_F(CoverageFileTest, AMachineThatStoodHasItsPlace) {
  Coverage coverage = two_passes();
  coverage.lines = {{0, {{3, 4}}, 0, 1}, {-1, {}, 1, 2}};
  io::write_coverage(coverage, file());
  const Coverage read = io::read_coverage(file());
  ASSERT_EQ(read.lines.size(), 2u);
  EXPECT_EQ(read.lines[0].line, (std::vector<Point>{{3, 4}, {3, 4}}));
  EXPECT_TRUE(read.lines[1].line.empty());
}

TEST_F(CoverageFileTest, TheSameEvaluationGivesTheSameBytes) {
  io::write_coverage(odd_passes(), file());
  usleep(5000);
  io::write_coverage(odd_passes(), folder_ / "other.gpkg");
  EXPECT_EQ(bytes_of(file()), bytes_of(folder_ / "other.gpkg"));
  io::write_coverage(io::read_coverage(file()), folder_ / "again.gpkg");
  EXPECT_EQ(bytes_of(file()), bytes_of(folder_ / "again.gpkg"));
  EXPECT_EQ(folder_.entries(), 3u);
}

TEST_F(CoverageFileTest, TimeStampsFollowSourceDateEpoch) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  io::write_coverage(two_passes(), file());
  EXPECT_NE(bytes_of(file()).find("2023-11-14T22:13:20.000Z"), std::string::npos);
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST_F(CoverageFileTest, OnlyGeopackages) {
  for (const char* name : {"coverage.shp", "coverage", "coverage.gpkg.zip"}) {
    const Error error = error_of([&] { io::write_coverage(two_passes(), folder_ / name); });
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find(".gpkg"), std::string::npos);
  }
  EXPECT_EQ(folder_.entries(), 0u);
  io::write_coverage(two_passes(), folder_ / "COVERAGE.GPKG");
  EXPECT_EQ(io::read_coverage(folder_ / "COVERAGE.GPKG").covered, two_passes().covered);
}

TEST_F(CoverageFileTest, WhatCannotBeWrittenLeavesNothingBehind) {
  const Error error = error_of([&] { io::write_coverage(two_passes(), folder_ / "missing/coverage.gpkg"); });
  EXPECT_EQ(error.kind(), ErrorKind::kFailure);
  EXPECT_EQ(folder_.entries(), 0u);
  fs::create_directories(file() / "full");
  EXPECT_EQ(error_of([&] { io::write_coverage(two_passes(), file()); }).kind(), ErrorKind::kFailure);
  EXPECT_EQ(folder_.entries(), 1u);
}

}  // namespace
}  // namespace tramline
