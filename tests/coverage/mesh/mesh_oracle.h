#pragma once
// What a region is on a grid, corner by corner: the slow way, for comparison with meshes.

#include <functional>
#include <map>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tramline/coverage/mesh/mesh_region.h"

namespace tramline::coverage::testing_meshes {

/// Corners of the grid from `low` to `high` on both axes, and whether they are inside.
class CornerSet {
 public:
  CornerSet(int low, int high) : low_(low), size_(high - low + 1), inside_(size() * size()) {}

  int low() const { return low_; }
  int high() const { return low_ + size_ - 1; }
  bool at(int x, int y) const { return inside_[index(x, y)] != 0; }
  void set(int x, int y, bool inside) { inside_[index(x, y)] = inside ? 1 : 0; }
  std::int64_t count() const;

  friend bool operator==(const CornerSet& a, const CornerSet& b) = default;

 private:
  std::size_t size() const { return static_cast<std::size_t>(size_); }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y - low_) * size() + static_cast<std::size_t>(x - low_);
  }
  int low_, size_;
  std::vector<char> inside_;
};

/// Corners that rings in meshes wind round other than 0 times. A corner on an edge counts as the place just
/// below it, and a still much smaller bit to the left: what Zhang's floor makes of it.
CornerSet corners_of(const std::vector<Ring>& rings, int low, int high);

CornerSet together(const CornerSet& a, const CornerSet& b, const std::function<bool(bool, bool)>& operation);

/// Where a region of meshes and a set of corners differ: the first such mesh, in words; empty: nowhere.
std::string difference(const MeshRegion& region, const CornerSet& expected);

/// A ring round `middle` whose corners are at random angles and distances up to `most`; concave as a rule.
/// Coordinates are multiples of `step`.
Ring random_star(std::mt19937_64& random, Point middle, double least, double most, double step);

/// A star with up to three holes, which may touch it or one another, oriented.
std::vector<Ring> random_rings(std::mt19937_64& random, double most, double step);

}  // namespace tramline::coverage::testing_meshes
