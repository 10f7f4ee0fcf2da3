#include "tramline/geometry/offset/offset_rings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "tramline/geometry/error.h"
#include "tramline/geometry/offset/offset_curve.h"
#include "tramline/geometry/polygon/faces.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// An edge of an offset boundary, or a disc (from == to).
struct Guard {
  Point from;
  Point to;
  double distance_m = 0;
  Box box;                           ///< contains all that is nearer
  const OffsetDisc* disc = nullptr;  ///< whose it is
};

/// A curve at some guard's distance. Its own guards are two consecutive ones: edges at a corner, or twice
/// the same.
struct Candidate {
  OffsetCurve curve;
  std::size_t offset_boundary = 0;
  std::size_t guards[2] = {};
};

/// Whether a guard of a disc, or one of a boundary, counts at a point.
bool counts_at(const Guard& guard, Point p) { return guard.disc == nullptr || guard.disc->counts_at(p); }

struct CurveCut {
  double position = 0;
  Point at;
  std::size_t node = 0;
};

enum class Standing { kFree, kDoubtful };

struct Piece {
  std::size_t candidate = 0;
  CurveCut from;
  CurveCut to;
  Standing standing = Standing::kFree;
  bool walked = false;
};

struct Arrangement {
  const std::vector<OffsetBoundary>* offset_boundaries = nullptr;
  std::vector<char> outer;  ///< by offset boundary: the land is inside the ring
  std::vector<Guard> guards;
  std::vector<Candidate> candidates;
  std::vector<std::vector<CurveCut>> cuts;  ///< by candidate
  std::vector<Piece> pieces;                ///< those that may be part of the boundary
};

double squared_distance(Point p, const Guard& guard) {
  const Point along = guard.to - guard.from, there = p - guard.from;
  const double square = dot(along, along);
  const double share = square > 0 ? std::clamp(dot(there, along) / square, 0.0, 1.0) : 0;
  const Point apart = there - share * along;
  return dot(apart, apart);
}

void add_guard(Arrangement& to, Point a, Point b, double distance_m) {
  to.guards.push_back({a, b, distance_m, bounds(a, b).grown(distance_m), nullptr});
}

bool has_arc_about(const OffsetBoundary& offset_boundary, std::size_t corner) {
  const std::vector<std::size_t>& covered = offset_boundary.covered_corners;
  return offset_boundary.round_corners && !std::binary_search(covered.begin(), covered.end(), corner);
}

void add_boundary(Arrangement& to, const OffsetBoundary& offset_boundary, std::size_t index) {
  const std::size_t n = offset_boundary.ring.size(), first = to.guards.size();
  const double d = offset_boundary.distance_m;
  std::vector<Point> normals;
  for (std::size_t i = 0; i < n; ++i) {
    const Point a = offset_boundary.ring[i], b = offset_boundary.ring[(i + 1) % n];
    add_guard(to, a, b, d);
    normals.push_back((1 / distance(a, b)) * left_of(b - a));
  }
  // Where the line along an edge ends and where that along the next one begins.
  std::vector<Point> ends(n), starts(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const Point corner = offset_boundary.ring[next];
    ends[i] = corner + d * normals[i];
    starts[next] = corner + d * normals[next];
    const double turn = cross(normals[i], normals[next]);
    const double shortest = std::min(distance(offset_boundary.ring[i], corner),
                                     distance(corner, offset_boundary.ring[(next + 1) % n]));
    if (std::abs(turn) < kNoCorner_rad && dot(normals[i], normals[next]) > 0 && d * std::abs(turn) < shortest)
      ends[i] = starts[next] = midpoint(ends[i], starts[next]);
    else if (turn < 0 && has_arc_about(offset_boundary, next))
      to.candidates.push_back(
          {offset_arc(corner, d, ends[i], starts[next]), index, {first + i, first + next}});
  }
  for (std::size_t i = 0; i < n; ++i)
    to.candidates.push_back({offset_line(starts[i], ends[i]), index, {first + i, first + i}});
}

/// Thirds of the circle.
void add_disc(Arrangement& to, const OffsetDisc& disc) {
  const std::size_t guard = to.guards.size();
  add_guard(to, disc.centre, disc.centre, disc.radius_m);
  to.guards.back().disc = &disc;
  const auto at = [&](int third) {
    const double angle = -2 * std::numbers::pi / 3 * (third % 3);
    return disc.centre + disc.radius_m * Point{std::cos(angle), std::sin(angle)};
  };
  for (int i = 0; i < 3; ++i)
    to.candidates.push_back(
        {offset_arc(disc.centre, disc.radius_m, at(i), at(i + 1)), disc.offset_boundary, {guard, guard}});
}

/// Whether one is a line and the other the arc about an end of its edge: these touch where they join.
bool touch_at_join(const Candidate& a, const Candidate& b) {
  if (a.curve.straight() == b.curve.straight()) return false;
  const Candidate& line = a.curve.straight() ? a : b;
  const Candidate& arc = a.curve.straight() ? b : a;
  return line.guards[0] == arc.guards[0] || line.guards[0] == arc.guards[1];
}

void cut(Arrangement& a, std::size_t candidate, Point at) {
  const OffsetCurve& curve = a.candidates[candidate].curve;
  a.cuts[candidate].push_back({std::clamp(position_on(curve, at), 0.0, curve.extent), at, 0});
}

/// Cuts candidates where they meet. Sweeps over x, so that only candidates at one x are compared.
void cut_at_meetings(Arrangement& a) {
  const std::size_t n = a.candidates.size();
  a.cuts.assign(n, {});
  std::vector<std::size_t> order(n);
  for (std::size_t i = 0; i < n; ++i) {
    const OffsetCurve& curve = a.candidates[i].curve;
    a.cuts[i] = {{0, curve.from, 0}, {curve.extent, curve.to, 0}};
    order[i] = i;
  }
  const auto left = [&](std::size_t i) { return a.candidates[i].curve.box.min_x; };
  std::sort(order.begin(), order.end(),
            [&](std::size_t i, std::size_t j) { return std::pair(left(i), i) < std::pair(left(j), j); });
  std::vector<std::size_t> open;
  for (const std::size_t i : order) {
    std::erase_if(open, [&](std::size_t j) { return a.candidates[j].curve.box.max_x < left(i); });
    for (const std::size_t j : open) {
      if (touch_at_join(a.candidates[i], a.candidates[j])) continue;
      for (const Point p : meetings(a.candidates[i].curve, a.candidates[j].curve)) {
        cut(a, i, p);
        cut(a, j, p);
      }
    }
    open.push_back(i);
  }
}

/// Gives cuts at the same point the same node.
void name_nodes(Arrangement& a) {
  std::vector<CurveCut*> all;
  for (auto& cuts : a.cuts)
    for (CurveCut& c : cuts) all.push_back(&c);
  std::sort(all.begin(), all.end(), [](const CurveCut* p, const CurveCut* q) {
    return std::pair(p->at.x, p->at.y) < std::pair(q->at.x, q->at.y);
  });
  std::size_t first = 0;
  for (std::size_t i = 0; i < all.size(); ++i) {
    all[i]->node = i;
    while (all[first]->at.x < all[i]->at.x - kSameNode_m) ++first;
    for (std::size_t j = i; j-- > first;)
      if (std::abs(all[j]->at.y - all[i]->at.y) < kSameNode_m) {
        all[i]->node = all[j]->node;
        break;
      }
  }
}

/// How surely a point of the candidate is free; nullopt where it is not, or not part of the boundary of what
/// has to be kept free. `near` are guards that may be nearer.
std::optional<Standing> standing(const Arrangement& a, const Candidate& candidate, Point p,
                                 const std::vector<std::size_t>& near) {
  Standing out = Standing::kFree;
  if (!counts_at(a.guards[candidate.guards[0]], p)) return std::nullopt;
  for (const std::size_t g : near) {
    if (g == candidate.guards[0] || g == candidate.guards[1] || !counts_at(a.guards[g], p)) continue;
    const double limit = a.guards[g].distance_m, square = squared_distance(p, a.guards[g]);
    const double low = limit - kSameDistance_m, high = limit + kSameDistance_m;
    if (square < low * low) return std::nullopt;
    if (square < high * high) out = Standing::kDoubtful;
  }
  return out;
}

/// Around a disc, or where one offset boundary has a larger distance than the next, there may be land beyond
/// the offset boundaries.
bool beyond_boundaries(const Arrangement& a, Point p) {
  for (std::size_t i = 0; i < a.outer.size(); ++i)
    if (contains((*a.offset_boundaries)[i].ring, p) != (a.outer[i] != 0)) return true;
  return false;
}

void keep_free_pieces(Arrangement& a) {
  std::vector<std::size_t> near;
  for (std::size_t i = 0; i < a.candidates.size(); ++i) {
    const Candidate& candidate = a.candidates[i];
    const Box reach = candidate.curve.box.grown(kSameNode_m);
    near.clear();
    for (std::size_t g = 0; g < a.guards.size(); ++g)
      if (intersects(a.guards[g].box, reach)) near.push_back(g);
    auto& cuts = a.cuts[i];
    std::stable_sort(cuts.begin(), cuts.end(),
                     [](const CurveCut& p, const CurveCut& q) { return p.position < q.position; });
    const CurveCut* last = &cuts.front();
    for (const CurveCut& next : cuts) {
      if (next.node == last->node) continue;
      const Point middle = point_at(candidate.curve, 0.5 * (last->position + next.position));
      const auto is = standing(a, candidate, middle, near);
      if (is && !beyond_boundaries(a, middle)) a.pieces.push_back({i, *last, next, *is, false});
      last = &next;
    }
  }
  std::stable_sort(a.pieces.begin(), a.pieces.end(),
                   [](const Piece& p, const Piece& q) { return p.from.node < q.from.node; });
}

/// Turn to the left at a node, rad; going back counts as left.
double turn(const Arrangement& a, const Piece& from, const Piece& to) {
  const Point before = heading_at(a.candidates[from.candidate].curve, from.to.at);
  const Point after = heading_at(a.candidates[to.candidate].curve, to.from.at);
  const double angle = std::atan2(cross(before, after), dot(before, after));
  return angle < -std::numbers::pi + kStraightBack_rad ? angle + 2 * std::numbers::pi : angle;
}

/// The piece to follow: the land is what lies to the left of all of them, so the leftmost one bounds it.
Piece* leftmost(Arrangement& a, const Piece& from) {
  auto [first, last] =
      std::equal_range(a.pieces.begin(), a.pieces.end(), Piece{0, from.to, from.to},
                       [](const Piece& p, const Piece& q) { return p.from.node < q.from.node; });
  // Curves that leave in one direction, up to rounding: one that is free for sure, then the one that bends
  // left.
  const auto rank = [&](const Piece& p) {
    return std::pair(p.standing == Standing::kFree, curvature(a.candidates[p.candidate].curve));
  };
  Piece* best = nullptr;
  double best_turn = 0;
  for (auto it = first; it != last; ++it) {
    const double here = turn(a, from, *it);
    const bool better = best == nullptr || here > best_turn + kSameHeading_rad ||
                        (here > best_turn - kSameHeading_rad && rank(*it) > rank(*best));
    if (!better) continue;
    best = &*it;
    best_turn = here;
  }
  return best;
}

OffsetPiece finished(const Arrangement& a, const Piece& piece) {
  const Candidate& candidate = a.candidates[piece.candidate];
  return {{piece.from.at, piece.to.at, curvature(candidate.curve)},
          candidate.curve.centre,
          heading_at(candidate.curve, piece.from.at),
          heading_at(candidate.curve, piece.to.at),
          candidate.offset_boundary};
}

/// A closed walk from a piece that is free for sure back to it.
OffsetRing walk(Arrangement& a, Piece& start) {
  OffsetRing out;
  Piece* piece = &start;
  do {
    piece->walked = true;
    out.push_back(finished(a, *piece));
    piece = leftmost(a, *piece);
    if (piece == nullptr || out.size() > a.pieces.size())
      throw failure("the offset of the boundary could not be constructed near (" +
                    std::to_string(out.back().segment.to.x) + ", " + std::to_string(out.back().segment.to.y) +
                    ")");
  } while (piece != &start);
  return out;
}

}  // namespace

std::vector<OffsetRing> offset_rings(const std::vector<OffsetBoundary>& offset_boundaries,
                                     const std::vector<OffsetDisc>& discs) {
  Arrangement a;
  a.offset_boundaries = &offset_boundaries;
  for (const OffsetBoundary& offset_boundary : offset_boundaries)
    a.outer.push_back(signed_area(offset_boundary.ring) > 0 ? 1 : 0);
  for (std::size_t i = 0; i < offset_boundaries.size(); ++i) add_boundary(a, offset_boundaries[i], i);
  for (const OffsetDisc& disc : discs) add_disc(a, disc);
  cut_at_meetings(a);
  name_nodes(a);
  keep_free_pieces(a);
  std::vector<OffsetRing> out;
  for (Piece& piece : a.pieces)
    if (piece.standing == Standing::kFree && !piece.walked) out.push_back(walk(a, piece));
  return out;
}

Region offset_region(const std::vector<OffsetRing>& rings, double sagitta_m) {
  std::vector<DirectedEdge> edges;
  for (const OffsetRing& ring : rings) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < ring.size(); ++i) {
      // The piece before decides where a piece begins: the two agree up to rounding.
      PathSegment segment = ring[i].segment;
      const Point previous = ring[i == 0 ? ring.size() - 1 : i - 1].segment.to;
      if (distance(previous, segment.to) < kSameNode_m) continue;
      segment.from = previous;
      const std::vector<Point> more = chords({segment}, sagitta_m);
      points.insert(points.end(), more.begin() + 1, more.end());
    }
    if (points.size() < 3) continue;
    for (std::size_t i = 0; i < points.size(); ++i)
      edges.push_back({points[i], points[(i + 1) % points.size()]});
  }
  return faces_of(std::move(edges));
}

}  // namespace tramline
