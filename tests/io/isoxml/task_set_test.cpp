// Task sets in folders and zips, their logs and their partfields.

#include <gtest/gtest.h>

#include <filesystem>
#include <map>
#include <optional>
#include <string>

#include "io/isoxml/time_log_bytes.h"
#include "io/vector/files.h"
#include "support/refusals.h"
#include "tramline/geometry/error.h"
#include "tramline/io/isoxml/read_task_log.h"
#include "tramline/io/isoxml/task_data.h"
#include "tramline/io/isoxml/task_files.h"
#include "tramline/io/log/read_log.h"

namespace tramline::task_set_test {

using testing_support::mentions;
using testing_support::refusal_of;

using namespace io;
using testing_logs::header;
using testing_logs::record;

constexpr std::uint32_t kDay = 14611;

std::string task_data(const std::string& inside) {
  return R"(<?xml version="1.0"?><ISO11783_TaskData VersionMajor="4">)" + inside + "</ISO11783_TaskData>";
}

const std::string kTasks = task_data(
    R"(<TSK A="TSK1" B="mow" E="PFD1"><TLG A="TLG00001"/></TSK><TSK A="TSK2" B="rake"><TLG A="TLG00002"/></TSK>)");
const std::string kHeader = header(R"(<DLV A="0043" B="" C="DET-1"/>)");

std::string one_record(std::int32_t lat, std::int32_t width_mm) {
  return record(1000, kDay, lat, 100000000, 4, {{0, width_mm}});
}

class TaskSet : public testing_files::Files {
 protected:
  std::string write_in(const std::string& folder, const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories(folder_ / folder);
    return write(folder + "/" + name, bytes);
  }
  void write_set(const std::string& folder, const std::string& task_file = "TASKDATA.XML") const {
    write_in(folder, task_file, kTasks);
    write_in(folder, "TLG00001.xml", kHeader);
    write_in(folder, "TLG00001.bin", one_record(520000000, 3000));
    write_in(folder, "tlg00002.XML", kHeader);
    write_in(folder, "Tlg00002.BIN", one_record(520000100, 6000));
  }
  static std::string refusal(const std::string& file, const LogOptions& options = {}) {
    return refusal_of([&] { read_log(file, options); });
  }
};

void expect_both(const WorkLog& log) {
  ASSERT_EQ(log.fixes.size(), 2U);
  EXPECT_NEAR(log.fixes[0].position.y, 52, 1e-12);
  EXPECT_NEAR(log.fixes[1].position.y, 52.00001, 1e-12);
  EXPECT_NE(log.fixes[0].unit, log.fixes[1].unit);
  ASSERT_EQ(log.booms.size(), 2U);
  EXPECT_EQ(log.booms[static_cast<std::size_t>(log.fixes[1].boom)], (Boom{{3, -3}}));
}

TEST_F(TaskSet, FoldersInAnyCase) {
  write_set("a/TASKDATA");
  expect_both(read_log(path("a")));
  expect_both(read_log(path("a/TASKDATA")));
  expect_both(read_log(path("a/TASKDATA/TASKDATA.XML")));
  write_set("b/taskdata", "TaskData.xml");
  expect_both(read_log(path("b")));
}

TEST_F(TaskSet, ZipsWithFolders) {
  testing_files::write_zip(path("set.zip"),
                           {{"export/2020/Taskdata/TASKDATA.xml", kTasks},
                            {"export/2020/Taskdata/TLG00001.XML", kHeader},
                            {"export/2020/Taskdata/TLG00001.BIN", one_record(520000000, 3000)},
                            {"export/2020/Taskdata/tlg00002.xml", kHeader},
                            {"export/2020/Taskdata/tlg00002.bin", one_record(520000100, 6000)}});
  expect_both(read_log(path("set.zip")));
  const auto logs = list_logs(path("set.zip"));
  ASSERT_EQ(logs.size(), 2U);
  EXPECT_EQ(logs[0].name, "TLG00001");
  EXPECT_EQ(logs[0].task_id, "TSK1");
  EXPECT_EQ(logs[0].task_name, "mow");
  EXPECT_EQ(logs[0].field_id, "PFD1");
  EXPECT_EQ(logs[1].field_id, "");
  testing_files::write_zip(path("two.zip"), {{"a/TASKDATA.XML", kTasks}, {"b/TASKDATA.XML", kTasks}});
  EXPECT_TRUE(mentions(refusal(path("two.zip")), "several task sets"));
}

TEST_F(TaskSet, OneLogIsChosenByItsName) {
  write_set("TASKDATA");
  const WorkLog log = read_log(path("TASKDATA"), {"", "", "tlg00002"});
  ASSERT_EQ(log.fixes.size(), 1U);
  EXPECT_NEAR(log.fixes[0].position.y, 52.00001, 1e-12);
  EXPECT_EQ(read_log(path("TASKDATA/Tlg00002.BIN")).fixes.size(), 1U);
  EXPECT_EQ(read_log(path("TASKDATA/tlg00002.XML")).fixes.size(), 1U);
  const std::string sentence = refusal(path("TASKDATA"), {"", "", "TLG7"});
  EXPECT_TRUE(mentions(sentence, "no log 'TLG7'; found TLG00001, TLG00002")) << sentence;
}

TEST_F(TaskSet, ALogWithoutItsTaskSet) {
  write("TLG00001.xml", kHeader);
  write("TLG00001.bin", one_record(520000000, 3000));
  EXPECT_EQ(read_log(path("TLG00001.bin")).fixes.size(), 1U);
  std::filesystem::remove(folder_ / "TLG00001.xml");
  const std::string sentence = refusal(path("TLG00001.bin"));
  EXPECT_TRUE(mentions(sentence, "TLG00001.xml is missing")) << sentence;
}

TEST_F(TaskSet, ExternalFiles) {
  write("TASKDATA.XML", task_data(R"(<XFR A="TSK00001" B="1"/><XFR A="PFD00001" B="1"/>)"));
  write("TSK00001.XML", R"(<XFC><TSK A="TSK1" E="PFD1"><TLG A="TLG00001"/></TSK></XFC>)");
  write("TLG00001.xml", kHeader);
  write("TLG00001.bin", one_record(520000000, 3000));
  const std::string sentence = refusal(path("TASKDATA.XML"));
  EXPECT_TRUE(mentions(sentence, "PFD00001.XML, which is missing")) << sentence;
  write("pfd00001.xml", R"(<XFC><PFD A="PFD1"/></XFC>)");
  EXPECT_EQ(read_log(path("TASKDATA.XML")).fixes.size(), 1U);
}

TEST_F(TaskSet, WhatIsNoTaskSetIsRefused) {
  write("TASKDATA.XML", "<ISO11783_TaskData><TSK");
  EXPECT_TRUE(mentions(refusal(path("TASKDATA.XML")), "damaged XML"));
  write("TASKDATA.XML", task_data(""));
  EXPECT_TRUE(mentions(refusal(path("TASKDATA.XML")), "no time log"));
  const std::string zip = write("cut.zip", std::string("PK\x03\x04", 4) + std::string(100, 'x'));
  EXPECT_TRUE(mentions(refusal(zip), "zip"));
}

TEST_F(TaskSet, AFileThatExpandsWithoutEndIsRefused) {
  testing_files::write_zip(path("bomb.zip"), {{"TASKDATA.XML", kTasks},
                                              {"TLG00001.xml", kHeader},
                                              {"TLG00001.bin", std::string(kLargestTaskFile + 1, '\0')}});
  const std::string sentence = refusal(path("bomb.zip"));
  EXPECT_TRUE(mentions(sentence, "128 MiB")) << sentence;
}

std::string ring(const std::string& type, const std::vector<Point>& lonlat) {
  std::string out = "<LSG A=\"" + type + "\">";
  for (const Point p : lonlat)
    out += "<PNT A=\"2\" C=\"" + std::to_string(p.y) + "\" D=\"" + std::to_string(p.x) + "\"/>";
  return out + "</LSG>";
}

const std::vector<Point> kWest = {{10, 52}, {10.01, 52}, {10.01, 52.01}, {10, 52.01}};
const std::vector<Point> kEast = {{10.02, 52}, {10.03, 52}, {10.03, 52.01}, {10.02, 52.01}, {10.02, 52}};
const std::vector<Point> kPond = {{10.024, 52.004}, {10.026, 52.004}, {10.026, 52.006}};

TEST_F(TaskSet, PropertiesAreNumbersOf32Bits) {
  const TaskData data = parse_task_data(
      R"(<ISO11783_TaskData><DVC A="DVC-1"><DET A="DET-1" B="1" C="1"><DOR A="5"/><DOR A="6"/><DOR A="7"/>)"
      R"(<DOR A="8"/></DET><DPT A="5" B="0043" C="-2147483648"/><DPT A="6" B="0044" C="3001000000000000000000000"/>)"
      R"(<DPT A="7" B="0046" C="wide"/><DPT A="8" B="0087" C="1500"/></DVC></ISO11783_TaskData>)",
      [](const std::string&) { return std::optional<std::string>(); }, "t");
  ASSERT_EQ(data.elements.size(), 1U);
  const std::map<unsigned, long long> expected{{ddi::kActualWidth, -2147483648LL}, {ddi::kOffsetY, 1500}};
  EXPECT_EQ(data.elements[0].properties, expected);
}

TEST_F(TaskSet, PartfieldsOfVersion3HaveSeveralExteriorsInOnePolygon) {
  write("TASKDATA.XML", task_data("<PFD A=\"PFD1\" C=\"home\"><PLN A=\"1\">" + ring("1", kWest) +
                                  ring("1", kEast) + ring("2", kPond) + "</PLN></PFD>"));
  const RawDataset fields = read_partfields(path("TASKDATA.XML"));
  ASSERT_EQ(fields.layers.size(), 1U);
  EXPECT_EQ(fields.layers[0].crs, "EPSG:4326");
  ASSERT_EQ(fields.layers[0].features.size(), 1U);
  const RawFeature& field = fields.layers[0].features[0];
  EXPECT_EQ(field.id, "PFD1");
  ASSERT_EQ(field.polygons.size(), 2U);
  EXPECT_EQ(field.polygons[0].rings.size(), 1U);
  EXPECT_EQ(field.polygons[0].rings[0].points, kWest);
  EXPECT_FALSE(field.polygons[0].rings[0].closed);
  // The pond is in the eastern part, whose ring repeats its first point.
  ASSERT_EQ(field.polygons[1].rings.size(), 2U);
  EXPECT_TRUE(field.polygons[1].rings[0].closed);
  EXPECT_EQ(field.polygons[1].rings[0].points.size(), 4U);
  EXPECT_EQ(field.polygons[1].rings[1].points, kPond);
}

TEST_F(TaskSet, PartfieldsOfVersion4HaveAPolygonEach) {
  write("TASKDATA.XML", task_data("<PFD A=\"PFD1\"><PNT A=\"3\" C=\"1\" D=\"1\"/><PLN A=\"6\">" +
                                  ring("1", kPond) + "</PLN><GGP A=\"GGP1\"><GPN A=\"GPN1\"><PLN A=\"1\">" +
                                  ring("1", kPond) + "</PLN></GPN></GGP><PLN A=\"1\">" + ring("1", kWest) +
                                  "</PLN><PLN A=\"1\">" + ring("1", kEast) + "</PLN><PLN A=\"10\">" +
                                  ring("1", kWest) + "</PLN></PFD><PFD A=\"PFD2\"/>"));
  const RawDataset fields = read_partfields(path("TASKDATA.XML"));
  ASSERT_EQ(fields.layers.size(), 2U);
  ASSERT_EQ(fields.layers[0].features.size(), 1U);
  // Neither the guidance pattern nor the headland.
  EXPECT_EQ(fields.layers[0].features[0].polygons.size(), 2U);
  EXPECT_EQ(fields.layers[1].name, "obstacles");
  ASSERT_EQ(fields.layers[1].features.size(), 1U);
  EXPECT_EQ(fields.layers[1].features[0].polygons[0].rings[0].points, kPond);
  ASSERT_EQ(fields.skipped.size(), 1U);
  EXPECT_EQ(fields.skipped[0].what, "partfield PFD2");
}

TEST_F(TaskSet, PartfieldsThatCannotBeReadAreTold) {
  write("TASKDATA.XML",
        task_data("<PFD A=\"PFD1\"><PLN A=\"1\">" + ring("1", {{10, 52}, {10, 97}, {11, 52}}) +
                  "</PLN></PFD><PFD A=\"PFD2\"><PLN A=\"1\">" + ring("1", kWest) + "</PLN></PFD>"));
  const RawDataset fields = read_partfields(path("TASKDATA.XML"));
  EXPECT_EQ(fields.layers[0].features.size(), 1U);
  ASSERT_EQ(fields.skipped.size(), 2U);
  EXPECT_TRUE(mentions(fields.skipped[0].why, "point 2 of a ring: latitude 97"));
  write("TASKDATA.XML", task_data("<PFD A=\"PFD1\"/>"));
  EXPECT_REFUSED(read_partfields(path("TASKDATA.XML")));
}

}  // namespace tramline::task_set_test
