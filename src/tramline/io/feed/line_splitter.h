#pragma once
// From bytes as they come to lines.

#include <string>
#include <string_view>
#include <vector>

namespace tramline::io {

/// Keeps the beginning of a line until its end comes. A line longer than kLongestLine is left out: it is no
/// text of a log.
class LineSplitter {
 public:
  /// Appends the lines that the bytes complete, without their ends; a carriage return stays.
  void add(std::string_view bytes, std::vector<std::string>& lines);
  /// The line whose end did not come; it is gone then.
  std::string take_rest();
  bool has_rest() const { return !rest_.empty(); }

 private:
  std::string rest_;
  bool too_long_ = false;
};

}  // namespace tramline::io
