// Rooms that one can take in at a glance: few files in each folder, folders of one module that do not know
// one another in a circle, and a face to the outside that is small and stands for itself.

#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.h"

namespace tramline::architecture::rooms_test {

using Names = std::set<std::string>;

constexpr std::size_t kMostInAFolder = 20;
constexpr std::size_t kMostPublicHeaders = 70;

/// Folders with more, each with the reason.
const std::map<std::string, std::string> kLargeFolders = {
    {"docs", "a page for each subject, to which the README of the project leads"},
    {"docs/adr", "one page for each decision, numbered in the order in which they were made"},
    {"tests/render", "one file for each part of a picture and each kind of it"},
    {"tests/properties", "one file for each property"},
    {"tests/real", "one file for each promise that is held against real data"},
};

std::string folder_of(const std::string& path) {
  const std::size_t slash = path.rfind('/');
  return slash == std::string::npos ? "" : path.substr(0, slash);
}

/// A header and its source are one.
std::string unit_of(const std::string& path) { return path.substr(0, path.rfind('.')); }

bool is_source(const std::string& path) {
  static const std::regex pattern(R"(.*\.(h|cpp|ts|tsx|py|mjs|md))");
  return std::regex_match(path, pattern);
}

/// "geometry/path/path.h" of `#include "tramline/geometry/path/path.h"`.
Names included_by(const std::string& text) {
  static const std::regex pattern(R"re(#include "tramline/([^"]+)")re");
  Names out;
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found)
    out.insert((*found)[1]);
  return out;
}

TEST(Rooms, HoldTwentyFilesAtTheMostOrSayWhy) {
  std::map<std::string, Names> units;
  for (const std::string& path : repository_files())
    if (is_source(path)) units[folder_of(path)].insert(unit_of(path));
  EXPECT_GT(units.size(), 80U) << "there is less to read than there should be";
  for (const auto& [folder, names] : units)
    EXPECT_EQ(names.size() > kMostInAFolder, kLargeFolders.count(folder) > 0)
        << folder << " holds " << names.size() << " files";
}

/// What a folder of a module includes of the module's other folders. What lies in the module's own folder is
/// its face and its ground floor: it may be used by all of them, and use them.
std::map<std::string, Names> ways_between_folders() {
  std::map<std::string, Names> out;
  for (const std::string& path : repository_files()) {
    if (!is_product_source(path) || path.starts_with("apps/") || path.starts_with("python/")) continue;
    const std::string from = folder_of(path.substr(path.find("tramline/") + std::string("tramline/").size()));
    for (const std::string& header : included_by(read(path))) {
      const std::string to = folder_of(header);
      const std::string module = from.substr(0, from.find('/'));
      if (to == from || to == module || from == module || !to.starts_with(module + "/")) continue;
      out[from].insert(to);
    }
  }
  return out;
}

TEST(Rooms, OfOneModuleDoNotUseOneAnotherInACircle) {
  const std::map<std::string, Names> ways = ways_between_folders();
  EXPECT_GT(ways.size(), 15U) << "there is less to read than there should be";
  std::set<std::string> done, open;
  const std::function<void(const std::string&)> visit = [&](const std::string& folder) {
    if (done.count(folder) > 0) return;
    open.insert(folder);
    if (const auto on = ways.find(folder); on != ways.end())
      for (const std::string& next : on->second) {
        EXPECT_EQ(open.count(next), 0U) << folder << " and " << next << " use each other";
        if (open.count(next) == 0) visit(next);
      }
    open.erase(folder);
    done.insert(folder);
  };
  for (const auto& [folder, next] : ways) visit(folder);
}

TEST(PublicHeaders, AreFewAndStandForThemselves) {
  std::map<std::string, Names> headers;
  for (const std::string& path : repository_files())
    if (path.starts_with("include/tramline/"))
      headers[path.substr(std::string("include/tramline/").size())] = included_by(read(path));
  EXPECT_GT(headers.size(), 50U);
  EXPECT_LE(headers.size(), kMostPublicHeaders);
  for (const auto& [header, included] : headers)
    for (const std::string& other : included)
      EXPECT_EQ(headers.count(other), 1U) << header << " includes " << other << ", which is not installed";
}

}  // namespace tramline::architecture::rooms_test
