#pragma once
// The boundary of a region folded into the strips of a grid.

#include <span>
#include <vector>

#include "tramline/geometry/strip/cross_section.h"

namespace tramline {

/// Items by strip, all in one array.
template <class Item>
class ByStrip {
 public:
  void clear(std::size_t strips) {
    items_.clear();
    starts_.assign(strips + 1, 0);
  }
  void add(std::size_t strip, const Item& item) {
    items_.push_back({strip, item});
    ++starts_[strip + 1];
  }
  /// Sorts the items by strip, keeping the order within each. To be called before in().
  void sort_in() {
    for (std::size_t i = 1; i < starts_.size(); ++i) starts_[i] += starts_[i - 1];
    sorted_.resize(items_.size());
    next_slots_.assign(starts_.begin(), starts_.end());
    for (const Placed& placed : items_) sorted_[next_slots_[placed.strip]++] = placed.item;
  }
  std::span<Item> in(std::size_t strip) {
    return std::span(sorted_).subspan(starts_[strip], starts_[strip + 1] - starts_[strip]);
  }

 private:
  struct Placed {
    std::size_t strip;
    Item item;
  };
  std::vector<Placed> items_;
  std::vector<Item> sorted_;
  std::vector<std::size_t> starts_, next_slots_;
};

/// Makes profiles strip by strip. Kept from one fold to the next to reuse its memory.
class StripFold {
 public:
  /// `rings` in the grid's turned plane, outer ones counter-clockwise, holes clockwise. Keeps no reference to
  /// them. O(n + K) for n edges and K incidences of edges and strips that are wanted.
  void fold(std::span<const Ring> rings, const StripGrid& grid, StripRange range, const StripMask& wanted);
  /// The same for the rings of a region.
  void fold(std::span<const Polygon> turned, const StripGrid& grid, StripRange range,
            const StripMask& wanted);
  /// The profile of the strip range.first + index; valid until the next call. O(K log K) for its K edges.
  const StripProfile& profile(std::size_t index);

 private:
  /// The part of a boundary edge within one strip, bottom up. x is measured from the strip's left line.
  struct EdgePart {
    double bottom, top;
    double x_bottom, x_top;
    double sign;  ///< +1 where the edge runs up: the region lies left of it

    double across_at(double along) const;
  };
  /// A crossing of the boundary with a line along the strips: the region begins (+1) or ends (−1) there.
  struct Crossing {
    double along;
    int change;
  };

  /// An end of an edge, and the strip it lies in.
  struct Corner {
    Point at;
    int strip;
  };

  void begin(const StripGrid& grid, StripRange range, const StripMask& wanted);
  void add_ring(const Ring& ring, const StripGrid& grid, StripRange range);
  void end();
  void add(const Corner& a, const Corner& b, const StripGrid& grid, StripRange range);
  void add_part(std::size_t index, Point from, Point to, bool rightward, double line);
  void list_events(std::span<const EdgePart> parts, std::span<const Crossing> right_line);
  void find_slabs(std::span<EdgePart> parts, std::span<Crossing> right_line);
  void find_centre_line(std::span<Crossing> crossings);

  double width_m_ = 1;
  std::vector<int> next_wanted_;  ///< by index: the index of the first wanted strip from there on
  ByStrip<EdgePart> parts_;
  ByStrip<Crossing> right_lines_, centre_lines_;
  std::vector<double> events_;
  std::vector<EdgePart> active_;
  StripProfile profile_;
};

}  // namespace tramline
