#include "tramline/check/self_crossing.h"

#include <cstddef>
#include <vector>

#include "tramline/check/tolerances.h"
#include "tramline/geometry/box_grid.h"
#include "tramline/geometry/line_crossing.h"

namespace tramline::check {
namespace {

/// Does the line from p to q begin and end on different sides of the line through a and b, a millimetre off?
bool parts(Point a, Point b, Point p, Point q) {
  const double least = kLengthTolerance_m * distance(a, b);
  const double at_p = cross(b - a, p - a), at_q = cross(b - a, q - a);
  return (at_p < -least && at_q > least) || (at_p > least && at_q < -least);
}

/// A closed line of chords: vertices by their number, the first one again after the last one.
class Chords {
 public:
  explicit Chords(const Path& closed) : vertices_(chords(closed, kRoundEdge_m)) { vertices_.pop_back(); }

  std::size_t size() const { return vertices_.size(); }
  Point operator[](std::size_t i) const { return vertices_[i % size()]; }

  std::vector<Box> boxes() const {
    std::vector<Box> out(size());
    for (std::size_t i = 0; i < size(); ++i) {
      out[i].extend((*this)[i]);
      out[i].extend((*this)[i + 1]);
    }
    return out;
  }

  bool are_neighbours(std::size_t i, std::size_t j) const {
    return i == j || (i + 1) % size() == j || (j + 1) % size() == i;
  }

  /// Two edges that meet belong to parts that cross if each part, an edge farther on either way, goes from
  /// one side of the other's edge to the other: so a crossing beside a vertex is found, too.
  std::optional<Point> crossing(std::size_t i, std::size_t j) const {
    const Chords& v = *this;
    const auto along = crossing_along(v[i], v[i + 1], v[j], v[j + 1]);
    if (!along || !parts(v[i], v[i + 1], v[j + size() - 1], v[j + 2]) ||
        !parts(v[j], v[j + 1], v[i + size() - 1], v[i + 2]))
      return std::nullopt;
    return v[i] + *along * (v[i + 1] - v[i]);
  }

 private:
  std::vector<Point> vertices_;
};

}  // namespace

std::optional<Point> self_crossing_of(const Path& closed) {
  const Chords line(closed);
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
