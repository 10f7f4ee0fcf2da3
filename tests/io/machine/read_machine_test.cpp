#include "tramline/io/machine/read_machine.h"
#include "support/refusals.h"
#include "support/temporary_folder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/machine/machine_table.h"
#include "tramline/model/turning_values.h"

namespace tramline {
namespace {

using testing_support::refusal_of;
using testing_support::TemporaryFolder;

class MachineFile : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& text) const {
    std::ofstream(folder_ / "m.toml", std::ios::binary) << text;
    return folder_ / "m.toml";
  }
  Machine read(const std::string& text) const { return io::read_machine(write(text)); }
  std::string refusal(const std::string& text) const { return refusal_at(write(text)); }
  static std::string refusal_at(const std::filesystem::path& path) {
    const std::string sentence = refusal_of([&] { io::read_machine(path); });
    EXPECT_EQ(sentence.find('\n'), std::string::npos);
    return sentence;
  }
  TemporaryFolder folder_;
};

void expect_says(const std::string& message, std::initializer_list<std::string> words) {
  for (const std::string& word : words) EXPECT_NE(message.find(word), std::string::npos) << message;
}

TEST_F(MachineFile, AllKeys) {
  const Machine machine =
      read("name = \"spreader\"\nwidth_m = 24\nturning_radius_m = 7.5\nmin_track_length_m = 0\n");
  EXPECT_EQ(machine.name, "spreader");
  EXPECT_EQ(machine.width_m, 24);
  EXPECT_EQ(machine.radius_m, 7.5);
  EXPECT_EQ(min_length_m(machine), 0);
}

TEST_F(MachineFile, WidthIsEnough) {
  const Machine machine = read("\xEF\xBB\xBF# a byte order mark, as some editors write\r\nwidth_m = 3.5\r\n");
  EXPECT_EQ(machine.width_m, 3.5);
  EXPECT_EQ(machine.radius_m, Machine{}.radius_m);
  EXPECT_EQ(min_length_m(machine), 7);
}

TEST_F(MachineFile, TablesDeepWithinTablesAreRefused) {
  // A parser that goes down a call for each dot comes to the end of its stack.
  std::string key = "a";
  for (int i = 0; i < 100'000; ++i) key += ".a";
  const std::vector<std::string> texts = {key + " = 1", "[" + key + "]", "name = {" + key + " = 1}"};
  for (const std::string& text : texts)
    expect_says(refusal("width_m = 3\r\n" + text), {"m.toml", "line 2", "64 dots"});
  const std::string dots(500, '.');
  EXPECT_EQ(read("  # " + dots + "\nwidth_m = 3\n").width_m, 3);
}

TEST_F(MachineFile, UnknownKeyListsTheKnownOnes) {
  expect_says(refusal("width_m = 3\nwidht_m = 4\n"),
              {"m.toml", "line 2", "widht_m", "name, width_m, turning_radius_m, min_track_length_m"});
  expect_says(refusal("width_m = 3\n[sections]\ncount = 4\n"), {"line 2", "sections"});
}

TEST_F(MachineFile, WrongLengthNamesFileLineAndKey) {
  for (const char* value : {"-3", "-0.1", "nan", "-nan", "inf", "1e308", "1.1e7", "0", "0.0", "\"3\"", "true",
                            "[3]", "1979-05-27"})
    expect_says(refusal(std::string("name = \"x\"\nwidth_m = ") + value + "\n"),
                {"m.toml", "line 2", "width_m"});
  for (const std::string key : {"turning_radius_m", "min_track_length_m"})
    for (const char* value : {"-1", "nan", "inf", "1e308", "1.1e7", "\"3\""})
      expect_says(refusal("width_m = 3\n\n" + key + " = " + value), {"m.toml", "line 3", key});
}

TEST_F(MachineFile, NameIsText) { expect_says(refusal("width_m = 3\nname = 7\n"), {"line 2", "name"}); }

TEST_F(MachineFile, WidthIsNeeded) {
  expect_says(refusal(""), {"m.toml", "width_m", "missing"});
  expect_says(refusal("name = \"x\"\n"), {"width_m"});
}

TEST_F(MachineFile, WhatIsNoToml) {
  expect_says(refusal("name = \"x\"\nwidth_m 3\n"), {"m.toml", "line 2", "TOML"});
  expect_says(refusal("width_m = 3\nwidth_m = 4\n"), {"line 2"});
  refusal(std::string("\0\xff\xfe", 3));
  refusal(std::string(100000, '['));
  expect_says(refusal(std::string(2 << 20, '#')), {"too long"});
}

TEST_F(MachineFile, WhatCannotBeRead) {
  expect_says(refusal_at(folder_ / "none.toml"), {"none.toml", "cannot be read"});
  expect_says(refusal_at(folder_.path()), {"cannot be read"});
}

TEST_F(MachineFile, AllKeysForTurning) {
  const Turning turning = read(R"(width_m = 36
reverse = true
working_speed_mps = 3
turning_speed_mps = 2
reverse_speed_mps = 0.5
gear_change_s = 4
steering_time_s = 1.5
lift_m = 2
lower_m = 1
implement = "towed"
implement_offset_m = 1.2
drawbar_m = 6.5
front_overhang_m = 3.8
rear_overhang_m = 0.4
vehicle_width_m = 2.55
)")
                              .turning;
  EXPECT_TRUE(turning.reverse);
  EXPECT_EQ(turning.working_speed_mps, 3);
  EXPECT_EQ(turning.turning_speed_mps, 2);
  EXPECT_EQ(turning.reverse_speed_mps, 0.5);
  EXPECT_EQ(turning.gear_change_s, 4);
  EXPECT_EQ(turning.steering_time_s, 1.5);
  EXPECT_EQ(turning.lift_m, 2);
  EXPECT_EQ(turning.lower_m, 1);
  EXPECT_EQ(turning.implement, Coupling::kTowed);
  EXPECT_EQ(turning.implement_offset_m, 1.2);
  EXPECT_EQ(turning.drawbar_m, 6.5);
  EXPECT_EQ(turning.front_overhang_m, 3.8);
  EXPECT_EQ(turning.rear_overhang_m, 0.4);
  EXPECT_EQ(turning.vehicle_width_m, 2.55);
}

TEST_F(MachineFile, WithoutThemTurningIsTheDefault) {
  EXPECT_EQ(read("width_m = 3\n").turning, Turning{});
  EXPECT_EQ(read("width_m = 6\nimplement_offset_m = -3.5\n").turning.implement_offset_m, -3.5);
}

TEST_F(MachineFile, WrongValuesForTurningNameFileLineAndKey) {
  for (const std::string key : {"working_speed_mps", "turning_speed_mps", "reverse_speed_mps"})
    for (const char* value : {"0", "-1", "101", "nan", "inf", "\"2\"", "true"})
      expect_says(refusal("width_m = 3\n" + key + " = " + value), {"m.toml", "line 2", key});
  for (const std::string key : {"gear_change_s", "steering_time_s", "lift_m", "lower_m", "front_overhang_m",
                                "rear_overhang_m", "vehicle_width_m", "drawbar_m"})
    for (const char* value : {"-0.1", "601", "nan", "inf", "\"2\"", "[1]"})
      expect_says(refusal("width_m = 3\n\n" + key + " = " + value), {"m.toml", "line 3", key});
  expect_says(refusal("width_m = 3\nimplement_offset_m = -101"), {"line 2", "at least -100", "100 m"});
  expect_says(refusal("width_m = 3\nworking_speed_mps = 0"), {"more than 0 and at most 100 m/s"});
  expect_says(refusal("width_m = 3\nreverse = 1"), {"line 2", "reverse", "true or false"});
  expect_says(refusal("width_m = 3\nreverse = \"yes\""), {"line 2", "reverse", "true or false"});
  for (const char* value : {"\"trailed\"", "1", "true"})
    expect_says(refusal(std::string("width_m = 3\nimplement = ") + value), {"line 2", "mounted", "towed"});
}

TEST_F(MachineFile, ADrawbarGoesWithATowedImplement) {
  expect_says(refusal("width_m = 3\ndrawbar_m = 4\n"), {"line 2", "drawbar_m", "mounted implement has no"});
  expect_says(refusal("width_m = 3\nimplement = \"mounted\"\ndrawbar_m = 4\n"), {"line 3", "drawbar_m"});
  expect_says(refusal("width_m = 3\nimplement = \"towed\"\n"), {"line 2", "drawbar_m is missing"});
  expect_says(refusal("width_m = 3\nimplement = \"towed\"\ndrawbar_m = 0\n"), {"line 3", "drawbar_m"});
}

// How many there are, and that all of them are kept, is what the list of machines of a server rests on.
TEST_F(MachineFile, ListsKeepAllValues) {
  Machine sprayer{"sprayer", 36, 7, -1, {}};
  sprayer.turning.reverse = true;
  sprayer.turning.implement = Coupling::kTowed;
  double value = 1.1;
  for (const TurningNumber& number : kTurningNumbers) sprayer.turning.*number.value = value += 1.0 / 3;
  sprayer.rates.operation = Operation::kSpraying;
  sprayer.rates.sections = 36;
  sprayer.rates.fuel_price = 1.0 / 3;
  const std::vector<io::ListedMachine> machines{{"a", {"plain", 3, 6, 0, {}}}, {"b", sprayer}};
  io::write_machines(machines, folder_ / "machines.gpkg");
  const auto read_back = io::read_machines(folder_ / "machines.gpkg");
  ASSERT_EQ(read_back.size(), 2U);
  EXPECT_EQ(read_back[0].machine.turning, Turning{});
  EXPECT_EQ(read_back[1].machine.turning, sprayer.turning);
  EXPECT_EQ(read_back[0].machine.rates, Rates{});
  EXPECT_EQ(read_back[1].machine.rates, sprayer.rates);
  EXPECT_EQ(read_back[1].machine.name, "sprayer");
}

TEST_F(MachineFile, TheExamplesAreMachines) {
  int seen = 0;
  for (const auto& entry :
       std::filesystem::directory_iterator(std::filesystem::path(TRAMLINE_EXAMPLES) / "machines")) {
    SCOPED_TRACE(entry.path().filename());
    const Machine machine = io::read_machine(entry.path());
    EXPECT_FALSE(machine.name.empty());
    EXPECT_NE(machine.turning, Turning{});
    ++seen;
  }
  EXPECT_EQ(seen, 6);
}

TEST_F(MachineFile, TheExampleIsAMachine) {
  const Machine machine = io::read_machine(std::filesystem::path(TRAMLINE_EXAMPLES) / "machine.toml");
  EXPECT_FALSE(machine.name.empty());
  EXPECT_GT(machine.width_m, 0);
}

}  // namespace
}  // namespace tramline
