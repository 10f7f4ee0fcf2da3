#include "keywords_in.h"

#include <algorithm>
#include <cctype>
#include <cstddef>

namespace tramline::python {
namespace {

bool is_letter(char c) { return std::islower(static_cast<unsigned char>(c)) != 0; }

/// Whether an option begins here, rather than a dash within a word.
bool begins_option(const std::string& text, std::size_t at) {
  if (text.compare(at, 2, "--") != 0 || at + 2 >= text.size() || !is_letter(text[at + 2])) return false;
  return at == 0 || std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
}

}  // namespace

std::string with_keywords(const std::string& message) {
  std::string out;
  for (std::size_t at = 0; at < message.size();) {
    if (!begins_option(message, at)) {
      out += message[at++];
      continue;
    }
    std::size_t end = at + 2;
    while (end < message.size() && (is_letter(message[end]) || message[end] == '-')) ++end;
    std::string name = message.substr(at + 2, end - at - 2);
    std::replace(name.begin(), name.end(), '-', '_');
    out += name == "for" ? "for_" : name;  // a word of Python itself
    at = end;
  }
  return out;
}

}  // namespace tramline::python
