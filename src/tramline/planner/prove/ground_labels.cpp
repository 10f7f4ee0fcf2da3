#include "tramline/planner/prove/ground_labels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "tramline/geometry/strip/cross_section.h"

namespace tramline {
namespace {

constexpr std::uint8_t kLandBit = 1, kPassableBit = 2;

PriceGrid grid_of(const Region& turned, const Box& box, Direction along, double side_m) {
  PriceGrid out;
  out.frame = TrackFrame(along);
  out.side_m = side_m;
  out.columns = std::max(1, static_cast<int>(std::ceil(box.width() / side_m)));
  out.rows = std::max(1, static_cast<int>(std::ceil(box.height() / side_m)));
  // The same amount beyond either side.
  out.corner = box.centre() - Point{0.5 * out.columns * side_m, 0.5 * out.rows * side_m};
  const StripGrid strips{TrackFrame(), out.corner.x, side_m};
  const std::vector<StripProfile> profiles = cross_sections(turned, strips, {0, out.columns - 1});
  out.index.assign(static_cast<std::size_t>(out.columns) * static_cast<std::size_t>(out.rows), -1);
  for (int column = 0; column < out.columns; ++column)
    for (int row = 0; row < out.rows; ++row) {
      const double low = out.corner.y + row * side_m;
      const double inside_m2 = area_between(profiles[static_cast<std::size_t>(column)], low, low + side_m);
      if (!(inside_m2 > 0)) continue;
      out.index[out.place(column, row)] = static_cast<int>(out.cells.size());
      out.cells.push_back({column, row, inside_m2});
    }
  return out;
}

/// The pixels, of one metre, whose centre is within the region, and all that its edges run through.
class PixelMarker {
 public:
  PixelMarker(int columns, int rows, std::vector<std::uint8_t>& pixels, std::uint8_t bit)
      : columns_(columns), rows_(rows), pixels_(pixels), bit_(bit) {}

  void fill(const std::vector<Ring>& rings) {
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(columns_));
    for (const Ring& ring : rings) {
      Point from = ring.back();
      for (const Point to : ring) {
        mark_edge(from, to);
        add_crossings(from, to, crossings);
        from = to;
      }
    }
    for (int x = 0; x < columns_; ++x) {
      std::vector<double>& ys = crossings[static_cast<std::size_t>(x)];
      std::sort(ys.begin(), ys.end());
      for (std::size_t i = 0; i + 1 < ys.size(); i += 2) set(x, ys[i], ys[i + 1]);
    }
  }

 private:
  void set(int x, double from, double to) {
    if (x < 0 || x >= columns_) return;
    const int low = std::max(0, static_cast<int>(std::floor(from)));
    const int high = std::min(rows_ - 1, static_cast<int>(std::floor(to)));
    for (int y = low; y <= high; ++y)
      pixels_[static_cast<std::size_t>(x) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(y)] |=
          bit_;
  }

  void mark_edge(Point a, Point b) {
    constexpr double kRounding = 1e-6;  // of a pixel
    if (b.x < a.x) std::swap(a, b);
    const double slope = b.x > a.x ? (b.y - a.y) / (b.x - a.x) : 0;
    const int first = static_cast<int>(std::floor(a.x - kRounding));
    const int last = static_cast<int>(std::floor(b.x + kRounding));
    for (int x = first; x <= last; ++x) {
      const double left = std::clamp(static_cast<double>(x), a.x, b.x),
                   right = std::clamp(static_cast<double>(x + 1), a.x, b.x);
      double y0 = a.y + slope * (left - a.x), y1 = a.y + slope * (right - a.x);
      if (b.x - a.x < kRounding) y0 = a.y, y1 = b.y;
      set(x, std::min(y0, y1) - kRounding, std::max(y0, y1) + kRounding);
    }
  }

  void add_crossings(Point a, Point b, std::vector<std::vector<double>>& out) const {
    if (b.x < a.x) std::swap(a, b);
    const int first = std::max(0, static_cast<int>(std::ceil(a.x - 0.5)));
    for (int x = first; x < columns_ && x + 0.5 < b.x; ++x)
      out[static_cast<std::size_t>(x)].push_back(a.y + (b.y - a.y) * (x + 0.5 - a.x) / (b.x - a.x));
  }

  int columns_, rows_;
  std::vector<std::uint8_t>& pixels_;
  std::uint8_t bit_;
};

/// Offsets of pixels any part of which may be within the reach, in pixels, of any part of the one at 0.
std::vector<std::pair<int, int>> neighbourhood(double reach) {
  std::vector<std::pair<int, int>> out;
  const int most = static_cast<int>(std::floor(reach)) + 1;
  for (int x = -most; x <= most; ++x)
    for (int y = -most; y <= most; ++y) {
      const double dx = std::max(0, std::abs(x) - 1), dy = std::max(0, std::abs(y) - 1);
      if (std::hypot(dx, dy) <= reach) out.emplace_back(x, y);
    }
  return out;
}

}  // namespace

PriceGrid price_grid(const Region& land, const Region& ground, Direction along, int most, double least_m) {
  const TrackFrame frame(along);
  const Region turned = frame.to_track(land);
  const Box box = bounds(frame.to_track(ground));
  constexpr double kStep = 1.02;
  double side_m = std::max(least_m, std::sqrt(area(land) / most));
  for (;;) {
    PriceGrid out = grid_of(turned, box, along, side_m);
    if (static_cast<int>(out.cells.size()) <= most) return out;
    side_m *= kStep;
  }
}

GroundLabels::GroundLabels(const PriceGrid& grid, const Region& land, const Region& passable, double reach_m,
                           double pixel_m) {
  const int by_side = std::max(1, static_cast<int>(std::ceil(grid.side_m / pixel_m)));
  per_m_ = by_side / grid.side_m;
  const int margin = static_cast<int>(std::ceil(reach_m * per_m_)) + 2;
  corner_ = grid.corner - Point{margin / per_m_, margin / per_m_};
  columns_ = grid.columns * by_side + 2 * margin;
  rows_ = grid.rows * by_side + 2 * margin;
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), 0);
  mark(land, pixels, kLandBit);
  mark(passable, pixels, kPassableBit);
  gather(grid, pixels, reach_m, margin, by_side);
}

void GroundLabels::mark(const Region& region, std::vector<std::uint8_t>& pixels, std::uint8_t bit) const {
  std::vector<Ring> rings = rings_of(region);
  if (rings.empty()) return;
  for (Ring& ring : rings)
    for (Point& p : ring) p = per_m_ * (p - corner_);
  PixelMarker(columns_, rows_, pixels, bit).fill(rings);
}

void GroundLabels::gather(const PriceGrid& grid, const std::vector<std::uint8_t>& pixels, double reach_m,
                          int margin, int by_side) {
  const auto label = [&](int x, int y) {
    const int column = std::clamp((x - margin) / by_side, 0, grid.columns - 1);
    const int row = std::clamp((y - margin) / by_side, 0, grid.rows - 1);
    return grid.index[grid.place(column, row)];
  };
  const std::vector<std::pair<int, int>> near = neighbourhood(reach_m * per_m_);
  std::map<std::vector<int>, std::int32_t> known;
  labels_of_.assign(1, {});
  known[{}] = 0;
  sets_.assign(pixels.size(), 0);
  std::vector<int> found, last;
  std::int32_t last_set = 0;
  for (int x = 0; x < columns_; ++x)
    for (int y = 0; y < rows_; ++y) {
      found.clear();
      const auto add = [&](int which) {
        if (std::find(found.begin(), found.end(), which) == found.end()) found.push_back(which);
      };
      for (const auto& [dx, dy] : near) {
        const int a = x + dx, b = y + dy;
        if (a < 0 || b < 0 || a >= columns_ || b >= rows_) continue;
        const std::uint8_t bits = pixels[static_cast<std::size_t>(a) * static_cast<std::size_t>(rows_) +
                                         static_cast<std::size_t>(b)];
        if ((bits & kPassableBit) != 0) add(kPassable);
        // Land that is too little for a cell has no price.
        if ((bits & kLandBit) != 0) add(label(a, b) < 0 ? kPassable : label(a, b));
      }
      std::sort(found.begin(), found.end());
      if (found != last) {
        const auto [place, fresh] = known.try_emplace(found, static_cast<std::int32_t>(labels_of_.size()));
        if (fresh) labels_of_.push_back(found);
        last_set = place->second;
        last = found;
      }
      sets_[static_cast<std::size_t>(x) * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(y)] =
          last_set;
    }
}

PixelWorth GroundLabels::worth(const std::vector<double>& prices, double overlap) const {
  PixelWorth out;
  for (const std::vector<int>& labels : labels_of_) {
    double most = -overlap;
    int from = kOutside;
    for (const int label : labels) {
      const double price = label == kPassable ? 0 : prices[static_cast<std::size_t>(label)];
      if (from != kOutside && price <= most) continue;
      most = std::max(most, price);
      from = label;
    }
    out.worth.push_back(most);
    out.label.push_back(from);
  }
  return out;
}

}  // namespace tramline
