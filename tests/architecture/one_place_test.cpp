// Facts that must stand in one place, and things that must stand in none.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <string>

#include "architecture/source_tree.h"

namespace tramline::architecture::one_place_test {

// "1.2.3" as a word of its own: neither "11.2.3" nor "1.2.34" nor "1.2.3.4".
std::regex version_pattern(const std::string& version) {
  const std::string escaped = std::regex_replace(version, std::regex("\\."), "\\.");
  return std::regex("(^|[^0-9.])" + escaped + "($|[^0-9.]|\\.($|[^0-9]))");
}

// Folders that exist on the machine of one developer. Relative paths that merely contain such a
// name, addresses on the web and the made-up home of somebody are left alone.
const std::regex& machine_path() {
  static const std::regex pattern(
      R"re((^|[^A-Za-z0-9_./~})-])/(home|Users|root|work)/(?!somebody)[A-Za-z0-9_.])re");
  return pattern;
}

bool is_text(const std::string& bytes) { return bytes.find('\0') == std::string::npos; }

// The number of the first line that matches, 0 if none does.
int line_of(const std::string& text, const std::regex& pattern) {
  int number = 1;
  std::size_t start = 0;
  while (start <= text.size()) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    // Long lines are data; the standard library's regular expressions recurse once per character.
    const std::string line = text.substr(start, std::min<std::size_t>(end - start, 4000));
    if (std::regex_search(line, pattern)) return number;
    start = end + 1;
    ++number;
  }
  return 0;
}

TEST(OnePlace, ThePatternsSeeWhatTheyMustSee) {
  const std::string folder = "/wo";
  EXPECT_EQ(line_of("a\nsee " + folder + "rk/tree/x.h\n", machine_path()), 2);
  EXPECT_EQ(line_of("\"/ho" + std::string("me/someone/field.gpkg\""), machine_path()), 1);
  EXPECT_EQ(line_of("https://example.org" + folder + "rk/page", machine_path()), 0);
  EXPECT_EQ(line_of("/ho" + std::string("me/somebody/field.gpkg"), machine_path()), 0);
  EXPECT_EQ(line_of("coverage" + folder + "rk/log", machine_path()), 0);
  EXPECT_EQ(line_of("the version is 1.2.3.", version_pattern("1.2.3")), 1);
  EXPECT_EQ(line_of("version=\"1.2.3\"", version_pattern("1.2.3")), 1);
  EXPECT_EQ(line_of("11.2.3 and 1.2.34 and 1.2.3.4 and 1x2x3", version_pattern("1.2.3")), 0);
}

TEST(OnePlace, TheVersionIsWrittenInTheTopCMakeListsOnly) {
  const std::string top = read("CMakeLists.txt");
  std::smatch match;
  ASSERT_TRUE(std::regex_search(top, match, std::regex(R"(project\(tramline VERSION (\d+\.\d+\.\d+))")));
  const std::regex version = version_pattern(match[1]);
  for (const std::string& path : repository_files()) {
    // The change log tells history; data are not ours to word.
    const bool data = path.starts_with("examples/") || path.starts_with("bench/results/") ||
                      path.starts_with("tests/data/");
    if (path == "CMakeLists.txt" || path == "CHANGELOG.md" || data) continue;
    const std::string text = read(path);
    if (!is_text(text)) continue;
    EXPECT_EQ(line_of(text, version), 0) << path << " repeats the version " << match[1];
  }
}

TEST(OnePlace, NoFileNamesAFolderOfOneMachine) {
  for (const std::string& path : repository_files()) {
    const std::string text = read(path);
    if (!is_text(text)) continue;
    EXPECT_EQ(line_of(text, machine_path()), 0) << path << " names a folder of one machine";
  }
}

}  // namespace tramline::architecture::one_place_test
