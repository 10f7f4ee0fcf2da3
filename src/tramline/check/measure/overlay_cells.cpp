#include "tramline/check/measure/overlay_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace tramline::check {
namespace {

using OverlayEdge = OverlayEdges::Edge;
using Edges = std::vector<OverlayEdge>;

/// Windows with no more edges are cut into slabs.
constexpr std::size_t kFewEdges = 24;
/// Edges that meet at one point do not become fewer by halving.
constexpr int kMostHalvings = 48;
/// Nor do those that lie on one line, such as the sides of swaths along a line that is driven many times, and
/// there are windows all along it. Halvings that leave no edge aside before so many edges are cut anyway.
constexpr int kMostInVain = 6;
constexpr std::size_t kNotTooMany = 8 * kFewEdges;

double x_at(const OverlayEdge& edge, double y) {
  if (y <= edge.low.y) return edge.low.x;
  if (y >= edge.high.y) return edge.high.x;
  return edge.low.x + (y - edge.low.y) / (edge.high.y - edge.low.y) * (edge.high.x - edge.low.x);
}

double y_at(const OverlayEdge& edge, double x) {
  const double y = edge.low.y + (x - edge.low.x) / (edge.high.x - edge.low.x) * (edge.high.y - edge.low.y);
  return std::clamp(y, edge.low.y, edge.high.y);
}

void append(OverlayEdge edge, Point low, Point high, Edges& out) {
  if (!(high.y > low.y)) return;
  edge.low = low;
  edge.high = high;
  out.push_back(edge);
}

/// Edges along the left side of a window stand for all there is to the left of it. Those of one shape become
/// one for each stretch of one count.
void merge_along(double left, Edges& edges) {
  const auto first = std::partition(edges.begin(), edges.end(), [left](const OverlayEdge& edge) {
    return edge.low.x != left || edge.high.x != left;
  });
  if (edges.end() - first < 2) return;
  struct Change {
    std::size_t shape;
    double y;
    int change;
  };
  std::vector<Change> changes;
  for (auto edge = first; edge != edges.end(); ++edge) {
    changes.push_back({edge->shape, edge->low.y, edge->change});
    changes.push_back({edge->shape, edge->high.y, -edge->change});
  }
  edges.erase(first, edges.end());
  const std::size_t inner = edges.size();
  std::sort(changes.begin(), changes.end(),
            [](const Change& a, const Change& b) { return std::tie(a.shape, a.y) < std::tie(b.shape, b.y); });
  int count = 0;
  for (std::size_t i = 0; i < changes.size();) {
    const Change at = changes[i];
    for (; i < changes.size() && changes[i].shape == at.shape && changes[i].y == at.y; ++i)
      count += changes[i].change;
    if (count == 0 || i == changes.size() || changes[i].shape != at.shape) continue;
    const bool goes_on = edges.size() > inner && edges.back().shape == at.shape &&
                         edges.back().high.y == at.y && edges.back().change == count;
    if (goes_on)
      edges.back().high.y = changes[i].y;
    else
      edges.push_back({{left, at.y}, {left, changes[i].y}, at.shape, count});
  }
}

Edges below(const Edges& edges, double y) {
  Edges out;
  for (const OverlayEdge& edge : edges)
    if (edge.low.y < y) append(edge, edge.low, edge.high.y <= y ? edge.high : Point{x_at(edge, y), y}, out);
  return out;
}

Edges above(const Edges& edges, double y) {
  Edges out;
  for (const OverlayEdge& edge : edges)
    if (edge.high.y > y) append(edge, edge.low.y >= y ? edge.low : Point{x_at(edge, y), y}, edge.high, out);
  return out;
}

Edges left_of(const Edges& edges, double x) {
  Edges out;
  for (const OverlayEdge& edge : edges) {
    const bool low_in = edge.low.x <= x, high_in = edge.high.x <= x;
    if (low_in && high_in) {
      out.push_back(edge);
    } else if (low_in || high_in) {
      const Point cut{x, y_at(edge, x)};
      low_in ? append(edge, edge.low, cut, out) : append(edge, cut, edge.high, out);
    }
  }
  return out;
}

Edges right_of(const Edges& edges, double x) {
  Edges out;
  for (const OverlayEdge& edge : edges) {
    const bool low_in = edge.low.x >= x, high_in = edge.high.x >= x;
    if (low_in && high_in) {
      out.push_back(edge);
    } else if (!low_in && !high_in) {
      append(edge, {x, edge.low.y}, {x, edge.high.y}, out);
    } else {
      const double y = y_at(edge, x);
      append(edge, low_in ? edge.low : Point{x, edge.low.y}, {x, y}, out);
      append(edge, {x, y}, high_in ? edge.high : Point{x, edge.high.y}, out);
    }
  }
  merge_along(x, out);
  return out;
}

/// Appends the height at which two edges cross.
void append_crossing(const OverlayEdge& a, const OverlayEdge& b, std::vector<double>& heights) {
  const double from = std::max(a.low.y, b.low.y), to = std::min(a.high.y, b.high.y);
  if (!(from < to)) return;
  const double before = x_at(a, from) - x_at(b, from), behind = x_at(a, to) - x_at(b, to);
  if ((before < 0) == (behind < 0) || before == 0 || behind == 0) return;
  heights.push_back(from + before / (before - behind) * (to - from));
}

/// The counts of all shapes, ascending, on the way through a slab.
void count_in(const OverlayEdge& edge, std::vector<Cover>& covers) {
  const auto at = std::lower_bound(covers.begin(), covers.end(), edge.shape,
                                   [](const Cover& cover, std::size_t shape) { return cover.shape < shape; });
  if (at == covers.end() || at->shape != edge.shape) {
    covers.insert(at, {edge.shape, edge.change});
  } else {
    at->times += edge.change;
    if (at->times == 0) covers.erase(at);
  }
}

class Halving {
 public:
  explicit Halving(const std::function<void(const OverlayCell&)>& visit) : visit_(visit) {}

  void visit(const Edges& edges, const Box& window) { visit(edges, window, {}); }

 private:
  /// How the window came about.
  struct Halved {
    int times = 0;
    int in_vain = 0;  ///< the last of them, which left no edge aside
    std::size_t edges = std::numeric_limits<std::size_t>::max();
  };

  void visit(const Edges& edges, const Box& window, Halved halved) {
    if (edges.empty()) return;
    const std::size_t count = inner(edges, window.min_x);
    halved.in_vain = count < halved.edges ? 0 : halved.in_vain + 1;
    const bool in_vain = halved.in_vain >= kMostInVain && count <= kNotTooMany;
    if (count <= kFewEdges || halved.times >= kMostHalvings || in_vain) {
      cut(edges, window);
      return;
    }
    halved.edges = count;
    ++halved.times;
    const Point middle = window.centre();
    Box one = window, other = window;
    if (window.width() > window.height()) {
      one.max_x = other.min_x = middle.x;
      visit(left_of(edges, middle.x), one, halved);
      visit(right_of(edges, middle.x), other, halved);
    } else {
      one.max_y = other.min_y = middle.y;
      visit(below(edges, middle.y), one, halved);
      visit(above(edges, middle.y), other, halved);
    }
  }

  static std::size_t inner(const Edges& edges, double left) {
    return static_cast<std::size_t>(
        std::count_if(edges.begin(), edges.end(),
                      [left](const OverlayEdge& edge) { return edge.low.x != left || edge.high.x != left; }));
  }

  void cut(const Edges& edges, const Box& window) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < edges.size(); ++i) {
      heights.push_back(edges[i].low.y);
      heights.push_back(edges[i].high.y);
      for (std::size_t k = 0; k < i; ++k) append_crossing(edges[k], edges[i], heights);
    }
    std::sort(heights.begin(), heights.end());
    heights.erase(std::unique(heights.begin(), heights.end()), heights.end());
    for (std::size_t i = 0; i + 1 < heights.size(); ++i)
      visit_slab(edges, heights[i], heights[i + 1], window);
  }

  struct Wall {
    double bottom;
    double top;
    const OverlayEdge* edge;
  };

  void visit_slab(const Edges& edges, double bottom, double top, const Box& window) {
    walls_.clear();
    covers_.clear();
    for (const OverlayEdge& edge : edges)
      if (edge.low.y <= bottom && edge.high.y >= top)
        walls_.push_back({x_at(edge, bottom), x_at(edge, top), &edge});
    std::stable_sort(walls_.begin(), walls_.end(),
                     [](const Wall& a, const Wall& b) { return a.bottom + a.top < b.bottom + b.top; });
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      count_in(*walls_[i].edge, covers_);
      const Wall next = i + 1 < walls_.size() ? walls_[i + 1] : Wall{window.max_x, window.max_x, nullptr};
      visit_between(walls_[i], next, bottom, top);
    }
  }

  void visit_between(const Wall& left, const Wall& right, double bottom, double top) {
    const double twice_wide = right.bottom - left.bottom + right.top - left.top;
    if (covers_.empty() || !(twice_wide > 0)) return;
    inside_.clear();
    for (const Cover& cover : covers_)
      if (cover.times > 0) inside_.push_back(cover);
    if (inside_.empty()) return;
    const Point middle{0.25 * (left.bottom + left.top + right.bottom + right.top), 0.5 * (bottom + top)};
    visit_({0.5 * twice_wide * (top - bottom), middle, inside_});
  }

  const std::function<void(const OverlayCell&)>& visit_;
  std::vector<Wall> walls_;
  std::vector<Cover> covers_, inside_;
};

}  // namespace

void OverlayEdges::add_ring(const Ring& ring, int sign, std::size_t shape) {
  // Going up along a counter-clockwise ring its inside is on the left.
  const int up = signed_area(ring) > 0 ? -sign : sign;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point from = ring[i], to = ring[i + 1 < ring.size() ? i + 1 : 0];
    bounds_.extend(from);
    if (from.y < to.y) edges_.push_back({from, to, shape, up});
    if (from.y > to.y) edges_.push_back({to, from, shape, -up});
  }
}

void OverlayEdges::add(const Polygon& polygon, std::size_t shape) {
  add_ring(polygon.outer, 1, shape);
  for (const Ring& hole : polygon.holes) add_ring(hole, -1, shape);
}

void OverlayEdges::add(const Region& region, std::size_t shape) {
  for (const Polygon& polygon : region) add(polygon, shape);
}

void each_cell(const OverlayEdges& overlay, const std::function<void(const OverlayCell&)>& visit) {
  Halving(visit).visit(overlay.edges(), overlay.bounds());
}

}  // namespace tramline::check
