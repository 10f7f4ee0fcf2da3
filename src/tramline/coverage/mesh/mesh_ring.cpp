#include "tramline/coverage/mesh/mesh_ring.h"

namespace tramline::coverage {
namespace {

MeshRing traced(const Ring& ring, double mesh_m) {
  MeshRing out;
  FinePoint from = fine_point(ring.front(), mesh_m);
  for (std::size_t i = 1; i <= ring.size(); ++i) {
    const FinePoint to = fine_point(ring[i < ring.size() ? i : 0], mesh_m);
    append_mesh_line(from, to, out);
    from = to;
  }
  return out;
}

/// Without sequences A B A, whichever way they nest.
MeshRing without_excursions(const MeshRing& meshes) {
  MeshRing out;
  for (const Mesh mesh : meshes) {
    if (!out.empty() && out.back() == mesh) continue;
    if (out.size() > 1 && out[out.size() - 2] == mesh)
      out.pop_back();
    else
      out.push_back(mesh);
  }
  std::size_t begin = 0;  // the same across the seam
  while (out.size() - begin > 2) {
    if (out.back() == out[begin] || out[out.size() - 2] == out[begin])
      out.pop_back();
    else if (out.back() == out[begin + 1])
      ++begin;
    else
      break;
  }
  out.erase(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(begin));
  return out.size() > 2 ? out : MeshRing{};
}

}  // namespace

MeshRing mesh_ring(const Ring& ring, double mesh_m) {
  return ring.size() < 3 ? MeshRing{} : without_excursions(traced(ring, mesh_m));
}

}  // namespace tramline::coverage
