// Modules of the page import one another in one direction, types included.

#include <gtest/gtest.h>

#include <filesystem>
#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

#include "architecture/source_tree.h"

namespace tramline::architecture::web_imports_test {

using Names = std::set<std::string>;

bool is_module(const std::string& path) { return path.ends_with(".ts") || path.ends_with(".tsx"); }

/// The modules of the page that `from "./other"` and `import("./other")` name, as paths from the root.
Names imported_by(const std::string& path, const std::string& text, const Names& modules) {
  static const std::regex pattern(R"re((?:from|import)\s*\(?\s*["'](\.[^"']*)["'])re");
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  Names out;
  for (std::sregex_iterator found(text.begin(), text.end(), pattern), end; found != end; ++found) {
    const std::string target = (folder / std::string((*found)[1])).lexically_normal().string();
    for (const char* ending : {"", ".ts", ".tsx", "/index.ts", "/index.tsx"})
      if (modules.count(target + ending) > 0) out.insert(target + ending);
  }
  return out;
}

TEST(WebImports, AreFoundInEveryForm) {
  const Names modules{"web/src/a.ts", "web/src/b/c.tsx", "web/src/d.ts"};
  EXPECT_EQ(
      imported_by("web/src/b/c.tsx",
                  "import { x } from '../a';\nimport type { Y } from \"../d\";\nimport h from 'preact';\n",
                  modules),
      (Names{"web/src/a.ts", "web/src/d.ts"}));
  EXPECT_EQ(imported_by("web/src/a.ts", "const later = () => import('./b/c');", modules),
            Names{"web/src/b/c.tsx"});
}

TEST(WebImports, MakeNoCircle) {
  Names modules;
  for (const std::string& path : repository_files())
    if (path.starts_with("web/src/") && is_module(path)) modules.insert(path);
  ASSERT_GT(modules.size(), 50U) << "the modules of the page were not found";
  std::map<std::string, Names> imports;
  std::size_t count = 0;
  for (const std::string& path : modules) {
    imports[path] = imported_by(path, read(path), modules);
    count += imports[path].size();
  }
  EXPECT_GT(count, modules.size()) << "there are fewer imports than there should be";
  Names done, open;
  const std::function<void(const std::string&)> visit = [&](const std::string& path) {
    if (!done.insert(path).second) return;
    open.insert(path);
    for (const std::string& next : imports[path]) {
      EXPECT_EQ(open.count(next), 0U) << path << " and " << next << " import each other";
      visit(next);
    }
    open.erase(path);
  };
  for (const std::string& path : modules) visit(path);
}

}  // namespace tramline::architecture::web_imports_test
