// What is asked of straight and of curved tracks is asked once: no function stands twice, for the one and for
// the other.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.h"

namespace tramline::architecture::twin_names_test {

using Names = std::set<std::string>;

/// The names of functions that source declares or defines outside of types and other functions, as the format
/// of the project has them: at the beginning of a line.
Names free_functions(const std::string& source) {
  static const std::regex declaration(R"(^[A-Za-z_][A-Za-z0-9_:<>,&* ]*[ &*]([a-z_][a-z0-9_]*)\()");
  static const std::regex statement(R"(^(return|else|throw|using|typedef|namespace)\b)");
  Names out;
  for (std::size_t start = 0; start < source.size();) {
    const std::size_t end = std::min(source.find('\n', start), source.size());
    const std::string line = source.substr(start, std::min<std::size_t>(end - start, 400));
    std::smatch match;
    if (!std::regex_search(line, statement) && std::regex_search(line, match, declaration))
      out.insert(match[1]);
    start = end + 1;
  }
  return out;
}

/// The name without the words that tell straight from curved.
std::string question(const std::string& name) {
  std::string out;
  for (std::size_t start = 0; start <= name.size();) {
    const std::size_t end = std::min(name.find('_', start), name.size());
    const std::string word = name.substr(start, end - start);
    if (word != "curved" && word != "straight") out += (out.empty() ? "" : "_") + word;
    start = end + 1;
  }
  return out;
}

TEST(TwinNames, AreThoseThatDifferInWhatTheTracksAreLike) {
  EXPECT_EQ(free_functions("int a(int x) {\n  return b(x);\n}\nstd::vector<Track> curved_tracks(\n    int);\n"
                           "// no such(thing)\nclass C {\n  int member();\n};\nreturn f(x);\n"),
            (Names{"a", "curved_tracks"}));
  EXPECT_EQ(question("curved_tracks"), "tracks");
  EXPECT_EQ(question("straight_tracks"), "tracks");
  EXPECT_EQ(question("lay_curved_tracks"), "lay_tracks");
  EXPECT_EQ(question("straighten"), "straighten");
}

TEST(TwinNames, ThereAreNone) {
  // What is different by nature: where the tracks come from, the closed form of a straight track's detour,
  // which the general one is tested against, and a request that only one kind can answer.
  const std::set<Names> by_nature{{"curved_tracks", "straight_tracks"},
                                  {"curved_search", "straight_search"},
                                  {"curved_detour_path", "detour_path"},
                                  {"require_straight_tracks", "require_tracks"}};
  constexpr std::array kRooms{"tracks", "cost", "avoidance", "planner", "check"};
  std::map<std::string, Names> by_question;
  for (const std::string& path : repository_files()) {
    const bool source = path.ends_with(".h") || path.ends_with(".cpp");
    const bool in_room = std::any_of(kRooms.begin(), kRooms.end(),
                                     [&path](const char* room) { return is_in_room(path, room); });
    if (!source || !in_room) continue;
    for (const std::string& name : free_functions(read(path))) by_question[question(name)].insert(name);
  }
  EXPECT_GT(by_question.size(), 500U) << "there is less to read than there should be";
  std::size_t known = 0;
  for (const auto& [asked, names] : by_question) {
    if (asked.empty() || names.size() < 2) continue;
    if (by_nature.count(names) > 0)
      ++known;
    else
      ADD_FAILURE() << *names.begin() << " and " << *names.rbegin() << " ask the same";
  }
  EXPECT_EQ(known, by_nature.size()) << "an exception is none any more";
}

}  // namespace tramline::architecture::twin_names_test
