#include "architecture/defined_types.h"

#include <algorithm>
#include <regex>

#include "architecture/plain_code.h"

namespace tramline::architecture {
namespace {

/// "a::b" of what is written before the brace of a namespace.
std::string namespace_name(const std::string& head) {
  std::smatch match;
  if (!std::regex_search(head, match, std::regex(R"(\bnamespace\s+([A-Za-z_][\w:]*)\s*$)"))) return "";
  return match[1];
}

std::string type_name(const std::string& head) {
  std::smatch match;
  static const std::regex type(
      R"(^\s*(?:template\s*<[^{}]*>\s*)?(?:enum\s+class|enum\s+struct|enum|struct|class|union)\s+([A-Za-z_]\w*)\s*(?:final\s*)?(?::[^{}]*)?$)");
  return std::regex_search(head, match, type) ? match[1].str() : "";
}

}  // namespace

std::vector<std::string> defined_types(const std::string& source) {
  const std::string code = plain_code(source);
  std::vector<std::string> out, namespaces;
  std::vector<bool> is_namespace;  // of each open block
  std::string head;
  for (const char c : code) {
    if (c != '{' && c != '}' && c != ';') {
      head += c;
      continue;
    }
    if (c == '{') {
      const bool outside = std::find(is_namespace.begin(), is_namespace.end(), false) == is_namespace.end();
      const std::string space = namespace_name(head);
      if (const std::string type = type_name(head); outside && !type.empty()) {
        std::string name;
        for (const std::string& part : namespaces) name += part + "::";
        out.push_back(name + type);
      }
      is_namespace.push_back(!space.empty());
      if (!space.empty()) namespaces.push_back(space);
    } else if (c == '}' && !is_namespace.empty()) {
      if (is_namespace.back()) namespaces.pop_back();
      is_namespace.pop_back();
    }
    head.clear();
  }
  return out;
}

}  // namespace tramline::architecture
