// Fronts in plan files: they come back to the bit, and a plan without one has no such table.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "io/changed_file.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

namespace fs = std::filesystem;

Plan plan_with_front() {
  Plan plan;
  plan.field.id = "square";
  plan.field.outer = {{0, 0}, {60, 0}, {60, 60}, {0, 60}};
  plan.body = {{plan.field.outer, {}}};
  plan.pieces.push_back({{3, 0}, {3, 60}, 0, 0});
  plan.subfields.push_back({plan.body.front(), Direction::clockwise_from_north(Angle::degrees(0))});
  plan.front.prices = plan.objective;
  for (const double third : {1.0 / 3, 200.0 / 3}) {
    FrontPoint point;
    point.tally = {540 + third, third, 100 - third, (540 + third) / 3, 3, 0, 2, 1};
    point.tally.worked_m2 = plan.machine.width_m * point.tally.track_length_m;
    point.directions = {Direction::clockwise_from_north(Angle::degrees(third)),
                        Direction::clockwise_from_north(Angle::degrees(123.4))};
    point.laid_for = {0.04 * third, 1, 2, 3};
    point.cost = cost(plan.objective, point.tally);
    plan.front.points.push_back(point);
  }
  plan.front.marks = {0, 1, 0, 1, 0};
  return plan;
}

class FrontInFiles : public ::testing::Test {
 protected:
  ~FrontInFiles() override {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }

  void change(const std::string& sql) const { testing_support::run_sql(path_, sql); }

  const fs::path path_ = fs::temp_directory_path() / ("tramline-front-" + std::to_string(getpid()) + ".gpkg");
};

TEST_F(FrontInFiles, ComesBackToTheBit) {
  const Plan plan = plan_with_front();
  io::write_plan(plan, path_);
  const io::PlanFile file = io::read_plan_file(path_);
  const Front &read = file.plan.front, &written = plan.front;
  ASSERT_EQ(read.points.size(), written.points.size());
  for (std::size_t i = 0; i < read.points.size(); ++i) {
    EXPECT_EQ(read.points[i].tally.overlap_m2, written.points[i].tally.overlap_m2);
    EXPECT_EQ(read.points[i].tally.uncovered_m2, written.points[i].tally.uncovered_m2);
    EXPECT_EQ(read.points[i].tally.track_length_m, written.points[i].tally.track_length_m);
    EXPECT_EQ(read.points[i].tally.pieces, written.points[i].tally.pieces);
    EXPECT_EQ(read.points[i].tally.turns, written.points[i].tally.turns);
    EXPECT_EQ(read.points[i].tally.stops, written.points[i].tally.stops);
    EXPECT_EQ(read.points[i].directions, written.points[i].directions);
    EXPECT_EQ(read.points[i].laid_for.overlap, written.points[i].laid_for.overlap);
    EXPECT_EQ(read.points[i].laid_for.stop, written.points[i].laid_for.stop);
    EXPECT_EQ(read.points[i].cost, written.points[i].cost);
    EXPECT_EQ(marks_of(read, i), marks_of(written, i));
  }
  for (const io::DerivedNumber& number : file.derived)
    EXPECT_NEAR(number.stored, number.from_shape, 1e-6) << number.where;
}

TEST_F(FrontInFiles, IsNotThereUnlessAskedFor) {
  Plan plan = plan_with_front();
  plan.front = {};
  io::write_plan(plan, path_);
  EXPECT_TRUE(io::read_plan(path_).front.points.empty());
  const GDALDatasetUniquePtr file(GDALDataset::Open(path_.c_str(), GDAL_OF_VECTOR));
  EXPECT_EQ(file->GetLayerByName("front"), nullptr);
}

TEST_F(FrontInFiles, AChangedCostDoesNotAgreeWithTheNumbersBesideIt) {
  io::write_plan(plan_with_front(), path_);
  change("UPDATE front SET cost = cost + 1 WHERE number = 2");
  int off = 0;
  for (const io::DerivedNumber& number : io::read_plan_file(path_).derived)
    off += std::abs(number.stored - number.from_shape) > 0.5;
  EXPECT_EQ(off, 1);
}

TEST_F(FrontInFiles, TextsOfAnotherFormAreNamed) {
  const auto sentence = [&](const std::string& sql) -> std::string {
    io::write_plan(plan_with_front(), path_);
    change(sql);
    try {
      io::read_plan(path_);
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
      return error.what();
    }
    return "";
  };
  EXPECT_NE(
      sentence("UPDATE front SET marks = 'best' WHERE number = 1").find("layer front, feature 1: marks"),
      std::string::npos);
  EXPECT_NE(sentence("UPDATE front SET direction_rad = '[1, \"x\"]'").find("direction_rad"),
            std::string::npos);
  EXPECT_NE(sentence("UPDATE front SET overlap_m2 = NULL").find("overlap_m2"), std::string::npos);
}

}  // namespace
}  // namespace tramline
