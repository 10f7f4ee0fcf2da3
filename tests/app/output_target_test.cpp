// Whether results can be written is found out before the work, and finding out leaves nothing behind.

#include "output/output_target.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "tramline/geometry/error.h"

namespace tramline::app {
namespace {

namespace fs = std::filesystem;

class OutputTarget : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("tramline-targets-" + std::to_string(getpid()));
    fs::create_directory(folder_);
    std::ofstream(folder_ / "notes") << "text";
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// What is said against a folder for close-ups; "" where it will do.
  std::string against_folder(const fs::path& name) const {
    return said([&] { require_folder(name.string(), "--zoom-obstacles"); });
  }
  std::string against_file(const fs::path& name) const {
    return said([&] { require_writable(name.string(), "--output", {".gpkg"}, {}); });
  }
  static std::string said(const std::function<void()>& require) {
    try {
      require();
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      return error.what();
    }
    return "";
  }
  /// Only the file of SetUp().
  bool untouched() const {
    return std::distance(fs::directory_iterator(folder_), fs::directory_iterator()) == 1;
  }
  fs::path folder_;
};

const std::string kTooLong(300, 'x');

TEST_F(OutputTarget, TakesFoldersThatCanBeMade) {
  EXPECT_EQ(against_folder(folder_), "");
  EXPECT_EQ(against_folder(folder_ / "new"), "");
  EXPECT_EQ(against_folder(folder_ / "new/"), "");
  EXPECT_EQ(against_folder(folder_ / "new/and/deep"), "");
  EXPECT_TRUE(untouched());
}

TEST_F(OutputTarget, RefusesFoldersThatCannot) {
  for (const fs::path& name : {folder_ / "notes", folder_ / "notes/below", folder_ / kTooLong,
                               folder_ / "new" / kTooLong, fs::path("/proc/closeups"), fs::path("/proc")}) {
    const std::string sentence = against_folder(name);
    EXPECT_NE(sentence.find("--zoom-obstacles '" + name.string() + "'"), std::string::npos) << sentence;
  }
  EXPECT_TRUE(untouched());
}

TEST_F(OutputTarget, TakesFilesThatCanBeWritten) {
  EXPECT_EQ(against_file(folder_ / "plan.gpkg"), "");
  EXPECT_TRUE(untouched());
}

TEST_F(OutputTarget, TakesExtensionsInAnyCase) {
  EXPECT_EQ(against_file(folder_ / "PLAN.GPKG"), "");
  EXPECT_EQ(against_file(folder_ / "Plan.Gpkg"), "");
  EXPECT_NE(against_file(folder_ / "plan.GPK"), "");
}

TEST_F(OutputTarget, RefusesFilesThatCannot) {
  for (const fs::path& name : {folder_ / "missing/plan.gpkg", folder_ / "notes/plan.gpkg",
                               folder_ / (kTooLong + ".gpkg"), fs::path("/proc/plan.gpkg")}) {
    const std::string sentence = against_file(name);
    EXPECT_NE(sentence.find("--output '" + name.string() + "'"), std::string::npos) << sentence;
  }
  EXPECT_TRUE(untouched());
}

TEST_F(OutputTarget, LeavesTheFileThatWillBeReplaced) {
  std::ofstream(folder_ / "plan.gpkg") << "older";
  EXPECT_EQ(against_file(folder_ / "plan.gpkg"), "");
  EXPECT_EQ(fs::file_size(folder_ / "plan.gpkg"), 5u);
}

}  // namespace
}  // namespace tramline::app
