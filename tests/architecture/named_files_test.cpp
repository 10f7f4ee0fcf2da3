// Pages that name a file of the library name one that exists.

#include <gtest/gtest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <string>

#include "architecture/rules.h"
#include "architecture/source_tree.h"

namespace tramline::architecture {
namespace {

/// "planner/search/branch_and_bound" of "`planner/search/branch_and_bound`" or "`src/tramline/….h`".
std::set<std::string> files_named_in(const std::string& page) {
  std::string names;
  for (const std::string& room : rooms()) names += (names.empty() ? "" : "|") + room;
  const std::regex pattern("`(?:(?:src|include)/tramline/)?((?:" + names +
                           ")/[a-z_0-9/]*[a-z_0-9])(?:\\.h|\\.cpp)?`");
  std::set<std::string> out;
  for (std::sregex_iterator found(page.begin(), page.end(), pattern), end; found != end; ++found)
    out.insert((*found)[1]);
  return out;
}

TEST(NamedFiles, AreFoundInAPage) {
  EXPECT_EQ(
      files_named_in("in `cost/grid/grid_tally` and `src/tramline/model/track.h`, not `docs/x` or cost/y"),
      (std::set<std::string>{"cost/grid/grid_tally", "model/track"}));
}

TEST(NamedFiles, Exist) {
  std::set<std::string> known;
  for (const std::string& path : repository_files()) {
    if (!path.starts_with("src/tramline/") && !path.starts_with("include/tramline/")) continue;
    std::string inside = path.substr(path.find("tramline/") + std::string("tramline/").size());
    known.insert(inside.substr(0, inside.rfind('.')));
    for (std::size_t slash = inside.rfind('/'); slash != std::string::npos; slash = inside.rfind('/')) {
      inside.resize(slash);
      known.insert(inside);
    }
  }
  std::size_t named = 0;
  for (const std::string& path : repository_files()) {
    if (!path.ends_with(".md") || path == "CHANGELOG.md") continue;
    for (const std::string& file : files_named_in(read(path))) {
      ++named;
      EXPECT_EQ(known.count(file), 1U) << path << " names " << file << ", which does not exist";
    }
  }
  EXPECT_GT(named, 80U) << "there are fewer names than there should be";
}

}  // namespace
}  // namespace tramline::architecture
