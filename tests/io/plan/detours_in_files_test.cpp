// Detours in plan files: paths come back to the bit, and texts changed by others are named.

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "io/changed_file.h"
#include "support/temporary_folder.h"
#include "tramline/geometry/error.h"
#include "tramline/io/plan/detour_text.h"
#include "tramline/io/plan/path_text.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline {
namespace {

using testing_support::bytes_of;
using testing_support::refusal_of_file;
using testing_support::run_sql;

namespace fs = std::filesystem;

/// Left round something as far as `away_m`, from (x, y) east, in three arcs of that radius.
Path bulge(double x, double y, double away_m, double radius_m) {
  const double half = std::sqrt(4 * radius_m * away_m - away_m * away_m), k = 1 / radius_m;
  const Point a{x, y}, b{x + 0.5 * half, y + 0.5 * away_m}, c{x + 1.5 * half, y + 0.5 * away_m};
  return {{a, b, k}, {b, c, -k}, {c, {x + 2 * half, y}, k}};
}

/// One straight piece and one with two detours, the second at its very end.
Plan detour_plan() {
  const double third = 1.0 / 3;
  Plan plan;
  plan.field.id = "poles";
  plan.field.outer = {{0, 0}, {100 + third, 0}, {100, 9}, {0, 9.1}};
  plan.field.frame = {true, 13.1, 52.3, 0, 0};
  for (const double x : {15.1, 40.2, 81.3})
    plan.field.obstacles.push_back(
        {{{{x, 4.4}, {x + third, 4.4}, {x, 4.7}}, {}}, ObstacleKind::kObstacle, "pole"});
  plan.machine = {"sprayer", 3 + third, 6.1, 2.5};
  plan.settings.avoid = Avoidance::kPaper;
  plan.settings.avoid_threshold_m = 1 + third;
  plan.settings.clearance_m = 0.1;
  plan.body = {{plan.field.outer, {}}};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))}};
  const Path first = bulge(10 + third, 4.5, 2 + third, 6.1);
  const Path second = bulge(70.1, 4.5, 1.9, 7.7);
  TrackPiece piece{{0.1, 4.5}, second.back().to, 0, 1, false, true};
  piece.detours = {{first, Passing::kLeft, {0, 1}}, {second, Passing::kRight, {2}}};
  plan.pieces = {{{0, third}, {100, third}, 0, 0}, piece};
  plan.encounters = {
      {0, 0, {50.1, third}, {}, Passing::kCut, {false, 0, "too near to the edge"}, {true, 1 + third, ""}},
      {0, 1, {15.2, 4.5}, {0, 1}, Passing::kLeft, {true, -third, ""}, {false, 0, "too wide"}}};
  return plan;
}

class DetoursInFiles : public testing::Test {
 protected:
  void SetUp() override {
    file_ = fs::temp_directory_path() / ("tramline-detours-" + std::to_string(getpid()) + ".gpkg");
    io::write_plan(detour_plan(), file_);
  }
  void TearDown() override { fs::remove(file_); }

  /// What reading says after a change; "" when it says nothing.
  std::string after(const std::string& statement) const {
    io::write_plan(detour_plan(), file_);
    run_sql(file_, statement);
    return refusal_of_file(file_, [this] { io::read_plan_file(file_); });
  }
  /// Is the column of the piece with detours named when it holds this?
  testing::AssertionResult refused(const std::string& column, const std::string& text) const {
    const std::string sentence = after("UPDATE tracks SET " + column + " = '" + text + "' WHERE fid = 2");
    if (sentence.find("layer tracks, feature 2: " + column) != std::string::npos)
      return testing::AssertionSuccess();
    return testing::AssertionFailure() << column << " '" << text << "': " << sentence;
  }
  fs::path file_;
};

void expect_same_piece(const TrackPiece& a, const TrackPiece& b) {
  EXPECT_EQ(a.start, b.start);
  EXPECT_EQ(a.end, b.end);
  ASSERT_EQ(a.detours.size(), b.detours.size());
  for (std::size_t i = 0; i < a.detours.size(); ++i) {
    EXPECT_EQ(a.detours[i].path, b.detours[i].path);
    EXPECT_EQ(a.detours[i].side, b.detours[i].side);
    EXPECT_EQ(a.detours[i].obstacles, b.detours[i].obstacles);
  }
}

TEST_F(DetoursInFiles, ComeBackToTheBit) {
  const Plan plan = detour_plan();
  const io::PlanFile read = io::read_plan_file(file_);
  ASSERT_EQ(read.plan.pieces.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) expect_same_piece(read.plan.pieces[i], plan.pieces[i]);
  EXPECT_EQ(read.plan.settings.avoid, Avoidance::kPaper);
  EXPECT_EQ(read.plan.settings.avoid_threshold_m, plan.settings.avoid_threshold_m);
  EXPECT_EQ(read.plan.settings.clearance_m, plan.settings.clearance_m);
  EXPECT_EQ(read.swaths, swaths(plan));
  ASSERT_EQ(read.track_lines.size(), 2u);
  EXPECT_EQ(read.track_lines[0], (std::vector<Point>{plan.pieces[0].start, plan.pieces[0].end}));
  EXPECT_EQ(read.track_lines[1], chords(centre_line(plan.pieces[1])));
  for (const io::DerivedNumber& n : read.derived) EXPECT_NEAR(n.stored, n.from_shape, 1e-9) << n.where;
  for (const io::DerivedText& t : read.derived_texts) EXPECT_EQ(t.stored, t.from_shape) << t.where;
  EXPECT_EQ(read.derived_texts.size(), 13u)
      << "kinds, sides and obstacles of two pieces, and what settings repeat";
}

TEST_F(DetoursInFiles, EncountersComeBack) {
  const Plan plan = detour_plan();
  const std::vector<Encounter> read = io::read_plan(file_).encounters;
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    const Encounter& wanted = plan.encounters[i];
    EXPECT_EQ(read[i].subfield, wanted.subfield);
    EXPECT_EQ(read[i].track, wanted.track);
    EXPECT_EQ(read[i].at, wanted.at);
    EXPECT_EQ(read[i].obstacles, wanted.obstacles);
    EXPECT_EQ(read[i].chosen, wanted.chosen);
    EXPECT_EQ(read[i].left.possible, wanted.left.possible);
    EXPECT_EQ(read[i].left.cost, wanted.left.cost);
    EXPECT_EQ(read[i].left.why_not, wanted.left.why_not);
    EXPECT_EQ(read[i].right.cost, wanted.right.cost);
    EXPECT_EQ(read[i].right.why_not, wanted.right.why_not);
  }
}

TEST_F(DetoursInFiles, APlainFrameMovesPathsToo) {
  Plan plan = detour_plan();
  plan.field.frame = {false, 0, 0, 500123.4, 5800456.7};
  io::write_plan(plan, file_);
  const Plan read = io::read_plan(file_);
  const Path wanted = centre_line(plan.pieces[1]), found = centre_line(read.pieces[1]);
  ASSERT_EQ(found.size(), wanted.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    EXPECT_LT(distance(found[i].from, wanted[i].from), 1.5e-9);
    EXPECT_LT(distance(found[i].to, wanted[i].to), 1.5e-9);
    EXPECT_EQ(found[i].curvature, wanted[i].curvature);
  }
  EXPECT_LT(distance(read.encounters[0].at, plan.encounters[0].at), 1.5e-9);
}

/// A tight half circle far from the origin: its chord is longer than its diameter by rounding.
TEST_F(DetoursInFiles, HalfCirclesAreNotRefusedForTheirLastDigits) {
  for (int i = 0; i < 200; ++i) {
    const Point a{0.1 * i, 0.7}, b{a.x + std::cos(0.1 * i), a.y + std::sin(0.1 * i)},
        far{500123.4, 5800456.7};
    const Path half{{a, b, 2 / distance(a, b)}};
    EXPECT_EQ(io::path_from_text(io::path_text(half, far), far, "here").size(), 1u);
  }
}

TEST_F(DetoursInFiles, EqualPlansAreEqualBytes) {
  const std::string bytes = bytes_of(file_);
  const Plan read = io::read_plan(file_);
  io::write_plan(read, file_);
  EXPECT_EQ(bytes_of(file_), bytes);
}

TEST_F(DetoursInFiles, ColumnsAreForPeopleToo) {
  io::write_plan(detour_plan(), file_);
  const GDALDatasetUniquePtr data(GDALDataset::Open(file_.c_str(), GDAL_OF_VECTOR));
  OGRLayer* layer = data->GetLayerByName("tracks");
  const OGRFeatureUniquePtr straight(layer->GetFeature(1)), detour(layer->GetFeature(2));
  EXPECT_STREQ(straight->GetFieldAsString("kind"), "straight");
  EXPECT_TRUE(straight->IsFieldNull(straight->GetFieldIndex("smallest_radius_m")));
  EXPECT_STREQ(straight->GetFieldAsString("obstacles"), "");
  EXPECT_STREQ(straight->GetFieldAsString("path"), "0 0.3333333333333333; 100 0.3333333333333333 0");
  EXPECT_STREQ(straight->GetFieldAsString("detours"), "[]");
  EXPECT_STREQ(detour->GetFieldAsString("kind"), "detour");
  EXPECT_NEAR(detour->GetFieldAsDouble("smallest_radius_m"), 6.1, 1e-12);
  EXPECT_STREQ(detour->GetFieldAsString("obstacles"), "1, 2, 3");
  EXPECT_STREQ(detour->GetFieldAsString("sides"), "left, right");
  EXPECT_NEAR(detour->GetFieldAsDouble("length_m"), length(detour_plan().pieces[1]), 1e-12);
  const OGRFeatureUniquePtr cut(data->GetLayerByName("encounters")->GetFeature(1));
  EXPECT_TRUE(cut->IsFieldNull(cut->GetFieldIndex("cost_left")));
  EXPECT_STREQ(cut->GetFieldAsString("why_not_left"), "too near to the edge");
  EXPECT_STREQ(cut->GetFieldAsString("chosen"), "cut");
}

TEST_F(DetoursInFiles, CorruptPathsAreNamed) {
  for (const char* text :
       {"", "1", "1 2", "1 2;", "1 2; 3 4", "1 2; 3 4 ", "1 2; 3 4 0;", "1 2; 3 4 0 5", "1 2, 3 4 0",
        "1 2; 3 4 x", "nan 2; 3 4 0", "1 2; inf 4 0", "1 2; 3 4 nan", "1 2; 3 1e999 0", " 1 2; 3 4 0"})
    EXPECT_TRUE(refused("path", text));
  // A chord of 10 m on a circle of 9.9 m across; on one of 10 m across all is well but the detours.
  EXPECT_TRUE(refused("path", "0 0; 10 0 0.2020202"));
  EXPECT_TRUE(refused("detours", "[]"));
}

TEST_F(DetoursInFiles, CorruptListsOfDetoursAreNamed) {
  const auto item = [](const char* first, const char* last, const char* side, const char* obstacles) {
    return std::string("{\"first\":") + first + ",\"last\":" + last + ",\"side\":\"" + side +
           "\",\"obstacles\":" + obstacles + "}";
  };
  for (const std::string& text :
       {std::string(""), std::string("{}"), std::string("[1]"), std::string("[{}]"), std::string("[1,"),
        "[" + item("1.5", "3", "left", "[1]") + "]", "[" + item("1", "\"3\"", "left", "[1]") + "]",
        "[" + item("1", "3", "cut", "[1]") + "]", "[" + item("1", "3", "up", "[1]") + "]",
        "[" + item("1", "3", "left", "[0]") + "]", "[" + item("1", "3", "left", "[99999999999]") + "]",
        "[" + item("-1", "3", "left", "[1]") + "]", "[" + item("3", "1", "left", "[1]") + "]",
        "[" + item("1", "9", "left", "[1]") + "]", "[" + item("1", "3", "left", "[1]") + "]",
        "[" + item("1", "3", "left", "[1]") + "," + item("3", "7", "right", "[1]") + "]",
        "[" + item("2", "7", "left", "[1]") + "]"})
    EXPECT_TRUE(refused("detours", text));
  // The whole path as one detour is well formed, whatever the verifier says.
  EXPECT_EQ(after("UPDATE tracks SET detours = '[" + item("0", "7", "left", "[1]") + "]' WHERE fid = 2"), "");
}

TEST_F(DetoursInFiles, OtherFaultsAreNamed) {
  const auto mentions = [](const std::string& sentence, const std::string& words) {
    return sentence.find(words) != std::string::npos;
  };
  EXPECT_TRUE(mentions(after("UPDATE tracks SET path = NULL WHERE fid = 1"), "path"));
  EXPECT_TRUE(mentions(after("UPDATE encounters SET chosen = 'up' WHERE fid = 1"),
                       "layer encounters, feature 1: chosen is 'up'"));
  for (const char* text : {"x", "0", "1,2", "1, ", "1 2", ", 1"})
    EXPECT_TRUE(mentions(after(std::string("UPDATE encounters SET obstacles = '") + text + "' WHERE fid = 2"),
                         "layer encounters, feature 2: obstacles"))
        << text;
  EXPECT_TRUE(mentions(after("UPDATE encounters SET geom = NULL WHERE fid = 2"), "encounters, feature 2"));
  EXPECT_TRUE(mentions(after("UPDATE metadata SET value = 'never' WHERE key = 'settings.avoid'"), "'never'"));
}

/// Columns for people that contradict the path are read beside what it says.
TEST_F(DetoursInFiles, ContradictionsAreKeptForTheVerifier) {
  EXPECT_EQ(after("UPDATE tracks SET kind = 'straight', sides = '', smallest_radius_m = NULL WHERE fid = 2"),
            "");
  const io::PlanFile file = io::read_plan_file(file_);
  int texts = 0, numbers = 0;
  for (const io::DerivedText& t : file.derived_texts) texts += t.stored != t.from_shape ? 1 : 0;
  for (const io::DerivedNumber& n : file.derived) numbers += std::abs(n.stored - n.from_shape) > 1e-6 ? 1 : 0;
  EXPECT_EQ(texts, 2);
  EXPECT_EQ(numbers, 1);
}

}  // namespace
}  // namespace tramline
