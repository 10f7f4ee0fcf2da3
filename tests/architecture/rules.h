#pragma once
// Which room of the house may use what. Pure functions over text, so that the rules themselves are
// tested with made-up files.

#include <string>
#include <string_view>
#include <vector>

namespace tramline::architecture {

/// One line that breaks a rule.
struct Violation {
  std::string file;
  int line = 0;
  std::string subject;  ///< the header or library at fault
  std::string why;
};

std::string describe(const Violation& violation);

/// All rooms under src/tramline, floors bottom up, then the rooms beside the tower.
std::vector<std::string> rooms();

/// May room `from` use room `to`? Every room may use itself; `apps` and `python` may use every room.
bool may_use(std::string_view from, std::string_view to);

/// Checks the #include lines of one file. `path` is relative to the root of the repository and
/// lies under src/tramline/, include/tramline/, apps/ or python/.
std::vector<Violation> check_includes(const std::string& path, const std::string& text);

/// Checks the libraries that a room's CMakeLists.txt hands to tramline_module().
std::vector<Violation> check_links(const std::string& path, const std::string& text);

}  // namespace tramline::architecture
