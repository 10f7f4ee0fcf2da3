// Headlands and curved tracks in plan files: paths come back to the bit, older files are read, and texts
// changed by others are named.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>

#include "io/changed_file.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using testing_support::bytes_of;
using testing_support::refusal_of_file;
using testing_support::run_sql;

namespace fs = std::filesystem;

/// Round a box with arcs at the corners, counter-clockwise.
Path round_box(double min_x, double min_y, double max_x, double max_y, double radius_m) {
  const double r = radius_m, k = 1 / radius_m;
  return {{{min_x + r, min_y}, {max_x - r, min_y}, 0}, {{max_x - r, min_y}, {max_x, min_y + r}, k},
          {{max_x, min_y + r}, {max_x, max_y - r}, 0}, {{max_x, max_y - r}, {max_x - r, max_y}, k},
          {{max_x - r, max_y}, {min_x + r, max_y}, 0}, {{min_x + r, max_y}, {min_x, max_y - r}, k},
          {{min_x, max_y - r}, {min_x, min_y + r}, 0}, {{min_x, min_y + r}, {min_x + r, min_y}, k}};
}

/// Two passes round the field, one round its obstacle, and three pieces of a curved family: an arc between
/// lines, an arc alone and a straight line.
Plan headland_plan() {
  const double third = 1.0 / 3;
  Plan plan;
  plan.field.id = "bend";
  plan.field.outer = {{0, 0}, {200 + third, 0}, {200, 100}, {0, 99.9}};
  plan.field.obstacles = {
      {{{{150, 40}, {158 + third, 40}, {158, 48}, {150, 48}}, {}}, ObstacleKind::kObstacle, "hole 1"}};
  plan.field.frame = {true, 13.1, 52.3, 0, 0};
  plan.machine = {"drill", 4 + third, 5.1, 2.5};
  plan.settings.headlands = 2;
  plan.settings.obstacle_headlands = 1;
  plan.settings.shape = TrackShape::kAuto;
  plan.settings.tracks = TrackConstruction::kPaper;
  plan.settings.ab_anchor = AbAnchor::kEnvelope;
  plan.headland.construction = HeadlandConstruction::kPlain;
  plan.settings.guide = {{-0.1, third}, {70.7, 20}, {180 + third, 1e-7}};
  plan.body = {{{{9, 9}, {191, 9}, {191, 91}, {9, 91}}, {}}};
  plan.headland.passes = {{round_box(2 + third, 2.1, 198, 97.9, 5.1), 1, true, {}},
                          {reversed(round_box(146, 36 - third, 162, 52, 5.3)), 1, false, {0}},
                          {round_box(6.5, 6.4, 193.7, 93.5, 5.1), 2, true, {0}}};
  plan.headland.obstacle_passes = {1};
  plan.headland.ground = {{plan.field.outer, {{{9, 9}, {9, 91}, {191, 91}, {191, 9}}}}};
  plan.headland.unworked = {{{{0, 0}, {1, 0}, {0, 1 + third}}, {}}};
  plan.headland.worked_m2 = 5000 + third;
  plan.headland.overlap_m2 = 0.1;
  plan.headland.uncovered_m2 = 0.7;
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(80.3))}};
  plan.subfields[0].reference = {{{-300, 20}, {60, 20 + third}, 0}, {{60, 20 + third}, {120, 50}, 1 / 77.7}};
  plan.pieces = {
      {{10, 20}, {120.1, 70}, 0, 0}, {{20, 30}, {80, 60 + third}, 0, -1}, {{9, 85}, {99, 86}, 0, 2}};
  plan.pieces[0].curve = {
      {{10, 20}, {60, 20 + third}, 0}, {{60, 20 + third}, {100, 40}, 1 / 77.7}, {{100, 40}, {120.1, 70}, 0}};
  plan.pieces[1].curve = {{{20, 30}, {80, 60 + third}, -1 / 88.8}};
  plan.pieces[2].curve = straight_path({9, 85}, {99, 86});
  return plan;
}

class HeadlandsInFiles : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() / ("tramline-headlands-" + std::to_string(getpid()) + ".gpkg");
    io::write_plan(headland_plan(), file_);
  }
  void TearDown() override { fs::remove(file_); }

  void change(const std::string& statement) const { run_sql(file_, statement); }
  /// What reading says after a change; "" when it says nothing.
  std::string after(const std::string& statement, const Plan& plan = headland_plan()) const {
    io::write_plan(plan, file_);
    change(statement);
    return refusal_of_file(file_, [this] { io::read_plan_file(file_); });
  }
  /// Does reading name all these words after the change?
  testing::AssertionResult says(const std::string& statement, std::initializer_list<const char*> words,
                                const Plan& plan = headland_plan()) const {
    const std::string sentence = after(statement, plan);
    for (const char* word : words)
      if (sentence.find(word) == std::string::npos)
        return testing::AssertionFailure() << statement << ": '" << sentence << "' does not name " << word;
    return testing::AssertionSuccess();
  }
  static std::string metadata(const std::string& key, const std::string& value) {
    return "UPDATE metadata SET value = '" + value + "' WHERE key = '" + key + "'";
  }
  fs::path file_;
};

/// Only plans with different numbers by edge have the keys, and the version that brought them.
TEST_F(HeadlandsInFiles, PassesByEdgeComeBack) {
  Plan plan = headland_plan();
  plan.settings.headland_edges = plan.headland.edge_passes = {2, 0, 1, 0};
  io::write_plan(plan, file_);
  const io::PlanFile read = io::read_plan_file(file_);
  EXPECT_EQ(read.plan.headland.edge_passes, plan.headland.edge_passes);
  EXPECT_EQ(read.plan.settings.headland_edges, plan.settings.headland_edges);
  EXPECT_EQ(read.plan.field.outer.size(), 4U);
  // The numbers are those of the edges still: the ring begins where it began.
  EXPECT_LT(distance(read.plan.field.outer.front(), plan.field.outer.front()), 1e-6);
  EXPECT_TRUE(says(metadata("format_version", "11"), {"format_version"}, plan));
  EXPECT_TRUE(says(metadata("headland.edge_passes", "[1,-2]"), {"headland.edge_passes"}, plan));
  EXPECT_TRUE(says(metadata("settings.headland_edges", "many"), {"settings.headland_edges"}, plan));

  io::write_plan(headland_plan(), file_);
  EXPECT_TRUE(io::read_plan_file(file_).plan.headland.edge_passes.empty());
  EXPECT_EQ(bytes_of(file_).find("edge_passes"), std::string::npos);
}

TEST_F(HeadlandsInFiles, ComeBackToTheBit) {
  const Plan plan = headland_plan();
  const io::PlanFile read = io::read_plan_file(file_);
  const Headland& found = read.plan.headland;
  EXPECT_EQ(found.passes, plan.headland.passes);
  EXPECT_EQ(found.obstacle_passes, plan.headland.obstacle_passes);
  EXPECT_EQ(found.ground, plan.headland.ground);
  EXPECT_EQ(found.unworked, plan.headland.unworked);
  EXPECT_EQ(found.worked_m2, plan.headland.worked_m2);
  EXPECT_EQ(found.overlap_m2, plan.headland.overlap_m2);
  EXPECT_EQ(found.uncovered_m2, plan.headland.uncovered_m2);
  EXPECT_EQ(read.plan.settings.headlands, 2);
  EXPECT_EQ(read.plan.settings.obstacle_headlands, 1);
  EXPECT_EQ(read.plan.settings.shape, TrackShape::kAuto);
  EXPECT_EQ(read.plan.settings.tracks, TrackConstruction::kPaper);
  EXPECT_EQ(read.plan.settings.ab_anchor, AbAnchor::kEnvelope);
  EXPECT_EQ(found.construction, HeadlandConstruction::kPlain);
  EXPECT_EQ(read.plan.settings.guide, plan.settings.guide);
  EXPECT_EQ(read.plan.subfields[0].reference, plan.subfields[0].reference);
  ASSERT_EQ(read.headland_lines.size(), 3u);
  EXPECT_EQ(read.headland_lines[2], chords(plan.headland.passes[2].path));
}

TEST_F(HeadlandsInFiles, CurvedTracksComeBackAsCurves) {
  const Plan plan = headland_plan();
  const io::PlanFile read = io::read_plan_file(file_);
  ASSERT_EQ(read.plan.pieces.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) {
    const TrackPiece& piece = read.plan.pieces[i];
    EXPECT_EQ(piece.curve, plan.pieces[i].curve) << "a straight line of a curved family is a curve too";
    EXPECT_EQ(piece.start, plan.pieces[i].start);
    EXPECT_EQ(piece.end, plan.pieces[i].end);
    EXPECT_EQ(piece.track, plan.pieces[i].track);
    EXPECT_TRUE(piece.detours.empty());
    EXPECT_EQ(read.track_lines[i], chords(plan.pieces[i].curve));
  }
  EXPECT_EQ(read.swaths, swaths(plan));
  for (const io::DerivedNumber& n : read.derived) EXPECT_NEAR(n.stored, n.from_shape, 1e-9) << n.where;
  for (const io::DerivedText& t : read.derived_texts) EXPECT_EQ(t.stored, t.from_shape) << t.where;
}

TEST_F(HeadlandsInFiles, EqualPlansAreEqualBytes) {
  const std::string bytes = bytes_of(file_);
  io::write_plan(io::read_plan(file_), file_);
  EXPECT_EQ(bytes_of(file_), bytes);
}

TEST_F(HeadlandsInFiles, APlainFrameMovesAllOfIt) {
  Plan plan = headland_plan();
  plan.field.frame = {false, 0, 0, 500123.4, 5800456.7};
  io::write_plan(plan, file_);
  const Plan read = io::read_plan(file_);
  const auto expect_near = [](const Path& a, const Path& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_LT(distance(a[i].from, b[i].from), 1.5e-9);
      EXPECT_LT(distance(a[i].to, b[i].to), 1.5e-9);
      EXPECT_EQ(a[i].curvature, b[i].curvature);
    }
  };
  expect_near(read.subfields[0].reference, plan.subfields[0].reference);
  expect_near(read.pieces[0].curve, plan.pieces[0].curve);
  expect_near(read.headland.passes[1].path, plan.headland.passes[1].path);
  EXPECT_EQ(read.headland.passes[1].path.front().from, read.headland.passes[1].path.back().to) << "closed";
  ASSERT_EQ(read.settings.guide.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_LT(distance(read.settings.guide[i], plan.settings.guide[i]), 1.5e-9);
  // What is in the file are coordinates of its plane.
  const GDALDatasetUniquePtr data(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
  for (const auto& row : *data->GetLayerByName("metadata"))
    if (std::string(row->GetFieldAsString("key")) == "reference") {
      EXPECT_EQ(std::string(row->GetFieldAsString("value")).substr(0, 9), "499823.4 ");
    }
}

TEST_F(HeadlandsInFiles, ColumnsAreForPeopleToo) {
  const GDALDatasetUniquePtr data(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
  const OGRFeatureUniquePtr pass(data->GetLayerByName("headland_passes")->GetFeature(3));
  EXPECT_EQ(pass->GetFieldAsInteger("number"), 2);
  EXPECT_EQ(pass->GetFieldAsInteger("around_field"), 1);
  EXPECT_STREQ(pass->GetFieldAsString("obstacles"), "1");
  EXPECT_NEAR(pass->GetFieldAsDouble("length_m"), length(headland_plan().headland.passes[2].path), 1e-12);
  EXPECT_NEAR(pass->GetFieldAsDouble("smallest_radius_m"), 5.1, 1e-12);
  const OGRFeatureUniquePtr arc(data->GetLayerByName("tracks")->GetFeature(2));
  EXPECT_STREQ(arc->GetFieldAsString("kind"), "curved");
  EXPECT_STREQ(arc->GetFieldAsString("detours"), "[]");
  EXPECT_NEAR(arc->GetFieldAsDouble("smallest_radius_m"), 88.8, 1e-12);
  const OGRFeatureUniquePtr line(data->GetLayerByName("tracks")->GetFeature(3));
  EXPECT_STREQ(line->GetFieldAsString("kind"), "curved");
  EXPECT_TRUE(line->IsFieldNull(line->GetFieldIndex("smallest_radius_m")));
}

TEST_F(HeadlandsInFiles, PlansWithoutHaveTheLayersAndNothingInThem) {
  Plan plan;
  plan.field.outer = {{0, 0}, {10, 0}, {10, 10}};
  io::write_plan(plan, file_);
  const Plan read = io::read_plan(file_);
  EXPECT_TRUE(read.headland.passes.empty());
  EXPECT_TRUE(read.headland.ground.empty());
  EXPECT_TRUE(references(read).empty());
  EXPECT_TRUE(read.settings.guide.empty());
  const GDALDatasetUniquePtr data(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
  for (const char* layer : {"headland", "headland_passes", "headland_unworked"})
    EXPECT_NE(data->GetLayerByName(layer), nullptr) << layer;
}

/// What format version 2 had.
TEST_F(HeadlandsInFiles, FilesOfTheVersionBeforeAreRead) {
  Plan plan = headland_plan();
  plan.pieces = {{{10, 20}, {60, 20}, 0, 0}};
  io::write_plan(plan, file_);
  for (const char* layer : {"headland", "headland_passes", "headland_unworked"})
    change(std::string("DROP TABLE ") + layer);
  change(
      "DELETE FROM metadata WHERE key LIKE 'headland.%' OR key IN ('reference', 'settings.headlands', "
      "'settings.obstacle_headlands', 'settings.shape', 'settings.guide')");
  change(metadata("format_version", "2"));
  const Plan read = io::read_plan(file_);
  EXPECT_EQ(read.pieces.size(), 1u);
  EXPECT_EQ(read.settings.headlands, 0);
  EXPECT_EQ(read.settings.shape, TrackShape::kStraight);
  EXPECT_TRUE(read.headland.passes.empty());
  EXPECT_TRUE(references(read).empty());
}

TEST_F(HeadlandsInFiles, SubfieldsMayFollowLinesOfTheirOwn) {
  Plan plan = headland_plan();
  plan.subfields.push_back(
      {{{{20, 20}, {30, 20}, {30, 30}}, {}}, Direction::clockwise_from_north(Angle::degrees(0)), {}});
  plan.subfields.push_back({{{{40, 20}, {50, 20}, {50, 30}}, {}},
                            Direction::clockwise_from_north(Angle::degrees(90)),
                            {{{0, 25}, {90, 25}, 0}}});
  io::write_plan(plan, file_);
  const Plan read = io::read_plan(file_);
  ASSERT_EQ(read.subfields.size(), 3u);
  for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(read.subfields[i].reference, plan.subfields[i].reference);
  EXPECT_EQ(references(read).size(), 2u);
  EXPECT_FALSE(common_reference(read));
  for (const char* lines : {"", "1", "[]", "[\"\",\"\"]", "[1,2,3]", "[\"\",\"\",\"1 2\"]"})
    EXPECT_TRUE(says(metadata("references", lines), {"references", "metadata"}, plan));
}

TEST_F(HeadlandsInFiles, OtherVersionsAreRefused) {
  for (const char* version : {"1", "11", "-3", "3.0", ""})
    EXPECT_TRUE(says(metadata("format_version", version), {"format_version", "metadata"}));
}

TEST_F(HeadlandsInFiles, ARepairWithoutWorkedGroundIsRefused) {
  EXPECT_TRUE(says(metadata("format_version", "4"), {"there is no layer", "worked"}));
}

TEST_F(HeadlandsInFiles, MissingPartsAreNamed) {
  for (const char* layer : {"headland", "headland_passes", "headland_unworked"})
    EXPECT_TRUE(says(std::string("DROP TABLE ") + layer, {"there is no layer", layer}));
  for (const char* key :
       {"settings.headlands", "settings.shape", "settings.guide", "reference", "headland.obstacle_passes",
        "headland.worked_m2", "headland.overlap_m2", "headland.uncovered_m2"})
    EXPECT_TRUE(says("DELETE FROM metadata WHERE key = '" + std::string(key) + "'", {key}));
  for (const char* column : {"number", "around_field", "obstacles", "length_m", "path"})
    EXPECT_TRUE(says(std::string("UPDATE headland_passes SET ") + column + " = NULL WHERE fid = 2",
                     {"layer headland_passes, feature 2", column}));
  EXPECT_TRUE(says("UPDATE headland_passes SET geom = NULL WHERE fid = 2",
                   {"layer headland_passes, feature 2", "no line"}));
  EXPECT_TRUE(says("UPDATE headland SET geom = NULL", {"layer headland, feature 1", "no polygon"}));
}

TEST_F(HeadlandsInFiles, CorruptTextsAreNamed) {
  for (const char* path : {"", "1 2", "1 2; 3 4", "1 2; 3 4 x", "1 2; 3 4 nan", "0 0; 10 0 0.21"})
    EXPECT_TRUE(says(std::string("UPDATE headland_passes SET path = '") + path + "' WHERE fid = 1",
                     {"layer headland_passes, feature 1: path"}));
  for (const char* obstacles : {"x", "0", "1,2", "1, "})
    EXPECT_TRUE(says(std::string("UPDATE headland_passes SET obstacles = '") + obstacles + "' WHERE fid = 3",
                     {"layer headland_passes, feature 3: obstacles"}));
  for (const char* reference : {"1 2", "1 2; 3 4", "1 2; 3 4 inf", "0 0; 10 0 0.21"})
    EXPECT_TRUE(says(metadata("reference", reference), {"table metadata, reference"}));
  for (const char* guide : {"1", "1 2;", "1 2; 3", "1 2; 3 4 0", "1 2, 3 4", "1 nan"})
    EXPECT_TRUE(says(metadata("settings.guide", guide), {"table metadata, settings.guide"}));
  for (const char* list : {"", "1", "{}", "[-1]", "[1.5]", "[\"1\"]", "[99999999999]", "[1"})
    EXPECT_TRUE(says(metadata("headland.obstacle_passes", list), {"headland.obstacle_passes", "JSON list"}));
  EXPECT_TRUE(says(metadata("settings.shape", "round"), {"settings.shape", "'round'"}));
  EXPECT_TRUE(says(metadata("settings.headlands", "two"), {"settings.headlands", "'two'"}));
  EXPECT_TRUE(says(metadata("headland.worked_m2", "inf"), {"headland.worked_m2", "finite"}));
}

/// The word `curved` decides what a path is: under another one, only what such a track may be is read.
TEST_F(HeadlandsInFiles, CurvesUnderAnotherNameAreRefused) {
  EXPECT_TRUE(says("UPDATE tracks SET kind = 'straight' WHERE fid = 1",
                   {"layer tracks, feature 1: detours", "straight"}));
  EXPECT_TRUE(says(
      R"(UPDATE tracks SET detours = '[{"first":1,"last":9,"side":"left","obstacles":[1]}]' WHERE fid = 1)",
      {"layer tracks, feature 1: detours", "names segments 1 to 9"}));
  EXPECT_TRUE(says("UPDATE tracks SET detours = 'none' WHERE fid = 1", {"layer tracks, feature 1: detours"}));
}

/// Between its detours a curved track may have any number of segments.
TEST_F(HeadlandsInFiles, DetoursOfCurvedTracksComeBack) {
  Plan plan = headland_plan();
  TrackPiece& piece = plan.pieces[0];
  ASSERT_EQ(piece.curve.size(), 3u);
  piece.detours = {{{piece.curve[1]}, Passing::kRight, {0}}};
  plan.pieces[1].detours = {{plan.pieces[1].curve, Passing::kLeft, {}}};
  const fs::path file = fs::temp_directory_path() / ("curved-detours-" + std::to_string(getpid()) + ".gpkg");
  io::write_plan(plan, file);
  const Plan back = io::read_plan(file);
  fs::remove(file);
  ASSERT_EQ(back.pieces.size(), plan.pieces.size());
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    EXPECT_EQ(back.pieces[i].curve, plan.pieces[i].curve);
    ASSERT_EQ(back.pieces[i].detours.size(), plan.pieces[i].detours.size());
    for (std::size_t k = 0; k < plan.pieces[i].detours.size(); ++k) {
      EXPECT_EQ(back.pieces[i].detours[k].path, plan.pieces[i].detours[k].path);
      EXPECT_EQ(back.pieces[i].detours[k].side, plan.pieces[i].detours[k].side);
      EXPECT_EQ(back.pieces[i].detours[k].obstacles, plan.pieces[i].detours[k].obstacles);
    }
  }
}

TEST_F(HeadlandsInFiles, ContradictionsAreKeptForTheVerifier) {
  EXPECT_EQ(after("UPDATE headland_passes SET length_m = 1, smallest_radius_m = NULL WHERE fid = 1"), "");
  int apart = 0;
  for (const io::DerivedNumber& n : io::read_plan_file(file_).derived)
    apart += std::abs(n.stored - n.from_shape) > 1e-6 ? 1 : 0;
  EXPECT_EQ(apart, 2);
}

}  // namespace
}  // namespace tramline
