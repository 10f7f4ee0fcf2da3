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

TEST_F(MachineFile, TheExampleIsAMachine) {
  const Machine machine = io::read_machine(std::filesystem::path(TRAMLINE_EXAMPLES) / "machine.toml");
  EXPECT_FALSE(machine.name.empty());
  EXPECT_GT(machine.width_m, 0);
}

}  // namespace
}  // namespace tramline
