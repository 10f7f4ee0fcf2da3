// Task sets on the disk, read back by the readers of fields and of guidance lines.

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "io/export/export_fixture.h"
#include "support/refusals.h"
#include "support/small_plan.h"
#include "tramline/geodesy/field_projection.h"
#include "tramline/io/export/export_plan.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/plan/write_plans.h"
#include "tramline/io/terminal/terminal_field.h"

namespace tramline::io {
namespace {

namespace fs = std::filesystem;

/// Coordinates have nine decimals, degrees.
constexpr double kDigit_deg = 1e-9;

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class TaskSetFileTest : public ExportTest {
 protected:
  TaskSetRequest request(const char* target) const {
    TaskSetRequest out;
    out.plans = {plan_file()};
    out.target = folder_ / target;
    return out;
  }
};

void expect_same_line(const std::vector<Point>& read, const std::vector<Point>& written,
                      const LocalFrame& frame) {
  const FrameProjection projection(frame);
  ASSERT_EQ(read.size(), written.size());
  for (std::size_t i = 0; i < read.size(); ++i) {
    const Point lonlat = projection.to_lonlat(written[i]);
    EXPECT_NEAR(read[i].x, lonlat.x, kDigit_deg);
    EXPECT_NEAR(read[i].y, lonlat.y, kDigit_deg);
  }
}

TEST_F(TaskSetFileTest, LinesAndOutlinesAreReadBack) {
  const Plan plan = sample_plan();
  for (const TaskDataVersion version : {TaskDataVersion::k3, TaskDataVersion::k4}) {
    TaskSetRequest asked = request(version == TaskDataVersion::k3 ? "three.zip" : "four.zip");
    asked.version = version;
    asked.lines = LineChoice::kAll;
    const TaskSetReport report = export_task_set(asked);
    EXPECT_EQ(report.lines, 4U);
    EXPECT_EQ(report.curves, 3U);
    EXPECT_EQ(report.obstacles, 1U);

    const RawDataset guidance = read_guidance(asked.target.string());
    const std::vector<TerminalLine> lines = lines_of(plan, LineChoice::kAll, asked.tolerance_m);
    ASSERT_EQ(guidance.layers.at(0).features.size(), lines.size());
    for (std::size_t i = 0; i < lines.size(); ++i) {
      const RawFeature& feature = guidance.layers[0].features[i];
      EXPECT_EQ(feature.attributes.at("name"), lines[i].name);
      expect_same_line(feature.lines.at(0), lines[i].points, plan.field.frame);
    }
    const RawDataset fields = read_partfields(asked.target.string());
    ASSERT_EQ(fields.layers.at(0).features.size(), 1U);
    const RawPolygon& boundary = fields.layers[0].features[0].polygons.at(0);
    ASSERT_EQ(boundary.rings.size(), 2U);
    EXPECT_TRUE(boundary.rings[0].closed);
    expect_same_line(boundary.rings[0].points, plan.field.outer, plan.field.frame);
    EXPECT_EQ(boundary.rings[1].points.size(), 4U);
  }
}

TEST_F(TaskSetFileTest, AFolderGetsAFolderTaskdataInCapitals) {
  export_task_set(request("new"));
  EXPECT_TRUE(fs::exists(folder_ / "new/TASKDATA/TASKDATA.XML"));
  fs::create_directory(folder_ / "card");
  std::ofstream(folder_ / "card/other.txt") << "kept";
  const TaskSetReport report = export_task_set(request("card/"));
  EXPECT_EQ(report.file, folder_ / "card/TASKDATA/TASKDATA.XML");
  EXPECT_TRUE(fs::exists(report.file));
  EXPECT_TRUE(fs::exists(folder_ / "card/other.txt"));
  fs::create_directory(folder_ / "stick");
  export_task_set(request("stick/TASKDATA"));
  EXPECT_TRUE(fs::exists(folder_ / "stick/TASKDATA/TASKDATA.XML"));
  EXPECT_EQ(bytes_of(folder_ / "stick/TASKDATA/TASKDATA.XML"), bytes_of(report.file));
}

TEST_F(TaskSetFileTest, AFolderOnTheCardIsNotOverwritten) {
  export_task_set(request("card"));
  const std::string before = bytes_of(folder_ / "card/TASKDATA/TASKDATA.XML");
  TaskSetRequest again = request("card");
  again.version = TaskDataVersion::k3;
  const std::string refusal = testing_support::refusal_of([&] { export_task_set(again); });
  EXPECT_TRUE(testing_support::mentions(refusal, "TASKDATA")) << refusal;
  EXPECT_EQ(bytes_of(folder_ / "card/TASKDATA/TASKDATA.XML"), before);
  EXPECT_TRUE(testing_support::mentions(
      testing_support::refusal_of([&] { export_task_set(request("nowhere/card")); }), "no folder"));
  EXPECT_TRUE(testing_support::mentions(
      testing_support::refusal_of([&] { export_task_set(request("set.xml")); }), "TASKDATA/TASKDATA.XML"));
}

TEST_F(TaskSetFileTest, NothingHalfWrittenStaysWhereNothingCanBeWritten) {
  // Even root writes nothing here.
  TaskSetRequest asked = request("x");
  asked.target = "/proc/card";
  EXPECT_RUN_FAILURE(export_task_set(asked));
  asked.target = "/proc/card.zip";
  EXPECT_RUN_FAILURE(export_task_set(asked));
}

TEST_F(TaskSetFileTest, ManyPlansAreOneSetAndTheSamePlansTheSameBytes) {
  write_plan(testing_support::small_plan(), folder_ / "small.gpkg");
  write_plans({{"a", plan_file()}, {"b", folder_ / "small.gpkg"}}, folder_ / "many.gpkg");
  TaskSetRequest asked = request("set.zip");
  asked.plans = {folder_ / "many.gpkg", folder_ / "small.gpkg"};
  EXPECT_EQ(export_task_set(asked).fields, 3U);
  EXPECT_EQ(read_partfields(asked.target.string()).layers.at(0).features.size(), 3U);
  const std::string first = bytes_of(asked.target);
  export_task_set(asked);
  EXPECT_EQ(bytes_of(asked.target), first);

  asked.plans = {folder_ / "many.gpkg"};
  asked.field = "small";
  EXPECT_EQ(export_task_set(asked).fields, 1U);
  asked.plans.push_back(plan_file());
  EXPECT_REFUSED(export_task_set(asked));
}

}  // namespace
}  // namespace tramline::io
