// Plans of many fields in one GeoPackage, read back one by one.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "support/refusals.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/fields_in.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"
#include "tramline/io/plan/write_plans.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;
using testing_support::bytes_of;
using testing_support::TemporaryFolder;

/// A field of 400 m with a pond, a straight track, one with a detour, and a headland pass.
Plan plan_at(const std::string& id, const LocalFrame& frame) {
  Plan plan;
  plan.field.id = id;
  plan.field.outer = {{-200, -100.5}, {200, -100}, {190.25, 110}, {-200, 100}};
  plan.field.obstacles = {
      {{{{10, 10}, {14, 10}, {14, 13}, {10, 13}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  plan.field.frame = frame;
  plan.field.source = {"fields.gpkg", "parcels", 7, 0};
  plan.field.source.input_crs = frame.geodetic ? "EPSG:4326" : "none";
  plan.machine = {"sprayer", 6, 5, 2};
  plan.body = {{plan.field.outer, {{{10, 10}, {10, 13}, {14, 13}, {14, 10}}}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  TrackPiece straight{{-150.123, 50.5}, {149.877, 51.25}, 0, 0, false, true, false};
  TrackPiece round{{-200, 5}, {200, 5}, 0, 1, true, false, false};
  round.detours = {{{{{-30, 5}, {-24, 4}, -2 / 37.0}, {{-24, 4}, {-12, 4}, 0}, {{-12, 4}, {0, 5}, 2 / 145.0}},
                    Passing::kLeft,
                    {0}}};
  plan.pieces = {straight, round};
  plan.tally.pieces = 2;
  plan.cost = 12.5;
  return plan;
}

double apart(const Ring& a, const Ring& b) {
  if (a.size() != b.size()) return HUGE_VAL;
  double out = 0;
  for (std::size_t i = 0; i < a.size(); ++i) out = std::max(out, distance(a[i], b[i]));
  return out;
}

class PlansInOneFile : public testing::Test {
 protected:
  KeptPlan kept(const std::string& key, const Plan& plan) const {
    const fs::path file = folder_ / (std::to_string(count_++) + ".gpkg");
    write_plan(plan, file);
    return {key, file};
  }
  fs::path whole() const { return folder_ / "plans.gpkg"; }
  std::string refusal(const std::string& field) const {
    try {
      read_plan(whole(), field);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  }
  TemporaryFolder folder_;
  mutable int count_ = 0;
};

/// Everything that is exact in a plan file is exact in one of many; shapes come back to 1e-7 m.
void expect_same_plan(const Plan& found, const Plan& plan) {
  EXPECT_EQ(found.field.id, plan.field.id);
  EXPECT_EQ(found.field.frame, plan.field.frame);
  EXPECT_LT(apart(found.field.outer, plan.field.outer), 1e-7);
  ASSERT_EQ(found.field.obstacles.size(), 1U);
  EXPECT_LT(apart(found.field.obstacles[0].shape.outer, plan.field.obstacles[0].shape.outer), 1e-7);
  ASSERT_EQ(found.pieces.size(), plan.pieces.size());
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    EXPECT_EQ(found.pieces[i].stop_at_end, plan.pieces[i].stop_at_end);
    if (plan.field.frame.geodetic) {
      EXPECT_EQ(found.pieces[i].start, plan.pieces[i].start) << "paths are texts, exact to the bit";
      EXPECT_EQ(found.pieces[i].detours.size(), plan.pieces[i].detours.size());
    } else {
      EXPECT_LT(distance(found.pieces[i].start, plan.pieces[i].start), 1e-9);
    }
  }
  EXPECT_EQ(found.cost, plan.cost);
  EXPECT_EQ(found.machine.name, plan.machine.name);
}

TEST_F(PlansInOneFile, EachComesBackInItsOwnPlane) {
  // 90 km apart; two have one id.
  const Plan a = plan_at("mill", {true, 9.1234567, 52.7, 0, 0});
  const Plan b = plan_at("mill", {true, 10.4234567, 52.75, 0, 0}),
             c = plan_at("home", {true, 9.5, 52.1, 0, 0});
  write_plans({kept("farm:1", a), kept("farm:2", b), kept("farm:3", c)}, whole());
  const std::vector<FieldNames> fields = fields_in(whole());
  ASSERT_EQ(fields.size(), 3U);
  EXPECT_EQ(fields[1].key, "farm:2");
  EXPECT_EQ(fields[1].id, "mill");
  expect_same_plan(read_plan(whole(), "farm:1"), a);
  expect_same_plan(read_plan(whole(), "farm:2"), b);
  expect_same_plan(read_plan(whole(), "home"), c);
}

TEST_F(PlansInOneFile, TheDateLineIsNoBorder) {
  const Plan west = plan_at("west", {true, 179.99, -17, 0, 0}),
             east = plan_at("east", {true, -179.98, -17, 0, 0});
  write_plans({kept("f:1", west), kept("f:2", east)}, whole());
  expect_same_plan(read_plan(whole(), "west"), west);
  expect_same_plan(read_plan(whole(), "east"), east);
}

TEST_F(PlansInOneFile, FieldsOnOtherSidesOfTheEarthAreRefused) {
  try {
    write_plans({kept("a", plan_at("a", {true, -3.83, 11.22, 0, 0})),
                 kept("b", plan_at("b", {true, 169, -44, 0, 0}))},
                whole());
    FAIL() << "one transverse Mercator holds both";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kBadInput);
    EXPECT_NE(std::string(error.what()).find("too far apart"), std::string::npos) << error.what();
  }
}

TEST_F(PlansInOneFile, PlainMetresStayInThePlaneOfTheInput) {
  const Plan a = plan_at("a", {false, 0, 0, 1000, 2000}), b = plan_at("b", {false, 0, 0, 1500, 2000});
  write_plans({kept("f:1", a), kept("f:2", b)}, whole());
  expect_same_plan(read_plan(whole(), "a"), a);
  expect_same_plan(read_plan(whole(), "b"), b);
  GDALAllRegister();
  const GDALDatasetUniquePtr file(GDALDataset::Open(whole().c_str(), GDAL_OF_VECTOR));
  OGREnvelope box;
  ASSERT_EQ(file->GetLayerByName("field")->GetExtent(&box, TRUE), OGRERR_NONE);
  EXPECT_NEAR(box.MinX, 800, 1e-9);
  EXPECT_NEAR(box.MaxX, 1700, 1e-9);
}

TEST_F(PlansInOneFile, EveryLayerSaysWhoseItsRowsAre) {
  write_plans(
      {kept("f:1", plan_at("a", {true, 9, 52, 0, 0})), kept("f:2", plan_at("b", {true, 9.01, 52, 0, 0}))},
      whole());
  GDALAllRegister();
  const GDALDatasetUniquePtr file(GDALDataset::Open(whole().c_str(), GDAL_OF_VECTOR));
  int layers = 0;
  for (OGRLayer* layer : file->GetLayers()) {
    if (std::string(layer->GetName()) == "layer_styles") continue;
    EXPECT_EQ(layer->GetLayerDefn()->GetFieldIndex("field_key"), 0) << layer->GetName();
    EXPECT_EQ(layer->GetLayerDefn()->GetFieldIndex("field_id"), 1) << layer->GetName();
    ++layers;
  }
  EXPECT_GE(layers, 15);
  EXPECT_EQ(file->GetLayerByName("tracks")->GetFeatureCount(), 4);
  // The fields lie where they are: 0.01 degrees of longitude at 52 degrees north are 687 m.
  OGREnvelope box;
  ASSERT_EQ(file->GetLayerByName("field")->GetExtent(&box, TRUE), OGRERR_NONE);
  EXPECT_NEAR(box.MaxX - box.MinX, 687 + 400, 2);
}

TEST_F(PlansInOneFile, AFieldHasToBeNamedAndKnown) {
  write_plans(
      {kept("f:1", plan_at("a", {true, 9, 52, 0, 0})), kept("f:2", plan_at("a", {true, 9.01, 52, 0, 0}))},
      whole());
  EXPECT_NE(refusal("").find("name a field with --id"), std::string::npos);
  EXPECT_NE(refusal("b").find("no plan of a field 'b'; there are f:1 (a), f:2 (a)"), std::string::npos);
  EXPECT_NE(refusal("a").find("2 fields are called 'a'"), std::string::npos);
  EXPECT_EQ(refusal("f:2"), "");
}

TEST_F(PlansInOneFile, OneOfOneNeedsNoName) {
  const Plan a = plan_at("a", {true, 9, 52, 0, 0});
  write_plans({kept("f:1", a)}, whole());
  expect_same_plan(read_plan(whole()), a);
}

TEST_F(PlansInOneFile, TheSamePlansGiveTheSameBytes) {
  const std::vector<KeptPlan> plans{kept("f:1", plan_at("a", {true, 9, 52, 0, 0})),
                                    kept("f:2", plan_at("b", {true, 9.01, 52, 0, 0}))};
  write_plans(plans, whole());
  const std::string first = bytes_of(whole());
  write_plans(plans, folder_ / "again.gpkg");
  EXPECT_EQ(bytes_of(folder_ / "again.gpkg"), first);
  EXPECT_FALSE(first.empty());
}

TEST_F(PlansInOneFile, NothingIsLeftOfAFileThatCannotBeWritten) {
  const std::vector<KeptPlan> plans{kept("f:1", plan_at("a", {true, 9, 52, 0, 0})),
                                    {"f:2", folder_ / "missing.gpkg"}};
  EXPECT_REFUSED(write_plans(plans, whole()));
  const std::vector<KeptPlan> mixed{plans[0], kept("f:3", plan_at("b", {false, 0, 0, 0, 0}))};
  EXPECT_REFUSED(write_plans(mixed, whole()));
  int left = 0;
  for (const auto& entry : fs::directory_iterator(whole().parent_path()))
    left += entry.path().filename().string().find("part") != std::string::npos ? 1 : 0;
  EXPECT_EQ(left, 0);
  EXPECT_FALSE(fs::exists(whole()));
}

}  // namespace
}  // namespace tramline::io
