#include "tramline/io/plan/path_text.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <cmath>
#include <iterator>

#include "tramline/geometry/error.h"
#include "tramline/model/plain_zero.h"

namespace tramline::io {
namespace {

/// What rounding may make of the chord of an exact half circle: a share, and the last digits of
/// coordinates in national grids, m.
constexpr double kShare = 1e-9, kDigits_m = 4e-9;

bool longer_than_half_a_circle(const PathSegment& segment) {
  const double chord = distance(segment.from, segment.to), curvature = std::abs(segment.curvature);
  // Written so that what is not finite is too long.
  return !(chord * curvature <= 2 * (1 + kShare) + kDigits_m * curvature);
}

class Cursor {
 public:
  /// `parts` for messages: what the text should be a list of.
  Cursor(const std::string& text, const std::string& place, const char* parts)
      : text_(text), place_(place), parts_(parts) {}

  bool at_end() const { return at_ == text_.size(); }

  /// Numbers are parted by one space, points by "; ".
  void skip(char expected) {
    if (at_end() || text_[at_] != expected) throw other_form();
    ++at_;
  }

  double number() {
    double value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) throw other_form();
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }

  Point point() {
    const double x = number();
    skip(' ');
    return {x, number()};
  }

 private:
  Error other_form() const {
    return bad_input(fmt::format("{} is not a list of {} from character {} on; write the plan again", place_,
                                 parts_, at_ + 1));
  }
  const std::string& text_;
  const std::string& place_;
  const char* parts_;
  std::size_t at_ = 0;
};

std::string written(Point p, Point offset) {
  return fmt::format("{} {}", plain_zero(p.x + offset.x), plain_zero(p.y + offset.y));
}

}  // namespace

std::string path_text(const Path& path, Point offset) {
  assert(!path.empty());
  std::string out = written(path.front().from, offset);
  for (const PathSegment& segment : path)
    fmt::format_to(std::back_inserter(out), "; {} {}", written(segment.to, offset),
                   plain_zero(segment.curvature));
  return out;
}

Path path_from_text(const std::string& text, Point offset, const std::string& place) {
  Cursor cursor(text, place, "points and curvatures");
  Path out;
  Point at = cursor.point() - offset;
  do {
    cursor.skip(';');
    cursor.skip(' ');
    const Point to = cursor.point() - offset;
    cursor.skip(' ');
    out.push_back({at, to, cursor.number()});
    if (longer_than_half_a_circle(out.back()))
      throw bad_input(fmt::format("{} has an arc longer than half a circle, segment {}; write the plan again",
                                  place, out.size() - 1));
    at = to;
  } while (!cursor.at_end());
  return out;
}

std::string path_text_if_any(const Path& path, Point offset) {
  return path.empty() ? std::string() : path_text(path, offset);
}

Path path_from_text_if_any(const std::string& text, Point offset, const std::string& place) {
  return text.empty() ? Path() : path_from_text(text, offset, place);
}

std::string points_text(const std::vector<Point>& points, Point offset) {
  std::string out;
  for (const Point p : points) out += (out.empty() ? "" : "; ") + written(p, offset);
  return out;
}

std::vector<Point> points_from_text(const std::string& text, Point offset, const std::string& place) {
  std::vector<Point> out;
  if (text.empty()) return out;
  Cursor cursor(text, place, "points");
  out.push_back(cursor.point() - offset);
  while (!cursor.at_end()) {
    cursor.skip(';');
    cursor.skip(' ');
    out.push_back(cursor.point() - offset);
  }
  return out;
}

}  // namespace tramline::io
