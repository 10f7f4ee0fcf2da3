#pragma once
// Headlands of fields drawn by hand, with everything that has to hold for any.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

#include "headland/headland_faults.h"
#include "support/box_ring.h"
#include "tramline/headland/headland.h"

namespace tramline::testing {

inline constexpr double kPi = std::numbers::pi;
inline constexpr double kLength = 1e-5;  // m: passes come 1e-7 m nearer to boundaries than they should
inline constexpr double kArea = 2e-3;    // m²
inline constexpr double kChords = 0.03;  // m²: chords of the body

using testing_support::box;

inline Field field_of(Ring outer, const std::vector<Ring>& obstacles = {}) {
  Field field;
  field.outer = std::move(outer);
  for (const Ring& ring : obstacles) field.obstacles.push_back({{ring, {}}, ObstacleKind::kObstacle, "hole"});
  return field;
}

inline Ring polygon(int corners, double radius, Point centre) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back(centre + radius * Point{std::cos(2 * kPi * i / corners), std::sin(2 * kPi * i / corners)});
  return ring;
}

/// With everything that has to hold for any headland.
inline HeadlandAndBody made(const Field& field, const HeadlandTerms& terms) {
  HeadlandAndBody headland = headland_of(field, terms);
  for (const std::string& fault : faults_of(field, terms, headland)) ADD_FAILURE() << fault;
  return headland;
}

inline double distance_to_path(Point p, const Path& path) {
  double out = std::numeric_limits<double>::infinity();
  for (const PathSegment& segment : path) out = std::min(out, distance_to_edge(segment, p, p));
  return out;
}

inline std::vector<HeadlandPass> open_ones(const HeadlandAndBody& headland) {
  std::vector<HeadlandPass> out;
  for (const HeadlandPass& pass : headland.passes)
    if (!is_closed(pass)) out.push_back(pass);
  return out;
}

}  // namespace tramline::testing
