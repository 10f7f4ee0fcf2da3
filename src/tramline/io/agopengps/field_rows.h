#pragma once
// The text files of an AgOpenGPS field folder, line by line.

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "tramline/geometry/point.h"

namespace tramline::io {

/// Lines of one file, without blanks around them. Errors name the file and the line.
class FieldRows {
 public:
  /// Fields do not reach so far from where they were started, m.
  static constexpr double kFarthest_m = 100000;

  /// `path`: of the file. Throws bad_input where it cannot be opened.
  explicit FieldRows(const std::string& path);

  /// Whether all lines have been taken; empty lines at the end do not count.
  bool at_end() const { return next_ >= lines_.size(); }
  /// The next line. Throws bad_input where there is none.
  std::string text();
  /// The next line, without taking it; empty at the end.
  std::string_view ahead() const;
  /// So many numbers in the next line, between commas. Decimal points may be commas, as AgOpenGPS once wrote
  /// them: "40,7,-74,0" is two numbers. Throws bad_input for anything else.
  std::vector<double> numbers(std::size_t count);
  /// A count of lines to come. Throws bad_input where it is no whole number or more than there are.
  std::size_t count();
  /// Easting and northing; a heading that follows is not used. Throws bad_input where it is no place, or one
  /// farther than kFarthest_m from the start.
  Point place();
  std::vector<Point> places(std::size_t count);

  /// Throws bad_input with what is wrong with the line taken last.
  [[noreturn]] void refuse(const std::string& what) const;

 private:
  std::string path_;
  std::vector<std::string> lines_;
  std::size_t next_ = 0;
};

}  // namespace tramline::io
