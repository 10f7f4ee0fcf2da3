#include "tramline/coverage/mesh/connected_rings.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <unordered_map>
#include <utility>

namespace tramline::coverage {
namespace {

/// East, north, west and south, in this order.
struct Side {
  std::int32_t dx = 0;
  std::int32_t dy = 0;
  Corners left = kNoCorner;  ///< the corner on the left of who leaves by it
  Corners right = kNoCorner;
};
constexpr std::array<Side, 4> kSides{{{1, 0, kNorthEast, kSouthEast},
                                      {0, 1, kNorthWest, kNorthEast},
                                      {-1, 0, kSouthWest, kNorthWest},
                                      {0, -1, kSouthEast, kSouthWest}}};

bool leaves_by(Corners inside, std::size_t side) {
  return (inside & kSides[side].left) != 0 && (inside & kSides[side].right) == 0;
}

/// The way on for who arrives heading for that side: left, straight on, or right.
std::size_t way_on(Corners inside, std::size_t heading) {
  for (const std::size_t turn : {1U, 0U})
    if (leaves_by(inside, (heading + turn) % 4)) return (heading + turn) % 4;
  return (heading + 3) % 4;
}

/// Only there can a way pass through a mesh twice.
bool two_opposite(Corners inside) {
  return inside == (kNorthEast | kSouthWest) || inside == (kNorthWest | kSouthEast);
}

/// A closed way along a boundary.
struct Way {
  MeshRing meshes;
  bool may_repeat = false;
};

/// Where a walk is: a mesh of a row.
struct Place {
  int y = 0;
  std::size_t index = 0;
};

class MeshWalk {
 public:
  explicit MeshWalk(const MeshRegion& region) : region_(region) {
    for (int y = region.first_row(); y < region.end_row(); ++y)
      walked_.emplace_back(region.row(y).size(), std::uint8_t{0});
  }

  bool begins(Place place, std::size_t side) const {
    return leaves_by(mesh(place).inside, side) && (walked(place) >> side & 1U) == 0;
  }
  /// The closed way from there.
  Way from(Place place, std::size_t side) {
    Way out;
    while ((walked(place) >> side & 1U) == 0) {
      walked(place) = static_cast<std::uint8_t>(walked(place) | 1U << side);
      out.meshes.push_back({mesh(place).x, place.y});
      out.may_repeat = out.may_repeat || two_opposite(mesh(place).inside);
      place = neighbour(place, side);
      side = way_on(mesh(place).inside, side);
    }
    return out;
  }

 private:
  const BoundaryMesh& mesh(Place place) const { return region_.row(place.y)[place.index]; }
  std::uint8_t& walked(Place place) {
    return walked_[static_cast<std::size_t>(place.y - region_.first_row())][place.index];
  }
  std::uint8_t walked(Place place) const {
    return walked_[static_cast<std::size_t>(place.y - region_.first_row())][place.index];
  }
  Place neighbour(Place place, std::size_t side) const {
    if (kSides[side].dx > 0) return {place.y, place.index + 1};
    if (kSides[side].dx < 0) return {place.y, place.index - 1};
    const int y = place.y + kSides[side].dy;
    return {y, lower_mesh(region_.row(y), mesh(place).x)};
  }

  const MeshRegion& region_;
  std::vector<std::vector<std::uint8_t>> walked_;  ///< sides by which a mesh was left, as bits
};

struct MeshHash {
  std::size_t operator()(Mesh mesh) const {
    const auto x = static_cast<std::uint32_t>(mesh.x), y = static_cast<std::uint32_t>(mesh.y);
    return (std::uint64_t{y} << 32U | x) * 0x9E3779B97F4A7C15ULL;
  }
};

/// Cuts a way that passes through meshes twice into rings that do not.
void append_simple(Way way, std::vector<MeshRing>& out) {
  if (!way.may_repeat) {
    out.push_back(std::move(way.meshes));
    return;
  }
  std::unordered_map<Mesh, std::size_t, MeshHash> places;
  MeshRing rest;
  for (const Mesh mesh : way.meshes) {
    if (const auto found = places.find(mesh); found != places.end()) {
      const auto begin = rest.begin() + static_cast<std::ptrdiff_t>(found->second);
      out.emplace_back(begin, rest.end());
      for (auto cut = begin + 1; cut != rest.end(); ++cut) places.erase(*cut);
      rest.erase(begin + 1, rest.end());
    } else {
      places.emplace(mesh, rest.size());
      rest.push_back(mesh);
    }
  }
  out.push_back(std::move(rest));
}

/// Without the meshes on a straight line with their neighbours, as centres.
Ring corners_only(const MeshRing& meshes, double mesh_m) {
  Ring out;
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    const Mesh from = meshes[i > 0 ? i - 1 : meshes.size() - 1];
    const Mesh to = meshes[i + 1 < meshes.size() ? i + 1 : 0];
    if (std::abs(to.x - from.x) == 1) out.push_back(centre(meshes[i], mesh_m));
  }
  return out;
}

/// A corner of the grid just inside the region: left of the way from the ring's first mesh to its second.
Point corner_inside(const MeshRing& ring, double mesh_m) {
  const int dx = ring[1].x - ring[0].x, dy = ring[1].y - ring[0].y;
  const Point middle = midpoint(centre(ring[0], mesh_m), centre(ring[1], mesh_m));
  return middle + 0.5 * mesh_m * Point{static_cast<double>(-dy), static_cast<double>(dx)};
}

}  // namespace

std::vector<MeshRing> connected_rings(const MeshRegion& region) {
  std::vector<MeshRing> out;
  MeshWalk walk(region);
  for (int y = region.first_row(); y < region.end_row(); ++y)
    for (std::size_t i = 0; i < region.row(y).size(); ++i)
      for (std::size_t side = 0; side < kSides.size(); ++side)
        if (walk.begins({y, i}, side)) append_simple(walk.from({y, i}, side), out);
  return out;
}

Region region_of(const MeshRegion& region, double mesh_m) {
  struct Hole {
    Ring ring;
    Point inside;
  };
  Region out;
  std::vector<Hole> holes;
  std::vector<Box> boxes;
  std::vector<double> areas;
  for (const MeshRing& meshes : connected_rings(region)) {
    Ring ring = corners_only(meshes, mesh_m);
    if (const double area_m2 = signed_area(ring); area_m2 > 0) {
      boxes.push_back(bounds(ring));
      areas.push_back(area_m2);
      out.push_back({std::move(ring), {}});
    } else {
      holes.push_back({std::move(ring), corner_inside(meshes, mesh_m)});
    }
  }
  for (Hole& hole : holes) {
    std::size_t owner = out.size();
    for (std::size_t i = 0; i < out.size(); ++i) {
      const Box& box = boxes[i];
      const Point p = hole.inside;
      const bool near = p.x > box.min_x && p.x < box.max_x && p.y > box.min_y && p.y < box.max_y;
      if (near && (owner == out.size() || areas[i] < areas[owner]) && contains(out[i].outer, p)) owner = i;
    }
    out[owner].holes.push_back(std::move(hole.ring));
  }
  return out;
}

}  // namespace tramline::coverage
