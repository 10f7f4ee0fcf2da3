#include "output/run_record.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.h"

namespace tramline::app {
namespace {

using testing_support::bytes_of;
using testing_support::TemporaryFolder;
using Start = RunRecord::Start;

class RunRecordTest : public testing::Test {
 protected:
  std::filesystem::path file() const { return folder_ / "plan.run.jsonl"; }
  std::string made(const std::string& name) const {
    std::ofstream(folder_ / name) << "plan";
    return (folder_ / name).string();
  }
  TemporaryFolder folder_;
};

TEST_F(RunRecordTest, GivesBackWhatIsFinished) {
  {
    RunRecord record(file(), Start::kAnew);
    record.add("farm:1", "abc",
               {{{"area_m2", 0.1}, {"name", "Große Breite"}}, "one\n", {made("1.gpkg")}, false});
    record.add("farm:2", "def", {{{"error", "too small"}}, "two refused: too small\n", {}, true});
  }
  const RunRecord record(file(), Start::kResume);
  const FieldResult* first = record.finished("farm:1", "abc");
  ASSERT_NE(first, nullptr);
  EXPECT_EQ(first->json.dump(), R"({"area_m2":0.1,"name":"Große Breite"})");
  EXPECT_EQ(first->text, "one\n");
  EXPECT_FALSE(first->refused);
  ASSERT_NE(record.finished("farm:2", "def"), nullptr);
  EXPECT_TRUE(record.finished("farm:2", "def")->refused);
  EXPECT_EQ(record.finished("farm:2", "abc"), nullptr) << "made from something else";
  EXPECT_EQ(record.finished("farm:3", "abc"), nullptr);
}

TEST_F(RunRecordTest, AFieldWhoseFileIsGoneIsNotFinished) {
  RunRecord record(file(), Start::kAnew);
  const std::string plan = made("1.gpkg");
  record.add("farm:1", "abc", {{}, "", {plan}, false});
  EXPECT_NE(record.finished("farm:1", "abc"), nullptr);
  std::filesystem::remove(plan);
  EXPECT_EQ(record.finished("farm:1", "abc"), nullptr);
}

TEST_F(RunRecordTest, ARunThatDoesNotGoOnBeginsAnew) {
  RunRecord(file(), Start::kAnew).add("farm:1", "abc", {{}, "", {}, false});
  const RunRecord record(file(), Start::kAnew);
  EXPECT_EQ(record.finished("farm:1", "abc"), nullptr);
  EXPECT_FALSE(std::filesystem::exists(file()));
}

// Whatever a kill leaves of the file: each field is finished or not, and what is added then can be read.
TEST_F(RunRecordTest, MayBeCutOffAnywhere) {
  std::vector<std::size_t> ends;
  {
    RunRecord record(file(), Start::kAnew);
    for (const char* key : {"farm:1", "farm:2", "farm:3"}) {
      record.add(key, "abc", {{{"key", key}}, std::string(key) + "\n", {}, false});
      ends.push_back(bytes_of(file()).size());
    }
  }
  const std::string whole = bytes_of(file());
  for (std::size_t length = 0; length <= whole.size(); ++length) {
    SCOPED_TRACE(length);
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << whole.substr(0, length);
    RunRecord record(file(), Start::kResume);
    for (std::size_t i = 0; i < 3; ++i)
      ASSERT_EQ(record.finished("farm:" + std::to_string(i + 1), "abc") != nullptr, length >= ends[i]) << i;
    record.add("farm:4", "abc", {{{"key", "farm:4"}}, "", {}, false});
    const RunRecord again(file(), Start::kResume);
    ASSERT_NE(again.finished("farm:4", "abc"), nullptr);
    ASSERT_EQ(again.finished("farm:1", "abc") != nullptr, length >= ends[0]);
  }
}

TEST_F(RunRecordTest, ForgetsWhatLiesInAFile) {
  RunRecord record(file(), Start::kAnew);
  record.add("farm:1", "abc", {{}, "", {made("whole.gpkg")}, false});
  record.add("farm:2", "abc", {{}, "", {made("part.gpkg")}, false});
  record.forget_those_in((folder_ / "whole.gpkg").string());
  EXPECT_EQ(record.finished("farm:1", "abc"), nullptr);
  EXPECT_NE(record.finished("farm:2", "abc"), nullptr);
}

}  // namespace
}  // namespace tramline::app
