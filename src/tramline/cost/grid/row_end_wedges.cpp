#include "tramline/cost/grid/row_end_wedges.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tramline {
namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// ∫ y dx below a chain and the heights at two coordinates across, gathered edge by edge while the boundary
/// passes through a strip. x is measured from the strip's left line.
class Passage {
 public:
  Passage(double width, const EndCriterion& criterion, bool from_left)
      : width_(width),
        low_share_(criterion.by_centre_line ? 0.5 * width : criterion.least_width_m),
        high_share_(width - low_share_),
        from_left_(from_left) {}

  void add(double x0, double y0, double x1, double y1) {
    rises_ = rises_ || y1 > y0;
    falls_ = falls_ || y1 < y0;
    if (x1 < x0) {
      std::swap(x0, x1);
      std::swap(y0, y1);
      leftward_ = true;
    } else if (x1 > x0) {
      rightward_ = true;
    }
    lowest_ = std::min({lowest_, y0, y1});
    highest_ = std::max({highest_, y0, y1});
    if (!(x0 < x1)) return;
    whole_ += 0.5 * (y0 + y1) * (x1 - x0);
    add_to(low_share_, low_, x0, y0, x1, y1);
    add_to(high_share_, high_, x0, y0, x1, y1);
  }

  bool turns_back() const { return (leftward_ && rightward_) || (rises_ && falls_); }
  bool comes_from_left() const { return from_left_; }

  /// The region lies to the left of the boundary's direction: above what runs to the right.
  RowEndWedge end() const {
    const bool begins = from_left_;
    // Heights relative to the region: a swath that begins covers land that is higher than its end.
    const bool rises_across = rightward_ ? rises_ : falls_;
    const bool narrow_side_left = begins == rises_across;
    const Share& split = narrow_side_left ? low_ : high_;
    const double x = narrow_side_left ? low_share_ : high_share_;
    // Beyond the split, on the side where the boundary lies further inside the region.
    const double beyond = narrow_side_left ? whole_ - split.integral : split.integral;
    const double across = narrow_side_left ? width_ - x : x;
    const double over = begins ? beyond - split.height * across : split.height * across - beyond;
    return {begins, lowest_, highest_, split.height, std::max(0.0, over)};
  }

 private:
  struct Share {
    double height = 0;
    double integral = 0;  ///< of the chain from x = 0 to the share
  };

  static void add_to(double share, Share& out, double x0, double y0, double x1, double y1) {
    if (share >= x1) {
      out.integral += 0.5 * (y0 + y1) * (x1 - x0);
      if (share == x1) out.height = y1;
      return;
    }
    if (share < x0) return;
    out.height = y0 + (y1 - y0) * ((share - x0) / (x1 - x0));
    out.integral += 0.5 * (y0 + out.height) * (share - x0);
  }

  double width_;
  double low_share_;
  double high_share_;
  bool from_left_;
  bool rises_ = false, falls_ = false, leftward_ = false, rightward_ = false;
  double lowest_ = kFar, highest_ = -kFar;
  double whole_ = 0;
  Share low_, high_;
};

double along_at(Point a, Point b, double across) {
  return a.y + (b.y - a.y) * ((across - a.x) / (b.x - a.x));
}

}  // namespace

void RowEndWedges::collect(const std::vector<Ring>& outline, const StripGrid& grid, StripRange range,
                           const EndCriterion& criterion) {
  grid_ = &grid;
  range_ = range;
  criterion_ = criterion;
  links_.clear();
  first_.assign(static_cast<std::size_t>(range.size()), -1);
  intricate_.assign(static_cast<std::size_t>(range.size()), 0);
  for (const Ring& ring : outline) walk(ring);
}

void RowEndWedges::add(int strip, const RowEndWedge& end) {
  if (strip < range_.first || strip > range_.last) return;
  int& first = first_[static_cast<std::size_t>(strip - range_.first)];
  links_.push_back({end, first});
  first = static_cast<int>(links_.size()) - 1;
}

void RowEndWedges::mark_intricate(int strip) {
  if (strip >= range_.first && strip <= range_.last)
    intricate_[static_cast<std::size_t>(strip - range_.first)] = 1;
}

void RowEndWedges::walk(const Ring& ring) {
  const StripGrid& grid = *grid_;
  const std::size_t n = ring.size();
  // From a vertex whose edge leaves its strip, so that every passage is walked from its beginning.
  std::size_t start = 0;
  int strip = grid.strip_at(ring[0].x);
  for (; start < n; ++start) {
    const int next = grid.strip_at(ring[start + 1 == n ? 0 : start + 1].x);
    if (next != strip) break;
  }
  if (start == n) return mark_intricate(strip);  // within one strip

  const double width = grid.width_m;
  Passage passage(width, criterion_, true);
  bool begun = false;
  for (std::size_t step = 0; step <= n; ++step) {
    const std::size_t i = start + step < n ? start + step : start + step - n;
    const Point a = ring[i], b = ring[i + 1 == n ? 0 : i + 1];
    const int target = grid.strip_at(b.x);
    Point from = a;
    while (strip != target) {
      const bool right = target > strip;
      const double line = grid.line(right ? strip + 1 : strip), left = grid.line(strip);
      const Point to{line, along_at(a, b, line)};
      if (begun) {
        passage.add(from.x - left, from.y, to.x - left, to.y);
        if (passage.turns_back() || passage.comes_from_left() != right)
          mark_intricate(strip);
        else
          add(strip, passage.end());
      }
      if (step == n) return;  // round
      begun = true;
      strip += right ? 1 : -1;
      passage = Passage(width, criterion_, right);
      from = to;
    }
    if (begun) passage.add(from.x - grid.line(strip), from.y, b.x - grid.line(strip), b.y);
  }
}

RowEndWedges::InStrip RowEndWedges::in_strip(std::size_t index) {
  if (intricate_[index] != 0) return {};
  sorted_.clear();
  for (int i = first_[index]; i >= 0; i = links_[static_cast<std::size_t>(i)].next)
    sorted_.push_back(links_[static_cast<std::size_t>(i)].end);
  std::sort(sorted_.begin(), sorted_.end(),
            [](const RowEndWedge& a, const RowEndWedge& b) { return a.lowest < b.lowest; });
  if (sorted_.size() % 2 != 0) return {};
  for (std::size_t i = 0; i < sorted_.size(); ++i) {
    if (sorted_[i].begins != (i % 2 == 0)) return {};
    if (i > 0 && sorted_[i].lowest < sorted_[i - 1].highest) return {};
  }
  return {true, sorted_.data(), sorted_.data() + sorted_.size()};
}

}  // namespace tramline
