// A call says what it means: `reported(areas, RepeatRule::kStrict)`, not `reported(areas, true)`. So no
// public function takes a bool by value, unless its own name says what is true then.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>
#include <vector>

#include "architecture/bool_parameters.h"
#include "architecture/source_tree.h"

namespace tramline::architecture {
namespace {

/// Functions that take a bare bool, by header, each with the reason.
const std::map<std::string, std::string> kExceptions = {
    {"apps/server/work/live_feed.h set_work", "it is the work that is on"},
    {"apps/tramline/output/progress.h ProgressLine", "it is given what --quiet says, and nothing else"},
    {"src/tramline/io/log/state_lines.h work_line", "the line says whether the machine works"},
};

/// "LINE FUNCTION PARAMETER" of each.
std::vector<std::string> found_in(const std::string& header) {
  std::vector<std::string> out;
  for (const BoolParameter& found : bool_parameters(header))
    out.push_back(std::to_string(found.line) + " " + found.function + " " + found.parameter);
  return out;
}

using Found = std::vector<std::string>;

TEST(BoolParameters, AreFoundWhereverTheyStandInAList) {
  EXPECT_EQ(found_in("void f(bool a);"), Found{"1 f a"});
  EXPECT_EQ(found_in("namespace a::b {\nint f(int a, const bool b, bool c) { return a; }\n}"),
            (Found{"2 f b", "2 f c"}));
  EXPECT_EQ(found_in("std::map<int, std::vector<bool>> f(bool, int);"), Found{"1 f "});
  EXPECT_EQ(found_in("template <class T, bool kFast = true>\nT f(T a, bool b);"), Found{"2 f b"});
  EXPECT_EQ(found_in("[[nodiscard]] constexpr auto f([[maybe_unused]] bool a) -> int;"), Found{"1 f a"});
}

TEST(BoolParameters, AreFoundOverSeveralLines) {
  EXPECT_EQ(found_in("\nint f(int a,\n      const std::string& b,\n      bool\n      c,\n      bool d);\n"),
            (Found{"4 f c", "6 f d"}));
}

TEST(BoolParameters, AreFoundWithDefaultArguments) {
  EXPECT_EQ(found_in("void f(int a = g(1, 2), bool b = true, Box c = {1, 2}, bool d = h(3, 4));"),
            (Found{"1 f b", "1 f d"}));
  EXPECT_EQ(found_in("void f(std::function<bool(int)> a = {}, bool b = {});"), Found{"1 f b"});
}

TEST(BoolParameters, OfClassesAreThoseThatMayBeCalled) {
  EXPECT_EQ(
      found_in("class A {\n  void f(bool a);\n public:\n  explicit A(bool b) : b_{b}, c_(1) {}\n"
               "  void g(bool c) const;\n protected:\n  void h(bool d);\n private:\n  void i(bool e);\n};\n"
               "void j(bool f);\n"),
      (Found{"4 A b", "5 g c", "11 j f"}));
  EXPECT_EQ(found_in("struct A final : public B {\n  void f(bool a);\n private:\n  void g(bool b);\n"
                     "  struct C {\n    void h(bool c);\n   public:\n    void i(bool d);\n  };\n};"),
            Found{"2 f a"});
  EXPECT_EQ(
      found_in("class A {\n public:\n  class B {\n    void f(bool a);\n   public:\n    void g(bool b);\n"
               "  };\n  void h(bool c);\n};"),
      (Found{"6 g b", "8 h c"}));
}

TEST(BoolParameters, OfCommentsLiteralsAndMacrosAreNone) {
  EXPECT_EQ(found_in("// void f(bool a);\n/* void g(bool b);\n */ void h(int /*bool c*/, bool d);\n"
                     "#define I(x) void i(bool e);\nconst char* text = \"void j(bool f);\";\n"),
            Found{"3 h d"});
}

TEST(BoolParameters, OfBodiesLambdasAndTypesOfFunctionsAreNone) {
  EXPECT_EQ(
      found_in("inline int f(int a) {\n  const auto g = [](bool b) { return b; };\n  return g(a > 0);\n}"),
      Found{});
  EXPECT_EQ(found_in("struct A {\n  std::function<void(bool)> f = [](bool a) { use(a); };\n"
                     "  void run(const std::function<void(bool, int)>& f, void (*g)(bool));\n};\n"
                     "using Fits = std::function<void(bool)>;\n"
                     "inline const auto h = [](bool a) { return a; };\n"),
            Found{});
  EXPECT_EQ(found_in("enum class A { kOne, kTwo };\nA f(int a);\nstd::vector<bool> g(std::vector<bool> a);"),
            Found{});
}

TEST(BoolParameters, ThatAreWrittenToOrAreTheValueAreNone) {
  EXPECT_EQ(found_in("void f(bool& a, const bool* b, bool c[2], std::optional<bool> d, boolean e);"),
            Found{});
  EXPECT_EQ(found_in("struct A {\n  void operator()(const std::string& key, bool value) const;\n"
                     "  A& operator=(bool value);\n  explicit operator bool() const;\n"
                     "  bool boolean(bool) override { return true; }\n};"),
            Found{});
}

TEST(BoolParameters, OfPublicFunctionsAreNone) {
  std::set<std::string> excused;
  int headers = 0;
  for (const std::string& path : repository_files()) {
    if (!is_product_source(path) || !path.ends_with(".h")) continue;
    ++headers;
    for (const BoolParameter& found : bool_parameters(read(path))) {
      const std::string function = path + " " + found.function;
      if (kExceptions.contains(function))
        excused.insert(function);
      else
        ADD_FAILURE() << path << ":" << found.line << ": " << found.function << "(… bool " << found.parameter
                      << " …): give its two values names, or make two functions of it";
    }
  }
  EXPECT_GT(headers, 300) << "there is less to read than there should be";
  EXPECT_EQ(excused.size(), kExceptions.size()) << "the list names a function that takes no bool";
}

}  // namespace
}  // namespace tramline::architecture
