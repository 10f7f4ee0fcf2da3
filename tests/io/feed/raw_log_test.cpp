#include "tramline/io/feed/raw_log.h"
#include "support/refusals.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

class RawLogs : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = std::filesystem::temp_directory_path() /
              ("raw_log_" + std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) +
               std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string path() const { return (folder_ / "a.log").string(); }
  std::string content() const {
    std::ifstream file(path(), std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::filesystem::path folder_;
};

TEST_F(RawLogs, LinesAreThereAtOnce) {
  RawLog log(path());
  log.append("a\nb\r\n");
  EXPECT_EQ(content(), "a\nb\r\n");
}

TEST_F(RawLogs, WhatWasBeingWrittenIsCutOff) {
  std::ofstream(path(), std::ios::binary) << "a\nb\ntor";
  RawLog log(path());
  EXPECT_EQ(log.take_lines_before(), (std::vector<std::string>{"a", "b"}));
  log.append("c\n");
  EXPECT_EQ(content(), "a\nb\nc\n");
}

TEST_F(RawLogs, OnlyOneAtATime) {
  {
    const RawLog log(path());
    EXPECT_REFUSED(RawLog{path()});
  }
  EXPECT_NO_THROW(RawLog{path()});
}

TEST_F(RawLogs, AFolderThatIsNotThere) { EXPECT_REFUSED(RawLog((folder_ / "no" / "a.log").string())); }

TEST_F(RawLogs, WhatFindsNoRoomIsWrittenLater) {
  RawLog log(path());
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit small{10, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  log.append("12345678\nabc\n");
  EXPECT_NE(log.fault(), "");
  log.append("def\n");
  log.retry();
  EXPECT_NE(log.fault(), "");
  setrlimit(RLIMIT_FSIZE, &before);
  log.retry();
  EXPECT_EQ(log.fault(), "");
  EXPECT_EQ(content(), "12345678\nabc\ndef\n");
}

}  // namespace
}  // namespace tramline::io
