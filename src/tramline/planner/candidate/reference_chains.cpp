#include "tramline/planner/candidate/reference_chains.h"

#include <algorithm>
#include <cmath>

#include "tramline/geometry/angle.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

using Chain = std::vector<Point>;

double length_of(const Chain& chain) {
  double sum = 0;
  for (std::size_t i = 0; i + 1 < chain.size(); ++i) sum += distance(chain[i], chain[i + 1]);
  return sum;
}

/// How far the chain strays from the line between its ends.
double bend_of(const Chain& chain) {
  const Point along = chain.back() - chain.front();
  const double whole = length(along);
  double most = 0;
  for (const Point p : chain)
    most = std::max(
        most, whole > 0 ? std::abs(cross(along, p - chain.front())) / whole : distance(p, chain.front()));
  return most;
}

/// By how much the ring turns around vertex i, between the points `reach_m` before and after it, rad.
double turn_at(const Ring& ring, std::size_t i, double reach_m) {
  const std::size_t n = ring.size();
  const auto point_along = [&](int step) {
    Point at = ring[i];
    double left = reach_m;
    for (std::size_t k = 1; k < n; ++k) {
      const Point next = ring[step > 0 ? (i + k) % n : (i + n - k) % n];
      const double edge = distance(at, next);
      if (edge >= left) return at + (left / edge) * (next - at);
      left -= edge;
      at = next;
    }
    return at;
  };
  const Point in = ring[i] - point_along(-1), out = point_along(+1) - ring[i];
  return std::abs(std::atan2(cross(in, out), dot(in, out)));
}

/// Where the ring has its corners: of vertices close together the sharpest.
std::vector<std::size_t> corners_of(const Ring& ring, double reach_m) {
  const double least = Angle::degrees(30).radians();
  const std::size_t n = ring.size();
  std::vector<double> turns(n);
  for (std::size_t i = 0; i < n; ++i) turns[i] = turn_at(ring, i, reach_m);
  std::vector<std::size_t> out;
  for (std::size_t i = 0; i < n; ++i) {
    if (turns[i] < least) continue;
    bool sharpest = true;
    for (const int step : {-1, 1}) {
      double gone = 0;
      std::size_t at = i;
      for (std::size_t k = 1; k < n && sharpest; ++k) {
        const std::size_t next = step > 0 ? (i + k) % n : (i + n - k) % n;
        gone += distance(ring[at], ring[next]);
        at = next;
        if (gone > reach_m) break;
        sharpest = turns[next] < turns[i] || (turns[next] == turns[i] && next > i);
      }
    }
    if (sharpest) out.push_back(i);
  }
  return out;
}

/// The vertices from one to another, both included, round the ring.
Chain part_of(const Ring& ring, std::size_t from, std::size_t to) {
  Chain out{ring[from]};
  for (std::size_t i = from; i != to;) {
    i = i + 1 == ring.size() ? 0 : i + 1;
    out.push_back(ring[i]);
  }
  return out;
}

/// Once round, from the middle of the longest edge and back to where it began but for kSeam_m: straight
/// there, so that the way round has no kink.
Chain round_trip(const Ring& ring) {
  std::size_t longest = 0;
  const auto edge = [&ring](std::size_t i) { return distance(ring[i], ring[(i + 1) % ring.size()]); };
  for (std::size_t i = 1; i < ring.size(); ++i)
    if (edge(i) > edge(longest)) longest = i;
  const Point a = ring[longest], b = ring[(longest + 1) % ring.size()];
  const Point middle = midpoint(a, b), back = (0.5 * kSeam_m / edge(longest)) * (b - a);
  Chain out{middle + back};
  for (std::size_t i = 1; i <= ring.size(); ++i) out.push_back(ring[(longest + i) % ring.size()]);
  out.push_back(middle - back);
  return out;
}

}  // namespace

std::vector<Chain> reference_chains(const Region& ground, double corner_m, double least_bend_m,
                                    std::size_t most) {
  std::vector<Chain> out;
  for (const Polygon& part : ground) {
    const Ring& ring = part.outer;
    std::vector<std::size_t> corners = corners_of(ring, corner_m);
    if (corners.size() < 2) {
      out.push_back(round_trip(ring));
      continue;
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
      Chain chain = part_of(ring, corners[i], corners[(i + 1) % corners.size()]);
      if (bend_of(chain) > least_bend_m) out.push_back(std::move(chain));
    }
  }
  std::stable_sort(out.begin(), out.end(),
                   [](const Chain& a, const Chain& b) { return length_of(a) > length_of(b); });
  if (out.size() > most) out.resize(most);
  return out;
}

}  // namespace tramline
