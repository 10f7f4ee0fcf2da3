#include "tramline/geometry/path_profile.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tramline {
namespace {

/// What is shorter is no part of a path, m.
constexpr double kNoLength = 1e-9;
/// A crossing as near to a segment's end may be the next one's, m.
constexpr double kJoint = 1e-9;
/// How exactly positions are found on arcs, m.
constexpr double kPosition = 1e-9;

Point left_of(Point direction) { return {-direction.y, direction.x}; }

// --- One segment's coordinates -----------------------------------------------------------------

/// A point as the segment sees it: metres to the right and along, or, for arcs, Cartesian coordinates
/// about the centre whose first axis points to the arc's middle and in which the path turns left.
class SegmentFrame {
 public:
  SegmentFrame(const PathSegment& segment, double half_width) : half_(half_width) {
    // In roots where path.h takes hypotenuses and angles: this is done for every segment of every track.
    const Point chord = segment.to - segment.from;
    const double across = std::sqrt(dot(chord, chord));
    origin_ = segment.from;
    ahead_ = (1 / across) * chord;
    length_ = across;
    if (segment.straight()) return;
    radius_ = 1 / std::abs(segment.curvature);
    sense_ = segment.curvature > 0 ? 1 : -1;
    const double sine = std::min(1.0, 0.5 * across / radius_);
    half_turn_ = std::asin(sine);
    length_ = 2 * half_turn_ * radius_;
    ahead_ = -sense_ * left_of(ahead_);
    origin_ = midpoint(segment.from, segment.to) - (radius_ * std::sqrt((1 - sine) * (1 + sine))) * ahead_;
  }

  bool straight() const { return radius_ == 0; }
  double radius() const { return radius_; }
  int sense() const { return sense_; }
  double half_turn() const { return half_turn_; }
  double length() const { return length_; }

  Point local(Point p) const {
    const Point d = p - origin_;
    if (straight()) return {cross(d, ahead_), dot(d, ahead_)};
    return {dot(d, ahead_), sense_ * cross(ahead_, d)};
  }

  /// Distance from the left end of the cross-section, and position along, of a local point.
  double across(Point q) const {
    return straight() ? q.x + half_ : sense_ * (std::sqrt(dot(q, q)) - radius_) + half_;
  }
  double along(Point q) const { return straight() ? q.y : radius_ * (std::atan2(q.y, q.x) + half_turn_); }

  /// The point of the field at a position along and a distance from the left end.
  Point place(double along, double across) const {
    if (straight()) return origin_ + along * ahead_ - (across - half_) * left_of(ahead_);
    const double angle = sense_ * (along / radius_ - half_turn_);
    const double c = std::cos(angle), s = std::sin(angle);
    return origin_ + (radius_ + sense_ * (across - half_)) *
                         Point{c * ahead_.x - s * ahead_.y, s * ahead_.x + c * ahead_.y};
  }

 private:
  double half_;
  Point origin_;
  Point ahead_;
  double length_ = 0;
  double radius_ = 0;
  int sense_ = 0;
  double half_turn_ = 0;
};

double across_at(const SegmentProfile& segment, double half_width, const SectionPart& part, double along) {
  if (along <= part.from) return part.across_from;
  if (along >= part.to) return part.across_to;
  if (segment.radius == 0)
    return part.across_from +
           (part.across_to - part.across_from) * ((along - part.from) / (part.to - part.from));
  const double angle = along / segment.radius - segment.half_turn;
  const double radius = part.moment / (std::cos(angle) * part.edge.y - std::sin(angle) * part.edge.x);
  const double across = segment.sense * (radius - segment.radius) + half_width;
  const auto [low, high] = std::minmax(part.across_from, part.across_to);
  return across >= low ? std::min(across, high) : low;  // NaN: low
}

// --- Edges to parts ----------------------------------------------------------------------------

/// Where the boundary crosses the right ends of the cross-sections.
struct RightCrossing {
  double along;
  int change;  ///< +1: the region begins there
};

class SegmentMaker {
 public:
  SegmentMaker(const PathSegment& segment, double start, double width)
      : frame_(segment, 0.5 * width), width_(width) {
    out_.start = start;
    out_.length = frame_.length();
    out_.radius = frame_.radius();
    out_.sense = frame_.sense();
    out_.half_turn = frame_.half_turn();
  }

  /// All edges near the segment, in order.
  void add_edges(const EdgeIndex& region, std::vector<std::size_t>& near) {
    near.clear();
    const int count = std::clamp(static_cast<int>(0.5 * out_.length / region.grid().cell_m()), 1, 1000);
    const double part = out_.length / count;
    const double bulge = frame_.straight() ? 0 : part * part / (4 * frame_.radius());
    Point end = frame_.place(0, 0.5 * width_);
    for (int i = 1; i <= count; ++i) {
      Box box;
      box.extend(end);
      end = frame_.place(i * part, 0.5 * width_);
      box.extend(end);
      region.grid().each_meeting(box.grown(0.5 * width_ + bulge + 1e-6),
                                 [&](std::size_t e) { near.push_back(e); });
    }
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    for (const std::size_t e : near) add(region.edges()[e].from, region.edges()[e].to);
  }

  void add(Point from, Point to) {
    Point a = frame_.local(from), b = frame_.local(to);
    if (frame_.straight()) return add_monotonic(a, b);
    // What lies behind the centre is on none of the arc's cross-sections: it turns by half a circle at most.
    if (a.x < 0 && b.x < 0) return;
    if (a.x < 0) a = {0, a.y + (b.y - a.y) * (a.x / (a.x - b.x))};
    if (b.x < 0) b = {0, b.y + (a.y - b.y) * (b.x / (b.x - a.x))};
    const Point edge = b - a;
    const double square = dot(edge, edge);
    if (square == 0) return;
    const double foot = -dot(a, edge) / square;
    if (foot <= 0 || foot >= 1) return add_monotonic(a, b);
    const Point nearest = a + foot * edge;
    add_monotonic(a, nearest);
    add_monotonic(nearest, b);
  }

  /// What is inside where the last segment ended; what is inside goes on from there.
  struct Before {
    int right_inside = -1;  ///< negative: not known
    double inside_m = 0;
  };

  SegmentProfile finish(const EdgeIndex& region, Before& before) {
    std::sort(right_.begin(), right_.end(),
              [](const RightCrossing& a, const RightCrossing& b) { return a.along < b.along; });
    make_slabs();
    set_states(before.right_inside);
    // An edge beside the right ends may cross them here as one segment sees it and there as the next one
    // does: then the length inside jumps, and so it may where an edge lies along a cross-section.
    constexpr double kJump = 1e-6;
    if (near_start_ || before.right_inside < 0 ||
        std::abs(inside_at(out_.slabs.front(), 0) - before.inside_m) > kJump)
      set_states(state_at_start(region));
    before.right_inside = near_end_ ? -1 : out_.slabs.back().right_inside;
    before.inside_m = inside_at(out_.slabs.back(), out_.length);
    return std::move(out_);
  }

 private:
  /// Across changes one way only from a to b.
  void add_monotonic(Point a, Point b) {
    const double across_a = frame_.across(a), across_b = frame_.across(b);
    const bool rightward = across_a < across_b;
    const Point left = rightward ? a : b, right = rightward ? b : a;
    const double low = rightward ? across_a : across_b, high = rightward ? across_b : across_a;
    // Points on an end count as right of it, so a cross-section owns [0, w).
    if (high < 0 || low >= width_) return;
    const double left_along = low < 0 ? along_where(left, right, 0) : frame_.along(left);
    const double right_along = high >= width_ ? along_where(left, right, width_) : frame_.along(right);
    if (high >= width_) {
      near_start_ = near_start_ || std::abs(right_along) < kJoint;
      near_end_ = near_end_ || std::abs(right_along - out_.length) < kJoint;
      if (right_along >= 0 && right_along < out_.length) right_.push_back({right_along, rightward ? 1 : -1});
    }
    const double clipped_low = std::max(low, 0.0), clipped_high = std::min(high, width_);
    if (left_along == right_along) return;
    const bool rises = left_along < right_along;
    SectionPart part;
    part.from = rises ? left_along : right_along;
    part.to = rises ? right_along : left_along;
    part.across_from = rises ? clipped_low : clipped_high;
    part.across_to = rises ? clipped_high : clipped_low;
    part.sign = rises == rightward ? 1 : -1;
    part.edge = right - left;
    part.moment = cross(left, part.edge);
    if (part.to <= 0 || part.from >= out_.length) return;
    clip_along(part);
    out_.parts.push_back(part);
  }

  void clip_along(SectionPart& part) const {
    const double at_start = across_at(out_, 0.5 * width_, part, 0);
    const double at_end = across_at(out_, 0.5 * width_, part, out_.length);
    if (part.from < 0) {
      part.from = 0;
      part.across_from = at_start;
    }
    if (part.to > out_.length) {
      part.to = out_.length;
      part.across_to = at_end;
    }
  }

  /// Position at which the segment from left to right is that far across.
  double along_where(Point left, Point right, double across) const {
    const Point edge = right - left;
    if (frame_.straight()) {
      const double share = (across - frame_.across(left)) / edge.x;
      const double y = left.y + share * edge.y;
      return std::clamp(y, std::min(left.y, right.y), std::max(left.y, right.y));
    }
    const double radius = frame_.radius() + frame_.sense() * (across - 0.5 * width_);
    const double square = dot(edge, edge), half = dot(left, edge);
    const double root = std::sqrt(std::max(0.0, half * half - square * (dot(left, left) - radius * radius)));
    // Away from the centre the radius grows with the edge's parameter, on the arc's inside it shrinks.
    const double share = std::clamp((-half + (frame_.sense() > 0 ? root : -root)) / square, 0.0, 1.0);
    return frame_.along(left + share * edge);
  }

  void make_slabs() {
    if (out_.parts.empty() && right_.empty()) {
      out_.slabs.push_back({0, out_.length});
      return;
    }
    std::vector<double> cuts{0, out_.length};
    for (const SectionPart& part : out_.parts) {
      cuts.push_back(part.from);
      cuts.push_back(part.to);
    }
    for (const RightCrossing& crossing : right_) cuts.push_back(crossing.along);
    std::sort(cuts.begin(), cuts.end());
    cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
      SectionSlab slab{cuts[i], cuts[i + 1]};
      for (std::size_t p = 0; p < out_.parts.size(); ++p)
        if (out_.parts[p].from <= slab.from && out_.parts[p].to >= slab.to) slab.parts.push_back(p);
      out_.slabs.push_back(std::move(slab));
    }
  }

  void set_states(int at_start) {
    int state = at_start;
    auto crossing = right_.begin();
    for (SectionSlab& slab : out_.slabs) {
      for (; crossing != right_.end() && crossing->along <= slab.from; ++crossing) state += crossing->change;
      slab.right_inside = state;
    }
  }

  double inside_at(const SectionSlab& slab, double along) const {
    double sum = slab.right_inside * width_;
    for (const std::size_t p : slab.parts)
      sum += out_.parts[p].sign * across_at(out_, 0.5 * width_, out_.parts[p], along);
    return sum;
  }

  /// Asks for the middle of the widest gap between edges in the longest slab, and goes back from there.
  int state_at_start(const EdgeIndex& region) const {
    const auto longest = std::max_element(
        out_.slabs.begin(), out_.slabs.end(),
        [](const SectionSlab& a, const SectionSlab& b) { return a.to - a.from < b.to - b.from; });
    const double along = 0.5 * (longest->from + longest->to);
    std::vector<std::pair<double, int>> met{{0, 0}, {width_, 0}};
    for (const std::size_t p : longest->parts)
      met.emplace_back(across_at(out_, 0.5 * width_, out_.parts[p], along), out_.parts[p].sign);
    std::sort(met.begin(), met.end());
    std::size_t widest = 0;
    for (std::size_t i = 0; i + 1 < met.size(); ++i)
      if (met[i + 1].first - met[i].first > met[widest + 1].first - met[widest].first) widest = i;
    const Point asked = frame_.place(along, 0.5 * (met[widest].first + met[widest + 1].first));
    int state = region.contains(asked) ? 1 : 0;
    for (std::size_t i = widest + 1; i < met.size(); ++i) state -= met[i].second;
    for (const RightCrossing& crossing : right_)
      if (crossing.along <= longest->from) state -= crossing.change;
    return state;
  }

  SegmentFrame frame_;
  double width_;
  SegmentProfile out_;
  std::vector<RightCrossing> right_;
  bool near_start_ = false;  ///< the right ends cross an edge there, if not in the segment next to this one
  bool near_end_ = false;
};

// --- What is inside ----------------------------------------------------------------------------

class Insides {
 public:
  Insides(const PathProfile& profile, double least) : width_(profile.width_m), least_(least) {}

  void add(const SegmentProfile& segment, const SectionSlab& slab, Intervals& out) const {
    if (slab.parts.empty()) {
      if (slab.right_inside * width_ >= least_) append(segment, slab.from, slab.to, out);
      return;
    }
    search(segment, slab, slab.from, slab.to, out);
  }

 private:
  /// Bounds of the inside length between two positions: every part is monotonic.
  void search(const SegmentProfile& segment, const SectionSlab& slab, double from, double to,
              Intervals& out) const {
    double low = slab.right_inside * width_, high = low, at_from = low, at_to = low;
    for (const std::size_t p : slab.parts) {
      const SectionPart& part = segment.parts[p];
      const double a = part.sign * across_at(segment, 0.5 * width_, part, from);
      const double b = part.sign * across_at(segment, 0.5 * width_, part, to);
      low += std::min(a, b);
      high += std::max(a, b);
      at_from += a;
      at_to += b;
    }
    if (low >= least_) return append(segment, from, to, out);
    if (high < least_) return;
    double middle = 0.5 * (from + to);
    if (segment.radius == 0) {
      if ((at_from >= least_) == (at_to >= least_)) {
        if (at_from >= least_) append(segment, from, to, out);
        return;
      }
      middle = from + (to - from) * ((least_ - at_from) / (at_to - at_from));
      return at_from >= least_ ? append(segment, from, middle, out) : append(segment, middle, to, out);
    }
    if (to - from <= kPosition) {
      if (at_from >= least_ && at_to >= least_) append(segment, from, to, out);
      return;
    }
    search(segment, slab, from, middle, out);
    search(segment, slab, middle, to, out);
  }

  static void append(const SegmentProfile& segment, double from, double to, Intervals& out) {
    if (from < to) append_joining(out, {segment.start + from, segment.start + to});
  }

  double width_;
  double least_;
};

double area_of(const SegmentProfile& segment, double width, const SectionSlab& slab, double from, double to) {
  const double half = 0.5 * width, along = to - from;
  double sum = slab.right_inside * width * along;
  for (const std::size_t p : slab.parts) {
    const SectionPart& part = segment.parts[p];
    const double a = across_at(segment, half, part, from), b = across_at(segment, half, part, to);
    if (segment.radius == 0) {
      sum += part.sign * 0.5 * (a + b) * along;
      continue;
    }
    // The triangle from the arc's centre, and the sector up to the cross-sections' left ends.
    const double angle = along / segment.radius, left = segment.radius - segment.sense * half;
    const double r_a = left + segment.sense * a, r_b = left + segment.sense * b;
    sum += part.sign * segment.sense * 0.5 * (r_a * r_b * std::sin(angle) - left * left * angle);
  }
  return sum;
}

PathSegment part_of(const PathSegment& segment, double from, double to) {
  const double whole = length(segment);
  const SegmentFrame frame(segment, 0);
  const Point a = from <= 0 ? segment.from : frame.place(from, 0);
  const Point b = to >= whole ? segment.to : frame.place(to, 0);
  return {a, b, segment.curvature};
}

}  // namespace

EdgeIndex::EdgeIndex(const Region& oriented) {
  std::vector<Box> boxes;
  for (const Ring& ring : rings_of(oriented))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      edges_.push_back({ring[i], ring[i + 1 == ring.size() ? 0 : i + 1]});
      boxes.emplace_back();
      boxes.back().extend(edges_.back().from);
      boxes.back().extend(edges_.back().to);
    }
  grid_ = BoxGrid(boxes);
}

bool EdgeIndex::contains(Point p) const {
  bool inside = false;
  for (const Edge& e : edges_) {
    const Point a = e.from, b = e.to;
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
  }
  return inside;
}

PathProfile path_profile(const EdgeIndex& region, const Path& path, double width_m) {
  PathProfile out{width_m, {}};
  out.segments.reserve(path.size());
  std::vector<std::size_t> near;
  SegmentMaker::Before before;
  double start = 0;
  for (const PathSegment& segment : path) {
    SegmentMaker maker(segment, start, width_m);
    maker.add_edges(region, near);
    out.segments.push_back(maker.finish(region, before));
    start += out.segments.back().length;
  }
  return out;
}

Intervals where_at_least(const PathProfile& profile, double least_m) {
  const Insides insides(profile, least_m);
  Intervals out;
  for (const SegmentProfile& segment : profile.segments)
    for (const SectionSlab& slab : segment.slabs) insides.add(segment, slab, out);
  return out;
}

Intervals centre_inside(const PathProfile& profile) {
  const double half = 0.5 * profile.width_m;
  Intervals out;
  for (const SegmentProfile& segment : profile.segments)
    for (const SectionSlab& slab : segment.slabs) {
      std::vector<double> cuts{slab.from, slab.to};
      for (const std::size_t p : slab.parts) {
        const SectionPart& part = segment.parts[p];
        double low = slab.from, high = slab.to;
        const bool above = across_at(segment, half, part, low) >= half;
        if (above == (across_at(segment, half, part, high) >= half)) continue;
        while (high - low > kPosition) {
          const double middle = 0.5 * (low + high);
          (above == (across_at(segment, half, part, middle) >= half) ? low : high) = middle;
        }
        cuts.push_back(0.5 * (low + high));
      }
      std::sort(cuts.begin(), cuts.end());
      for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        int inside = slab.right_inside;
        for (const std::size_t p : slab.parts)
          if (across_at(segment, half, segment.parts[p], 0.5 * (cuts[i] + cuts[i + 1])) > half)
            inside += segment.parts[p].sign;
        if (inside > 0 && cuts[i] < cuts[i + 1])
          append_joining(out, {segment.start + cuts[i], segment.start + cuts[i + 1]});
      }
    }
  return out;
}

double area_between(const PathProfile& profile, double from, double to) {
  double sum = 0;
  for (const SegmentProfile& segment : profile.segments) {
    if (segment.start >= to || segment.start + segment.length <= from) continue;
    for (const SectionSlab& slab : segment.slabs) {
      const double low = std::max(slab.from, from - segment.start);
      const double high = std::min(slab.to, to - segment.start);
      if (low < high) sum += area_of(segment, profile.width_m, slab, low, high);
    }
  }
  return sum;
}

Path path_between(const Path& path, double from, double to) {
  Path out;
  double start = 0;
  for (const PathSegment& segment : path) {
    const double whole = length(segment), low = std::max(0.0, from - start),
                 high = std::min(whole, to - start);
    start += whole;
    if (high - low <= kNoLength) continue;
    PathSegment part = part_of(segment, low, high);
    if (!out.empty()) part.from = out.back().to;
    out.push_back(part);
  }
  return out;
}

}  // namespace tramline
