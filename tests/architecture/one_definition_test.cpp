// One name, one type: two types of one qualified name in one program are undefined behaviour, even where no
// source file sees both.

#include <gtest/gtest.h>

#include <map>
#include <string>
#include <vector>

#include "architecture/defined_types.h"
#include "architecture/source_tree.h"

namespace tramline::architecture::one_definition_test {

using Names = std::vector<std::string>;

TEST(DefinedTypes, AreThoseOfNamespaces) {
  EXPECT_EQ(defined_types("namespace a {\nnamespace b::c {\nstruct Point {\n  double x;\n};\n}\n"
                          "enum class Kind : int { kOne };\n}  // namespace a\n"),
            (Names{"a::b::c::Point", "a::Kind"}));
  EXPECT_EQ(defined_types(
                "namespace a { template <class T>\nclass Box final : public Base<T> { struct In {}; }; }"),
            Names{"a::Box"});
  EXPECT_EQ(
      defined_types("namespace a { struct Later; inline int f() { struct Local { int x; }; return 1; } }"),
      Names{});
  EXPECT_EQ(
      defined_types(
          "namespace a {\n// struct No {\nconst char* text = \"struct Nor {\";\n#define X struct Y {\n}"),
      Names{});
}

TEST(OneDefinition, NoTwoHeadersDefineOneQualifiedName) {
  std::map<std::string, Names> files;
  for (const std::string& path : repository_files()) {
    if (is_product_source(path) && path.ends_with(".h"))
      for (const std::string& name : defined_types(read(path))) files[name].push_back(path);
  }
  EXPECT_GT(files.size(), 300U) << "there is less to read than there should be";
  for (const auto& [name, paths] : files)
    if (paths.size() > 1) ADD_FAILURE() << name << " is defined in " << paths[0] << " and in " << paths[1];
}

}  // namespace tramline::architecture::one_definition_test
