#include "route/scenes.h"

#include <algorithm>
#include <cmath>

#include "properties/draws.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline::testing {
namespace {

using order::End;

constexpr double kSpeed_m_s = 2;

void add_line(LeavingPoses& leaving, Point start, Point end) {
  leaving.push_back({start, Heading::from_to(end, start)});
  leaving.push_back({end, Heading::from_to(start, end)});
}

}  // namespace

order::Neighbours TableCosts::neighbours(std::size_t count) const {
  const auto cost = [this](std::size_t a, std::size_t b) { return between(a, b); };
  return order::neighbours_of(2 * lines(), cost, cost, {count, count});
}

TableCosts random_costs(std::size_t lines, std::mt19937_64& random) {
  TableCosts out(lines);
  for (End a = 0; a < 2 * lines; ++a)
    for (End b = 0; b < a; ++b) out.set(a, b, uniform(random, 1, 10));
  return out;
}

void add_gates(std::size_t gates, TableCosts& costs, std::mt19937_64& random) {
  std::vector<double> starting, finishing;
  for (End end = 0; end < 2 * costs.lines(); ++end) {
    if (gates > 0) starting.push_back(uniform(random, 1, 10));
    if (gates > 1) finishing.push_back(uniform(random, 1, 10));
  }
  costs.set_gates(std::move(starting), std::move(finishing));
}

void add_rings(std::size_t rings, TableCosts& costs, std::mt19937_64& random) {
  for (std::size_t i = 0; i < rings; ++i) {
    std::vector<double> to_nodes;
    for (std::size_t node = 0; node < costs.nodes(); ++node) to_nodes.push_back(uniform(random, 1, 10));
    costs.add_ring(std::move(to_nodes));
  }
}

LeavingPoses rectangle(std::size_t tracks, double width_m, double length_m) {
  LeavingPoses out;
  for (std::size_t i = 0; i < tracks; ++i) {
    const double x = width_m * static_cast<double>(i);
    add_line(out, {x, 0}, {x, length_m});
  }
  return out;
}

LeavingPoses random_field_lines(std::size_t lines, double width_m, std::mt19937_64& random) {
  const double across = width_m * static_cast<double>(lines) * uniform(random, 0.6, 0.9);
  const double slope = uniform(random, -0.5, 0.5), high = uniform(random, 60, 200);
  const Point pond{across * uniform(random, 0.2, 0.8), high * uniform(random, 0.3, 0.7)};
  const double radius = uniform(random, 0.1, 0.3) * std::min(across, high);
  LeavingPoses out;
  for (double x = width_m / 2; x < across && out.size() < 2 * lines; x += width_m) {
    const double foot = slope * x, head = foot + high * (1 + std::sin(3 * x / across));
    const double half = std::sqrt(std::max(0.0, radius * radius - (x - pond.x) * (x - pond.x)));
    const double middle = foot + pond.y;
    if (half > 0 && out.size() + 2 < 2 * lines) {
      add_line(out, {x, foot}, {x, middle - half});
      add_line(out, {x, middle + half}, {x, head});
    } else {
      add_line(out, {x, foot}, {x, head});
    }
  }
  while (out.size() < 2 * lines) {
    const Point from{across * uniform(random, 0, 1), high * uniform(random, -0.3, 1.5)};
    const double angle = uniform(random, 0, 6.28), length = uniform(random, 15, 60);
    add_line(out, from, from + Point{length * std::cos(angle), length * std::sin(angle)});
  }
  return out;
}

TableCosts dubins_costs(const LeavingPoses& leaving, double radius_m) {
  TableCosts out(leaving.size() / 2);
  for (End a = 0; a < leaving.size(); ++a)
    for (End b = 0; b < a; ++b) {
      if (a / 2 == b / 2) continue;
      // A line is entered at an end as it is left at the other: the lines are straight.
      const Pose entering{leaving[b].at, leaving[order::other_end(b)].heading};
      out.set(a, b, dubins_length(leaving[a], entering, radius_m) / kSpeed_m_s);
    }
  return out;
}

}  // namespace tramline::testing
