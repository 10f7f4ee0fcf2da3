#pragma once
// Splits a stream of bytes into lines.

#include <string>
#include <string_view>
#include <vector>

namespace tramline::io {

/// Keeps the beginning of a line until its end arrives. A line longer than kLongestLine is dropped: it is not
/// text of a log.
class LineSplitter {
 public:
  /// Appends the lines that the bytes complete, without their ends; a carriage return stays.
  void add(std::string_view bytes, std::vector<std::string>& lines);
  /// Returns and removes the line whose end has not arrived.
  std::string take_rest();
  bool has_rest() const { return !rest_.empty(); }

 private:
  std::string rest_;
  bool too_long_ = false;
};

}  // namespace tramline::io
