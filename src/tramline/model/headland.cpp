#include "tramline/model/headland.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/path/kinked_line.h"

namespace tramline {
namespace {

/// Both sides of the band of a path that begins and ends on one of its edges.
Polygon closed_kinked_band(const Path& path, double width_m) {
  const Ring sides = kinked_band(path, width_m);
  const auto half = static_cast<std::ptrdiff_t>(sides.size() / 2);
  // Each side begins where it ends.
  Ring outer(sides.begin() + 1, sides.begin() + half), inner(sides.begin() + half + 1, sides.end());
  if (std::abs(signed_area(inner)) > std::abs(signed_area(outer))) std::swap(outer, inner);
  return oriented({std::move(outer), {std::move(inner)}});
}

}  // namespace

bool is_closed(const HeadlandPass& pass) {
  constexpr double kJoint_m = 1e-6;
  return distance(pass.path.back().to, pass.path.front().from) < kJoint_m;
}

bool along_one_boundary(const HeadlandPass& a, const HeadlandPass& b) {
  return (a.around_field && b.around_field) ||
         std::find_first_of(a.obstacles.begin(), a.obstacles.end(), b.obstacles.begin(), b.obstacles.end()) !=
             a.obstacles.end();
}

const char* name(HeadlandConstruction how) {
  return how == HeadlandConstruction::kPlain ? "plain" : "drivable";
}

std::optional<HeadlandConstruction> headland_construction_named(std::string_view word) {
  for (const HeadlandConstruction how : {HeadlandConstruction::kDrivable, HeadlandConstruction::kPlain})
    if (word == name(how)) return how;
  return std::nullopt;
}

Polygon swath(const HeadlandPass& pass, double width_m, double sagitta_m) {
  if (is_closed(pass) && has_kinks(pass.path)) return closed_kinked_band(pass.path, width_m);
  if (is_closed(pass)) return closed_band(pass.path, width_m, sagitta_m);
  return {band(pass.path, width_m, sagitta_m), {}};
}

int passes_everywhere(const std::vector<int>& edge_passes) {
  return edge_passes.empty() ? 0 : *std::min_element(edge_passes.begin(), edge_passes.end());
}

int passes_anywhere(const std::vector<int>& edge_passes) {
  return edge_passes.empty() ? 0 : *std::max_element(edge_passes.begin(), edge_passes.end());
}

double length(const Headland& headland) {
  double sum = 0;
  for (const HeadlandPass& pass : headland.passes) sum += length(pass.path);
  return sum;
}

}  // namespace tramline
