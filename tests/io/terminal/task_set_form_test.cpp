// Task sets are as the standard has them, and the examination of the tests finds what is not.

#include "io/terminal/task_set_form.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "io/export/export_fixture.h"
#include "support/small_plan.h"
#include "tramline/io/terminal/task_set.h"

namespace tramline::io {
namespace {

using testing_terminal::faults_of_task_set;

std::string listed(const std::vector<std::string>& faults) {
  std::string out;
  for (const std::string& fault : faults) out += fault + "\n";
  return out;
}

std::vector<TerminalField> sample_fields(LineChoice choice) {
  Plan many = sample_plan();
  many.field.obstacles.push_back({{{{40, 10}, {44, 10}, {44, 13}}, {}}, ObstacleKind::kPassable, "hole 2"});
  std::vector<TerminalField> out;
  for (int i = 0; i < 3; ++i) out.push_back(terminal_field(many, choice, 0.02, "plan.gpkg"));
  out.push_back(terminal_field(testing_support::small_plan(), choice, 0.02, "small.gpkg"));
  out.back().gaps = {{3, {{{1, 1}, {3, 1}, {3, 3}}, {}}}};
  return out;
}

std::string sample_xml(const TaskSetStyle& style, LineChoice choice = LineChoice::kAll) {
  return task_set(sample_fields(choice), style).xml;
}

TEST(TaskSetForm, EveryKindOfSetIsAsTheStandardHasIt) {
  for (const TaskDataVersion version : {TaskDataVersion::k3, TaskDataVersion::k4})
    for (const ObstacleStyle obstacles : {ObstacleStyle::kHoles, ObstacleStyle::kPolygons})
      for (const LineChoice choice : {LineChoice::kSubfields, LineChoice::kAll})
        EXPECT_EQ(listed(faults_of_task_set(
                      sample_xml({version, obstacles, "Müller & Söhne <GbR>", "Hof"}, choice))),
                  "");
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

TEST(TaskSetForm, TheExaminationFindsPlantedFaults) {
  const std::string xml = sample_xml({});
  const std::vector<std::pair<std::string, std::string>> faults = {
      {"PFD A=\"PFD2\"", "PFD A=\"PFD1\""},  // an id twice
      {"GPN A=\"GPN1\"", "GPN A=\"GGP1\""},  // an id of another element
      {"E=\"PFD2\"", "E=\"PFD9\""},          // a reference to nothing
      {"GPN A=\"GPN1\" B=\"Track 1\" C=\"1\"", "GPN A=\"GPN1\" B=\"Track 1\" C=\"6\""},
      {"E=\"4\" F=\"4\"", "E=\"5\" F=\"4\""},  // no such propagation
      {"<PNT A=\"6\"", "<PNT A=\"9\""},        // no A point
      {"VersionMinor=\"2\"", "VersionMinor=\"x\""},
      {"C=\"Grosse Breite\"",
       "C=\"Gro\xC3\x9F"
       "e Breite\""},
      {"C=\"Grosse Breite\"", "C=\"A name that is longer than terminals can show\""},
      {"<PLN A=\"10\"", "<PLN A=\"13\""},
      {"<GGP A=\"GGP1\"", "<XYZ/><GGP A=\"GGP1\""},
      {"<LSG A=\"1\">", "<LSG A=\"1\"><PNT A=\"2\" C=\"1.0\" D=\"2.0\"/>"},  // an open ring
      {"G=\"1\"", "G=\"7\""},
  };
  for (const auto& [from, to] : faults)
    EXPECT_FALSE(faults_of_task_set(replaced(xml, from, to)).empty()) << from << " -> " << to;
  EXPECT_FALSE(faults_of_task_set(replaced(xml, "VersionMajor=\"4\"", "VersionMajor=\"3\"")).empty());
}

TEST(TaskSetForm, FieldsOfOneNameAreCalledDifferently) {
  const TaskSet set = task_set(sample_fields(LineChoice::kSubfields), {});
  for (const char* name :
       {"C=\"Grosse Breite\"", "C=\"Grosse Breite 2\"", "C=\"Grosse Breite 3\"", "C=\"small\""})
    EXPECT_NE(set.xml.find(name), std::string::npos) << name;
  ASSERT_EQ(set.changed.size(), 3U);
  EXPECT_EQ(set.changed[1].name, "Große Breite");
  EXPECT_EQ(set.changed[1].shown, "Grosse Breite 2");
}

TEST(TaskSetForm, ObstaclesAreHolesOrPolygons) {
  const std::string holes = sample_xml({TaskDataVersion::k4, ObstacleStyle::kHoles});
  EXPECT_NE(holes.find("<LSG A=\"2\">"), std::string::npos);
  EXPECT_EQ(holes.find("<PLN A=\"6\""), std::string::npos);
  const std::string polygons = sample_xml({TaskDataVersion::k4, ObstacleStyle::kPolygons});
  EXPECT_EQ(polygons.find("<LSG A=\"2\">"), std::string::npos);
  EXPECT_NE(polygons.find("<PLN A=\"6\" B=\"Obstacle 1\">"), std::string::npos);
  EXPECT_NE(polygons.find("<PLN A=\"8\" B=\"Passable 2\">"), std::string::npos);
}

}  // namespace
}  // namespace tramline::io
