// Includes and links go one way only: from the upper floors of the house to the lower ones.

#include <gtest/gtest.h>

#include "architecture/rules.h"
#include "architecture/source_tree.h"

namespace tramline::architecture {
namespace {

// What the rules say to one include line in one file.
std::vector<Violation> verdict(const std::string& path, const std::string& include) {
  return check_includes(path, "#pragma once\n" + include + "\n");
}

std::string report(const std::vector<Violation>& violations) {
  std::string out;
  for (const Violation& violation : violations) out += describe(violation) + "\n";
  return out;
}

struct Case {
  const char* path;
  const char* include;
};

// --- the rules themselves ---

const std::vector<Case> kForbidden = {
    // upward
    {"src/tramline/geometry/a.h", "#include \"tramline/model/plan.h\""},
    {"src/tramline/model/a.h", "#include \"tramline/planner/plan.h\""},
    {"include/tramline/model/a.h", "#include \"tramline/planner/plan.h\""},
    {"src/tramline/tracks/a.cpp", "#include \"tramline/cost/tally.h\""},
    {"src/tramline/cost/a.cpp", "#include <tramline/avoidance/cluster.h>"},
    {"src/tramline/headland/a.cpp", "  #  include \"tramline/decomposition/sweep.h\""},
    // along a floor
    {"src/tramline/geodesy/a.cpp", "#include \"tramline/admission/admit.h\""},
    {"src/tramline/admission/a.cpp", "#include \"tramline/coverage/engine.h\""},
    // to and from the rooms beside the tower
    {"src/tramline/planner/a.cpp", "#include \"tramline/io/read.h\""},
    {"src/tramline/geometry/a.cpp", "#include \"tramline/render/draw.h\""},
    {"src/tramline/check/a.cpp", "#include \"tramline/planner/plan.h\""},
    {"src/tramline/check/a.cpp", "#include \"tramline/tracks/end_rule.h\""},
    // what plans are made with, to the room that judges them
    {"src/tramline/check/a.cpp", "#include \"tramline/geometry/offset/parallel.h\""},
    {"src/tramline/check/a.h", "#include \"tramline/geometry/path/kinked_line.h\""},
    {"src/tramline/check/a.cpp", "#include \"tramline/geometry/path/newly_covered_area.h\""},
    {"src/tramline/io/a.cpp", "#include \"tramline/admission/admit.h\""},
    {"src/tramline/render/a.cpp", "#include \"tramline/geodesy/frame.h\""},
    // libraries outside their room
    {"src/tramline/planner/a.cpp", "#include <geos_c.h>"},
    {"src/tramline/tracks/a.cpp", "#include <polyclipping/clipper.hpp>"},
    {"src/tramline/model/a.cpp", "#include <gdal_priv.h>"},
    {"src/tramline/geodesy/a.cpp", "#include <ogr_spatialref.h>"},
    {"apps/tramline/a.cpp", "#include <cpl_conv.h>"},
    {"src/tramline/io/a.cpp", "#include <proj.h>"},
    {"src/tramline/io/a.cpp", "#include <cairo/cairo.h>"},
    {"src/tramline/planner/a.h", "#include <tbb/parallel_for.h>"},
    {"src/tramline/cost/a.cpp", "#include <tbb/parallel_for.h>"},
    {"src/tramline/planner/a.cpp", "#include <CLI/CLI.hpp>"},
    {"src/tramline/model/a.cpp", "#include <nlohmann/json.hpp>"},
    {"src/tramline/io/a.cpp", "#include <boost/geometry.hpp>"},
    // of Python to others, and of others to Python
    {"apps/tramline/a.cpp", "#include <pybind11/pybind11.h>"},
    {"src/tramline/planner/a.cpp", "#include <pybind11/pybind11.h>"},
    {"apps/tramline/a.cpp", "#include \"python/src/work.h\""},
    {"python/src/a.cpp", "#include <gdal_priv.h>"},
    {"python/src/a.cpp", "#include <CLI/CLI.hpp>"},
    {"python/src/a.h", "#include <tbb/task_arena.h>"},
    {"python/src/a.cpp", "#include \"tramline/attic/junk.h\""},
    {"python/src/a.cpp", "#include \"../../apps/request/field_input.h\""},
    // the program, unknown rooms, climbing paths
    {"src/tramline/planner/a.cpp", "#include \"apps/tramline/command.h\""},
    {"src/tramline/planner/a.cpp", "#include \"command.h\""},
    {"src/tramline/planner/a.cpp", "#include \"../cost/tally.h\""},
    {"src/tramline/planner/a.cpp", "#include \"tramline/attic/junk.h\""},
};

const std::vector<Case> kAllowed = {
    {"src/tramline/planner/a.h", "#include \"tramline/avoidance/cluster.h\""},
    {"src/tramline/avoidance/a.h", "#include \"tramline/geometry/point.h\""},
    {"src/tramline/geodesy/a.h", "#include \"tramline/model/local_frame.h\""},
    {"src/tramline/admission/a.h", "#include \"tramline/geodesy/crs.h\""},
    {"src/tramline/check/a.cpp", "#include \"tramline/coverage/engine.h\""},
    {"src/tramline/check/a.cpp", "#include \"tramline/geometry/path/path.h\""},
    {"src/tramline/io/vector/a.cpp", "#include \"tramline/io/vector/read.h\""},
    {"src/tramline/io/vector/a.cpp", "#include <ogr_api.h>"},
    {"src/tramline/geometry/a.cpp", "#include <geos_c.h>"},
    {"src/tramline/geodesy/a.cpp", "#include <proj.h>"},
    {"src/tramline/planner/a.cpp", "#include <tbb/parallel_for.h>"},
    {"src/tramline/render/a.h", "#include <cairo.h>"},
    {"src/tramline/model/a.cpp", "#include <fmt/format.h>"},
    {"src/tramline/model/a.cpp", "#include <vector>"},
    {"src/tramline/model/a.cpp", "// #include <gdal.h> is not for this room"},
    {"apps/tramline/a.cpp", "#include \"command.h\""},
    {"apps/gallery/a.cpp", "#include \"tramline/render/draw.h\""},
    {"apps/tramline/a.cpp", "#include <CLI/CLI.hpp>"},
    {"python/src/a.cpp", "#include <pybind11/pybind11.h>"},
    {"python/src/a.cpp", "#include \"options/plan_options.h\""},
    {"python/src/a.cpp", "#include \"tramline/planner/plan_field.h\""},
};

TEST(Rules, EveryForbiddenEdgeIsReportedWithItsLine) {
  for (const Case& edge : kForbidden) {
    SCOPED_TRACE(std::string(edge.path) + " " + edge.include);
    const auto found = verdict(edge.path, edge.include);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_EQ(found[0].file, edge.path);
    EXPECT_EQ(found[0].line, 2);
  }
}

TEST(Rules, NoAllowedEdgeIsReported) {
  for (const Case& edge : kAllowed) EXPECT_EQ(report(verdict(edge.path, edge.include)), "");
}

TEST(Rules, AFileInAnUnknownRoomIsReported) {
  EXPECT_EQ(check_includes("src/tramline/attic/a.cpp", "").size(), 1U);
  EXPECT_EQ(check_includes("src/tramline/stray.cpp", "").size(), 1U);
  EXPECT_EQ(check_includes("include/tramline/attic/a.h", "").size(), 1U);
}

TEST(Rules, NoTwoRoomsUseEachOther) {
  for (const std::string& a : rooms()) {
    for (const std::string& b : rooms()) {
      if (a == b) continue;
      EXPECT_FALSE(may_use(a, b) && may_use(b, a)) << a << " and " << b;
    }
  }
}

TEST(Rules, LinksThatRunUpwardOrToAForeignLibraryAreReported) {
  const auto faults = [](const std::string& room, const std::string& arguments) {
    return check_links("src/tramline/" + room + "/CMakeLists.txt", "tramline_module(" + arguments + ")")
        .size();
  };
  EXPECT_EQ(faults("cost", "cost\n SOURCES tally.cpp\n LINKS tramline::geometry tramline::planner"), 1U);
  EXPECT_EQ(faults("cost", "cost SOURCES tally.cpp PRIVATE_LINKS PkgConfig::GDAL"), 1U);
  EXPECT_EQ(faults("cost", "cost SOURCES tally.cpp PRIVATE_LINKS Boost::boost"), 1U);
  EXPECT_EQ(faults("cost", "price SOURCES tally.cpp"), 1U);
  EXPECT_EQ(faults("io/vector", "io_vector SOURCES read.cpp LINKS tramline::planner"), 1U);
  EXPECT_EQ(faults("check", "check SOURCES verify.cpp LINKS tramline::io_plan"), 1U);
  EXPECT_EQ(faults("io/vector", "io_vector SOURCES read.cpp LINKS tramline::io_plan tramline::geodesy"), 0U);
  EXPECT_EQ(faults("io", "io SOURCES read.cpp # tramline::planner\n LINKS tramline::model PkgConfig::GDAL"),
            0U);
}

// --- the sources ---

TEST(Sources, IncludeDownwardOnly) {
  int files = 0;
  for (const std::string& path : repository_files()) {
    if (!is_product_source(path)) continue;
    ++files;
    EXPECT_EQ(report(check_includes(path, read(path))), "");
  }
  EXPECT_GT(files, 10) << "the sources were not found";
}

TEST(Sources, LinkDownwardOnly) {
  int modules = 0;
  for (const std::string& path : repository_files()) {
    if (!path.starts_with("src/tramline/") || !path.ends_with("/CMakeLists.txt")) continue;
    ++modules;
    EXPECT_EQ(report(check_links(path, read(path))), "");
  }
  EXPECT_GT(modules, 5) << "the modules were not found";
}

}  // namespace
}  // namespace tramline::architecture
