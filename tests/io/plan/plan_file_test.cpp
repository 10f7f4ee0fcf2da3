// Plan files: what is written comes back, the same plan gives the same bytes, and a failure leaves
// nothing behind.

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>

#include "support/refusals.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/plan_metadata.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/model/turning_values.h"

namespace tramline {
namespace {

using testing_support::bytes_of;
using testing_support::error_of;
using testing_support::TemporaryFolder;

namespace fs = std::filesystem;

/// Numbers on purpose not representable in few decimals.
Plan odd_plan() {
  const double third = 1.0 / 3;
  Plan plan;
  plan.field.id = "north \"40\" 'acre' é";
  plan.field.outer = {{third, 0.1}, {100.7, -1.0 / 7}, {99.9 + third, 30.3}, {-0.1, 29.9}};
  plan.field.obstacles = {
      {{{{10, 10}, {12 + third, 10}, {12, 12.1}}, {}}, ObstacleKind::kObstacle, "hole 1"},
      {{{{40, -0.1}, {43, -0.1}, {43, 30}, {40, 30}}, {}}, ObstacleKind::kPassable, "drain 2"}};
  plan.field.frame = {true, 13.123456789012345, 52.98765432109876, 0, 0};
  plan.field.source = {"/home/somebody/farm.gpkg", "parcels", 4711, 2};
  plan.field.repairs = {{"hole 2 was outside", "hole 2", {3.1, third}, -0.1}};
  plan.field.warnings = {"the field is narrow"};
  plan.machine = {"sprayer", 3 + third, 6.1, 2.5};
  plan.objective = {0.1, 0.2, third, 7};
  plan.settings.end_rule = EndRule::kCover;
  plan.settings.boundary = EdgeKind::kHard;
  plan.settings.cell_direction = CellDirection::kWidth;
  plan.settings.merge_threshold = Angle::degrees(10.1);
  plan.settings.decomposition_threshold = Angle::degrees(179.3);
  plan.settings.small_cell_m2 = 200 + third;
  plan.body = {{plan.field.outer, {{{10, 10}, {12, 12.1}, {12 + third, 10}}}}};
  plan.given_up = {{{{1, 1}, {2, 1}, {2, 2}}, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90.3))}};
  plan.pieces = {{{0.1, third}, {39.9, 0.7}, 0, 0, false, true, false},
                 {{43.1, third}, {99, 0.7}, 0, 0, true, false, true}};
  plan.pieces[1].overlap_m2 = 2 + third;
  plan.dropped = {{{0.3, 0.1}, {0.7, third}, 0}};
  plan.tally = {1000 + third, 0.1, 0.2, 300 + third, 2, 1, 0, 2};
  plan.cost = 17.1;
  plan.overlap = {{{{5, 5}, {6, 5}, {6, 6 + third}}, {}}};
  plan.uncovered = {{{{7, 5}, {8, 5}, {8, 6 + third}}, {}}, {{{7, 15}, {8, 15}, {8, 16 + third}}, {}}};
  plan.directions_tried = 42;
  plan.warnings = {"one", "two \"quoted\""};
  return plan;
}

class PlanFileTest : public testing::Test {
 protected:
  void SetUp() override { unsetenv("SOURCE_DATE_EPOCH"); }
  fs::path file() const { return folder_ / "plan.gpkg"; }
  TemporaryFolder folder_;
};

void expect_same_settings(const Plan& a, const Plan& b) {
  EXPECT_EQ(a.field.id, b.field.id);
  EXPECT_EQ(a.field.frame, b.field.frame);
  EXPECT_EQ(a.field.source.layer, b.field.source.layer);
  EXPECT_EQ(a.field.source.fid, b.field.source.fid);
  EXPECT_EQ(a.field.source.part, b.field.source.part);
  EXPECT_EQ(a.field.warnings, b.field.warnings);
  EXPECT_EQ(a.machine.name, b.machine.name);
  EXPECT_EQ(a.machine.width_m, b.machine.width_m);
  EXPECT_EQ(a.machine.radius_m, b.machine.radius_m);
  EXPECT_EQ(a.machine.min_length_m, b.machine.min_length_m);
  EXPECT_EQ(a.objective.turn, b.objective.turn);
  EXPECT_EQ(a.objective.overlap, b.objective.overlap);
  EXPECT_EQ(a.settings.end_rule, b.settings.end_rule);
  EXPECT_EQ(a.settings.boundary, b.settings.boundary);
  EXPECT_EQ(a.settings.cell_direction, b.settings.cell_direction);
  EXPECT_EQ(a.settings.merge_threshold, b.settings.merge_threshold);
  EXPECT_EQ(a.settings.decomposition_threshold, b.settings.decomposition_threshold);
  EXPECT_EQ(a.settings.small_cell_m2, b.settings.small_cell_m2);
  EXPECT_EQ(a.tally.worked_m2, b.tally.worked_m2);
  EXPECT_EQ(a.tally.track_length_m, b.tally.track_length_m);
  EXPECT_EQ(a.tally.stops, b.tally.stops);
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.directions_tried, b.directions_tried);
  EXPECT_EQ(a.warnings, b.warnings);
}

TEST_F(PlanFileTest, ComesBackToTheBit) {
  const Plan plan = odd_plan();
  io::write_plan(plan, file());
  const io::PlanFile read = io::read_plan_file(file());
  expect_same_settings(read.plan, plan);
  EXPECT_EQ(read.plan.field.source.file, "farm.gpkg");
  EXPECT_EQ(read.plan.field.outer, plan.field.outer);
  ASSERT_EQ(read.plan.field.obstacles.size(), 2u);
  EXPECT_EQ(read.plan.field.obstacles[0].shape, plan.field.obstacles[0].shape);
  EXPECT_EQ(read.plan.field.obstacles[1].kind, ObstacleKind::kPassable);
  EXPECT_EQ(read.plan.field.obstacles[1].origin, "drain 2");
  ASSERT_EQ(read.plan.field.repairs.size(), 1u);
  EXPECT_EQ(read.plan.field.repairs[0].at, plan.field.repairs[0].at);
  EXPECT_EQ(read.plan.body, plan.body);
  EXPECT_EQ(read.plan.given_up, plan.given_up);
  EXPECT_EQ(read.plan.overlap, plan.overlap);
  EXPECT_EQ(read.plan.uncovered, plan.uncovered);
  ASSERT_EQ(read.plan.subfields.size(), 1u);
  EXPECT_EQ(read.plan.subfields[0].shape, plan.subfields[0].shape);
  EXPECT_EQ(read.plan.subfields[0].direction, plan.subfields[0].direction);
  ASSERT_EQ(read.plan.pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(read.plan.pieces[i].start, plan.pieces[i].start);
    EXPECT_EQ(read.plan.pieces[i].end, plan.pieces[i].end);
    EXPECT_EQ(read.plan.pieces[i].stop_at_end, plan.pieces[i].stop_at_end);
    EXPECT_EQ(read.plan.pieces[i].after_crossing, plan.pieces[i].after_crossing);
    EXPECT_EQ(read.plan.pieces[i].overlap_m2, plan.pieces[i].overlap_m2);
  }
  ASSERT_EQ(read.plan.dropped.size(), 1u);
  EXPECT_EQ(read.plan.dropped[0].end, plan.dropped[0].end);
  EXPECT_EQ(read.track_order, (std::vector<int>{1, 2}));
  EXPECT_EQ(read.swaths, swaths(plan));
  for (const io::DerivedNumber& number : read.derived)
    EXPECT_NEAR(number.stored, number.from_shape, 1e-9) << number.where;
}

TEST_F(PlanFileTest, ValuesForTurningComeBackAndAskForAVersionOfTheirOwn) {
  Plan plan = odd_plan();
  EXPECT_EQ(io::metadata_of(plan).at("format_version"), "6");
  EXPECT_EQ(io::metadata_of(plan).count("machine.lift_m"), 0U);
  plan.machine.turning.reverse = true;
  plan.machine.turning.implement = Coupling::kTowed;
  double value = 1.1;
  for (const TurningNumber& number : kTurningNumbers) plan.machine.turning.*number.value = value += 1.0 / 3;
  EXPECT_EQ(io::metadata_of(plan).at("format_version"), "9");
  io::write_plan(plan, file());
  EXPECT_EQ(io::read_plan(file()).machine.turning, plan.machine.turning);
}

TEST_F(PlanFileTest, RatesAndAimComeBackAndAreThereOnlyWhereTheyAreOthers) {
  Plan plan = odd_plan();
  EXPECT_EQ(io::metadata_of(plan).count("machine.operation"), 0U);
  EXPECT_EQ(io::metadata_of(plan).count("settings.aim"), 0U);
  plan.settings.aim = Aim::kWholeCost;
  plan.machine.rates.operation = Operation::kWeeding;
  plan.machine.rates.price_per_hour = 1.0 / 3;
  io::write_plan(plan, file());
  const Plan read = io::read_plan(file());
  EXPECT_EQ(read.machine.rates, plan.machine.rates);
  EXPECT_EQ(read.settings.aim, Aim::kWholeCost);
}

TEST_F(PlanFileTest, OneValueForTurningIsEnoughAndAllAreWritten) {
  Plan plan = odd_plan();
  plan.machine.turning.lift_m = 0.5;
  const io::Metadata metadata = io::metadata_of(plan);
  EXPECT_EQ(metadata.at("machine.turning_speed_mps"), "1.5");
  EXPECT_EQ(metadata.at("machine.implement"), "mounted");
  Plan read;
  EXPECT_EQ(io::apply_metadata(metadata, file(), read), io::kVersionWithTurning);
  EXPECT_EQ(read.machine.turning, plan.machine.turning);
}

TEST_F(PlanFileTest, ValuesForTurningThatNoMachineHasAreBadInput) {
  Plan plan = odd_plan();
  plan.machine.turning.lift_m = 0.5;
  for (const auto& [key, value] : {std::pair{"machine.turning_speed_mps", "0"},
                                   {"machine.lift_m", "-1"},
                                   {"machine.lift_m", "nan"},
                                   {"machine.implement", "pushed"},
                                   {"machine.implement", "towed"},
                                   {"machine.reverse", "1"}}) {
    io::Metadata metadata = io::metadata_of(plan);
    metadata[key] = value;
    Plan read;
    const std::string sentence =
        testing_support::refusal_of([&] { io::apply_metadata(metadata, file(), read); });
    EXPECT_NE(sentence.find(value == std::string("towed") ? "machine.drawbar_m" : key), std::string::npos)
        << sentence;
  }
  io::Metadata metadata = io::metadata_of(plan);
  metadata.erase("machine.lower_m");
  Plan read;
  EXPECT_NE(testing_support::refusal_of([&] {
              io::apply_metadata(metadata, file(), read);
            }).find("machine.lower_m"),
            std::string::npos);
}

TEST_F(PlanFileTest, APlainFrameIsWrittenInTheInputPlane) {
  Plan plan = odd_plan();
  plan.field.frame = {false, 0, 0, 500123.4, 5800456.7};
  io::write_plan(plan, file());
  const Plan read = io::read_plan(file());
  EXPECT_EQ(read.field.frame, plan.field.frame);
  for (std::size_t i = 0; i < plan.field.outer.size(); ++i)
    EXPECT_LT(distance(read.field.outer[i], plan.field.outer[i]), 1e-8);
}

TEST_F(PlanFileTest, AnEmptyPlanHasEveryLayer) {
  Plan plan;
  plan.field.outer = {{0, 0}, {10, 0}, {10, 10}};
  io::write_plan(plan, file());
  const Plan read = io::read_plan(file());
  EXPECT_TRUE(read.pieces.empty());
  EXPECT_TRUE(read.subfields.empty());
}

TEST_F(PlanFileTest, TheSamePlanGivesTheSameBytes) {
  io::write_plan(odd_plan(), file());
  usleep(5000);
  io::write_plan(odd_plan(), folder_ / "other.gpkg");
  EXPECT_EQ(bytes_of(file()), bytes_of(folder_ / "other.gpkg"));
  io::write_plan(io::read_plan(file()), folder_ / "again.gpkg");
  EXPECT_EQ(bytes_of(file()), bytes_of(folder_ / "again.gpkg"));
  EXPECT_EQ(folder_.entries(), 3u);
}

TEST_F(PlanFileTest, TimeStampsFollowSourceDateEpoch) {
  setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
  io::write_plan(odd_plan(), file());
  EXPECT_NE(bytes_of(file()).find("2023-11-14T22:13:20.000Z"), std::string::npos);
  setenv("SOURCE_DATE_EPOCH", "yesterday", 1);
  EXPECT_EQ(error_of([&] { io::write_plan(odd_plan(), file()); }).kind(), ErrorKind::kBadInput);
  unsetenv("SOURCE_DATE_EPOCH");
}

TEST_F(PlanFileTest, OnlyGeopackages) {
  const Error error = error_of([&] { io::write_plan(odd_plan(), folder_ / "plan.shp"); });
  EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
  EXPECT_EQ(folder_.entries(), 0u);
}

TEST_F(PlanFileTest, TheExtensionMayBeInCapitals) {
  io::write_plan(odd_plan(), folder_ / "PLAN.GPKG");
  EXPECT_EQ(io::read_plan(folder_ / "PLAN.GPKG").field.outer, odd_plan().field.outer);
}

TEST_F(PlanFileTest, NothingIsLeftOfAFailedWrite) {
  const Error missing = error_of([&] { io::write_plan(odd_plan(), folder_ / "no" / "plan.gpkg"); });
  EXPECT_EQ(missing.kind(), ErrorKind::kFailure);
  EXPECT_NE(std::string(missing.what()).find("plan.gpkg"), std::string::npos);

  // A folder in the way: the temporary is complete by then and has to go.
  fs::create_directory(file());
  EXPECT_EQ(error_of([&] { io::write_plan(odd_plan(), file()); }).kind(), ErrorKind::kFailure);
  EXPECT_EQ(folder_.entries(), 1u);
}

/// A limit on file sizes stands for a full disk: the write fails half way.
TEST_F(PlanFileTest, AFullDiskIsAFailedRunThatLeavesTheOlderPlan) {
  io::write_plan(odd_plan(), file());
  const std::string before = bytes_of(file());
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  const rlimit small{8192, limit.rlim_max};
  const auto handler = std::signal(SIGXFSZ, SIG_IGN);
  setrlimit(RLIMIT_FSIZE, &small);
  const Error error = error_of([&] { io::write_plan(odd_plan(), file()); });
  setrlimit(RLIMIT_FSIZE, &limit);
  std::signal(SIGXFSZ, handler);
  EXPECT_EQ(error.kind(), ErrorKind::kFailure);
  EXPECT_EQ(bytes_of(file()), before);
  EXPECT_EQ(folder_.entries(), 1u);
}

TEST_F(PlanFileTest, MissingForeignAndCutOffFilesAreBadInput) {
  EXPECT_EQ(error_of([&] { io::read_plan(folder_ / "none.gpkg"); }).kind(), ErrorKind::kBadInput);
  EXPECT_EQ(error_of([&] { io::read_plan(folder_.path()); }).kind(), ErrorKind::kBadInput);
  std::ofstream(folder_ / "text.gpkg") << "this is not a database at all, but it is long enough\n";
  EXPECT_EQ(error_of([&] { io::read_plan(folder_ / "text.gpkg"); }).kind(), ErrorKind::kBadInput);

  io::write_plan(odd_plan(), file());
  const std::string whole = bytes_of(file());
  for (const std::size_t kept : {whole.size() / 2, whole.size() - 1, std::size_t{4096}, std::size_t{10}}) {
    std::ofstream(file(), std::ios::binary) << whole.substr(0, kept);
    EXPECT_EQ(error_of([&] { io::read_plan(file()); }).kind(), ErrorKind::kBadInput) << kept;
  }
}

TEST_F(PlanFileTest, ANumberThatIsNotFiniteIsBadInput) {
  Plan plan = odd_plan();
  plan.cost = std::numeric_limits<double>::quiet_NaN();
  io::write_plan(plan, file());
  EXPECT_NE(std::string(error_of([&] { io::read_plan(file()); }).what()).find("cost"), std::string::npos);
  plan = odd_plan();
  plan.pieces[1].end.x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(error_of([&] { io::write_plan(plan, file()); }).kind(), ErrorKind::kFailure);
}

}  // namespace
}  // namespace tramline
