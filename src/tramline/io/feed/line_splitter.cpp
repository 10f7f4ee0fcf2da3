#include "tramline/io/feed/line_splitter.h"

#include <utility>

#include "tramline/io/fixes/lines.h"

namespace tramline::io {

void LineSplitter::add(std::string_view bytes, std::vector<std::string>& lines) {
  while (!bytes.empty()) {
    const std::size_t end = bytes.find('\n');
    if (!too_long_) rest_ += bytes.substr(0, end);
    if (rest_.size() > kLongestLine) {
      too_long_ = true;
      rest_.clear();
    }
    if (end == std::string_view::npos) return;
    bytes.remove_prefix(end + 1);
    if (!too_long_) lines.push_back(std::exchange(rest_, {}));
    too_long_ = false;
  }
}

std::string LineSplitter::take_rest() {
  too_long_ = false;
  return std::exchange(rest_, {});
}

}  // namespace tramline::io
