#include "tramline/check/measure/self_crossing.h"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "tramline/check/measure/sound_path.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/index/box_grid.h"
#include "tramline/geometry/path/line_crossing.h"

namespace tramline::check {
namespace {

/// Whether the line from p to q begins and ends on different sides of the line through a and b, at least a
/// millimetre off.
bool parts(Point a, Point b, Point p, Point q) {
  const double least = kLengthTolerance_m * distance(a, b);
  const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
  return (at_p < -least && at_q > least) || (at_p > least && at_q < -least);
}

/// A line of chords: vertices by their number. Of one that ends where it begins the first one comes again
/// after the last one.
class Chords {
 public:
  explicit Chords(const Path& path)
      : vertices_(chords(path, kRoundEdge_m)),
        closed_(distance(vertices_.front(), vertices_.back()) <= kJoint_m) {
    if (closed_) vertices_.pop_back();
  }

  std::size_t size() const { return closed_ ? vertices_.size() : vertices_.size() - 1; }
  Point operator[](std::size_t i) const { return vertices_[closed_ ? i % size() : i]; }

  std::vector<Box> boxes() const {
    std::vector<Box> out(size());
    for (std::size_t i = 0; i < size(); ++i) {
      out[i].extend((*this)[i]);
      out[i].extend((*this)[i + 1]);
    }
    return out;
  }

  bool are_neighbours(std::size_t i, std::size_t j) const {
    if (!closed_) return i == j || i + 1 == j || j + 1 == i;
    return i == j || (i + 1) % size() == j || (j + 1) % size() == i;
  }

  /// Two edges that meet belong to parts that cross if each part, an edge farther on either way, goes from
  /// one side of the other's edge to the other: so a crossing beside a vertex is found, too.
  std::optional<Point> crossing(std::size_t i, std::size_t j) const {
    const Chords& v = *this;
    const auto along = crossing_along(v[i], v[i + 1], v[j], v[j + 1]);
    if (!along || !parts(v[i], v[i + 1], before(j), behind(j)) ||
        !parts(v[j], v[j + 1], before(i), behind(i)))
      return std::nullopt;
    return v[i] + *along * (v[i + 1] - v[i]);
  }

 private:
  /// The vertices next to an edge, or its own ends where the line has none there.
  Point before(std::size_t i) const {
    return closed_ ? (*this)[i + size() - 1] : vertices_[i > 0 ? i - 1 : 0];
  }
  Point behind(std::size_t i) const {
    return closed_ ? (*this)[i + 2] : vertices_[std::min(i + 2, vertices_.size() - 1)];
  }

  std::vector<Point> vertices_;
  bool closed_;
};

}  // namespace

std::optional<Point> self_crossing_of(const Path& path) {
  assert(fault_of(path).empty());
  const Chords line(path);
  const std::vector<Box> boxes = line.boxes();
  const BoxGrid grid(boxes);
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::optional<Point> found;
    grid.each_meeting(boxes[i], [&](std::size_t j) {
      if (!found && j > i && !line.are_neighbours(i, j)) found = line.crossing(i, j);
    });
    if (found) return found;
  }
  return std::nullopt;
}

}  // namespace tramline::check
