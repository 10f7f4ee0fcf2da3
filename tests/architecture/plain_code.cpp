#include "architecture/plain_code.h"

#include <algorithm>
#include <regex>

namespace tramline::architecture {

std::string plain_code(const std::string& source) {
  static const std::regex noise(
      R"re(//[^\n]*|/\*[^*]*\*+(?:[^/*][^*]*\*+)*/|"(?:[^"\\\n]|\\.)*"|'(?:[^'\\\n]|\\.)*'|(?:^|\n)[ \t]*#[^\n]*)re");
  std::string out;
  auto rest = source.begin();
  for (std::sregex_iterator match(source.begin(), source.end(), noise), end; match != end; ++match) {
    out.append(rest, (*match)[0].first);
    const auto lines = static_cast<std::size_t>(std::count((*match)[0].first, (*match)[0].second, '\n'));
    // What stood left and right of a comment are two words.
    out += lines > 0 ? std::string(lines, '\n') : " ";
    rest = (*match)[0].second;
  }
  return out.append(rest, source.end());
}

}  // namespace tramline::architecture
