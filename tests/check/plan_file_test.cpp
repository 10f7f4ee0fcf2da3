// Plans judged from their files: writing and reading neither breaks a plan nor mends one.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <filesystem>

#include "check/plans.h"
#include "tramline/check/file/compare_layers.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using namespace testing_plans;
namespace fs = std::filesystem;

/// As the program does it. `edit`: what somebody does to the file in between, in SQL.
Names judged_from_file(const Plan& plan, const std::string& edit = "") {
  const fs::path path = fs::temp_directory_path() / ("tramline-check-" + std::to_string(getpid()) + ".gpkg");
  io::write_plan(plan, path);
  if (!edit.empty()) {
    const GDALDatasetUniquePtr data(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR | GDAL_OF_UPDATE));
    data->ReleaseResultSet(data->ExecuteSQL(edit.c_str(), nullptr, nullptr));
  }
  const io::PlanFile file = io::read_plan_file(path);
  fs::remove(path);
  check::Verdict verdict = check::verify(file.plan);
  if (!verdict.complete) return rules(verdict);
  for (const auto& v : check::compare_swaths(file.plan, file.track_order, file.swaths, file.swath_order))
    verdict.violations.push_back(v);
  for (const auto& v : check::compare_lines(file.plan, file.track_lines)) verdict.violations.push_back(v);
  for (const io::DerivedText& t : file.derived_texts)
    check::compare_text(t.where, t.stored, t.from_shape, t.at, verdict.violations);
  for (const io::DerivedNumber& n : file.derived)
    check::compare_number(n.where, n.stored, n.from_shape, n.rounding, n.at, verdict.violations);
  return rules(verdict);
}

TEST(PlanFiles, PlansThatHoldHoldFromAFileInEitherFrame) {
  const LocalFrame geodetic{true, 13.3, 52.1, 0, 0}, plain{false, 0, 0, 500123.4, 5800456.7};
  for (Plan plan :
       {rectangle_plan(), triangle_plan(EndRule::kCheapest, cheapest_share(Objective{})),
        triangle_plan(EndRule::kInside, 1), obstacle_plan(), two_subfields_plan(), crossing_plan(),
        poles_plan(), turned(poles_plan(0.4), Angle::degrees(33.3), {71.7, -45.1})})
    for (const LocalFrame& frame : {geodetic, plain}) {
      plan.field.frame = frame;
      EXPECT_EQ(judged_from_file(plan), Names{});
    }
}

TEST(PlanFiles, AFaultyPlanStaysFaulty) {
  Plan plan = rectangle_plan();
  plan.pieces.erase(plan.pieces.begin() + 4);
  EXPECT_EQ(judged_from_file(plan), Names{"tally"});
}

/// Each text and number that repeats what a path says, and each that the path is read from.
TEST(PlanFiles, EditedDetoursAreFound) {
  const auto after = [](const std::string& edit) { return judged_from_file(poles_plan(), edit); };
  const auto set = [&after](const std::string& assignment) {
    return after("UPDATE tracks SET " + assignment + " WHERE fid = 5");
  };
  EXPECT_EQ(after("SELECT 1"), Names{});
  EXPECT_EQ(set("kind = 'straight'"), Names{"layers"});
  EXPECT_EQ(set("sides = 'right'"), Names{"layers"});
  EXPECT_EQ(set("obstacles = '2'"), Names{"layers"});
  EXPECT_EQ(set("smallest_radius_m = 7"), Names{"layers"});
  EXPECT_EQ(set("smallest_radius_m = NULL"), Names{"layers"});
  EXPECT_EQ(set("length_m = 100"), Names{"layers"});
  EXPECT_EQ(set("detours = replace(detours, 'left', 'right')"), (Names{"layers", "encounters"}));
  EXPECT_EQ(set("detours = replace(detours, '\"obstacles\":[1]', '\"obstacles\":[2]')"),
            (Names{"layers", "encounters"}));
  EXPECT_EQ(set("detours = replace(detours, '\"obstacles\":[1]', '\"obstacles\":[9]')"), Names{"pieces"});
  EXPECT_EQ(after("UPDATE encounters SET chosen = 'cut' WHERE fid = 1"), Names{"encounters"});
  EXPECT_EQ(after("DELETE FROM encounters"), Names{"encounters"});
  EXPECT_EQ(after("UPDATE encounters SET cost_left = NULL WHERE fid = 1"), Names{"encounters"});
  EXPECT_EQ(after("UPDATE encounters SET cost_left = 3 WHERE fid = 1"), Names{"encounters"});
  EXPECT_EQ(after("UPDATE encounters SET why_not_right = 'no' WHERE fid = 1"), Names{"encounters"});
  EXPECT_EQ(after("UPDATE encounters SET number = 3 WHERE fid = 1"), Names{"layers"});
  EXPECT_EQ(after("DELETE FROM overlap"), Names{"tally"});
  EXPECT_EQ(after("DELETE FROM overlap WHERE area_m2 > 1 AND fid > 1"), Names{"tally"});
  EXPECT_EQ(after("DELETE FROM uncovered"), Names{"tally"});
  EXPECT_EQ(after("DELETE FROM uncovered WHERE area_m2 > 1 AND fid > 1"), Names{"tally"});
  EXPECT_EQ(after("DELETE FROM swaths WHERE fid = 5"), Names{"layers"});
  EXPECT_EQ(after("UPDATE swaths SET area_m2 = 300 WHERE fid = 5"), Names{"layers"});
  EXPECT_EQ(after("UPDATE metadata SET value = '0.1' WHERE key = 'settings.clearance_m'"),
            Names{"clearance"});
  EXPECT_EQ(after("UPDATE metadata SET value = '6.5' WHERE key = 'machine.radius_m'"), Names{"drivable"});
  // The drawing of another track in place of this one's: straight, through nothing.
  EXPECT_EQ(set("geom = (SELECT geom FROM tracks WHERE fid = 3)"), Names{"layers"});
}

}  // namespace
}  // namespace tramline
