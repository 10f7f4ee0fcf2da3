// What counts as nothing has a name: no number as small as that stands bare in an expression.

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <regex>
#include <string>
#include <vector>

#include "architecture/source_tree.h"

namespace tramline::architecture {
namespace {

using Texts = std::vector<std::string>;

/// Numbers of the form 2e-7 or 4.5e-16, 1e-3 and smaller, outside of comments, literals and of statements
/// that define a constant.
Texts bare_epsilons(const std::string& source) {
  static const std::regex noise(R"re(//[^\n]*|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)')re");
  static const std::regex statement(R"([^;{}]+)");
  static const std::regex constant(R"(\bconstexpr\b[^=]*\bk[A-Z]\w*\s*=(?!=))");
  static const std::regex number(R"((^|[^\w.])((?:[0-9]+\.?[0-9]*|\.[0-9]+)[eE]-[0-9]+))");
  constexpr double kLargest = 1e-3;
  const std::string code = std::regex_replace(source, noise, " ");
  Texts out;
  for (std::sregex_iterator part(code.begin(), code.end(), statement), end; part != end; ++part) {
    const std::string text = part->str();
    if (text.find("e-") == std::string::npos && text.find("E-") == std::string::npos) continue;
    if (std::regex_search(text, constant)) continue;
    for (std::sregex_iterator found(text.begin(), text.end(), number); found != end; ++found)
      if (std::strtod((*found)[2].str().c_str(), nullptr) <= kLargest) out.push_back((*found)[2]);
  }
  return out;
}

TEST(BareEpsilons, AreNumbersInExpressions) {
  EXPECT_EQ(bare_epsilons("bool a(double x) { return x < 1e-9; }"), Texts{"1e-9"});
  EXPECT_EQ(bare_epsilons("const double least = 1e-9 / distance(a, b), most=(1-.5E-6);"),
            (Texts{"1e-9", ".5E-6"}));
  EXPECT_EQ(bare_epsilons("if (x > 2.5e-04) return;\nreturn y > 1e-3 * x;"), (Texts{"2.5e-04", "1e-3"}));
  EXPECT_EQ(bare_epsilons("constexpr double kSame_m = 1e-9; if (x < 1e-6) return;"), Texts{"1e-6"});
  EXPECT_EQ(bare_epsilons("if constexpr (kExact == 1e-9) {}"), Texts{"1e-9"});
  EXPECT_EQ(bare_epsilons("double off(double to = 1e-5);\nstruct A {\n  double least = 1e-4;\n};"),
            (Texts{"1e-5", "1e-4"}));
}

TEST(BareEpsilons, AreNeitherConstantsNorWords) {
  EXPECT_EQ(bare_epsilons("/// within 1e-9 m\nconstexpr double kSame_m = 1e-9;  // not 1e-6\n"), Texts{});
  EXPECT_EQ(bare_epsilons("inline constexpr double kNear_m = 1e-4, kFar_m = 1e-3,\n    kTie = 1 - 1e-6;"),
            Texts{});
  EXPECT_EQ(bare_epsilons("constexpr std::array kSteps{1, 2}; say(\"1e-9\", 'e', \"a\\\"1e-9\");"), Texts{});
  EXPECT_EQ(bare_epsilons("return 1e-2 * x + 1e9 + 0.25 + name1e-9 + 0x1e-9;"), Texts{});
}

TEST(BareEpsilons, ThereAreNone) {
  constexpr std::array kRooms{"geometry",  "headland", "decomposition", "tracks", "cost",
                              "avoidance", "route",    "planner",       "check"};
  for (const std::string room : kRooms) {
    int files = 0;
    for (const std::string& path : repository_files()) {
      if (!is_in_room(path, room)) continue;
      if (!path.ends_with(".h") && !path.ends_with(".cpp")) continue;
      ++files;
      for (const std::string& number : bare_epsilons(read(path)))
        ADD_FAILURE() << path << " has " << number
                      << " in an expression; name it, in tolerances.h if it is not "
                      << "of one algorithm alone";
    }
    EXPECT_GT(files, 15) << "there is less to read in " << room << " than there should be";
  }
}

}  // namespace
}  // namespace tramline::architecture
