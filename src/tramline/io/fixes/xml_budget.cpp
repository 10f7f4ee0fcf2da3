#include "tramline/io/fixes/xml_budget.h"

#include <fmt/format.h>

#include "tramline/geometry/error.h"

namespace tramline::io {
namespace {

/// What pugixml has for a node and for an attribute on a 64-bit machine; texts stay where they are.
constexpr std::size_t kNode = 64, kAttribute = 40;

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

}  // namespace

std::size_t xml_tree_bytes(std::string_view xml) {
  std::size_t nodes = 0, attributes = 0;
  bool text = false;  // since the last mark
  for (std::size_t i = 0; i < xml.size(); ++i) {
    const char c = xml[i];
    if (c == '<') {
      const bool closes = i + 1 < xml.size() && xml[i + 1] == '/';
      nodes += (closes ? 0U : 1U) + (text ? 1U : 0U);
      text = false;
    } else if (c == '>') {
      text = false;
    } else if (c == '=') {
      ++attributes;
      text = true;
    } else if (!is_blank(c)) {
      // Within a tag this is its name, which '>' ends.
      text = true;
    }
  }
  return xml.size() + nodes * kNode + attributes * kAttribute;
}

void require_bounded_xml(std::string_view xml, const std::string& place, std::size_t most) {
  if (xml_tree_bytes(xml) <= most) return;
  throw bad_input(
      fmt::format("{} has so many elements that reading it takes more than {} MiB of memory; split it", place,
                  most >> 20));
}

}  // namespace tramline::io
