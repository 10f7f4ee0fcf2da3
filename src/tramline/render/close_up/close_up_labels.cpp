#include "tramline/render/close_up/close_up_labels.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include "tramline/render/close_up/close_up_content.h"
#include "tramline/render/close_up/close_up_layers.h"
#include "tramline/render/page/labels.h"
#include "tramline/render/page/text.h"
#include "tramline/render/page/visible_stretches.h"

namespace tramline::render {
namespace {

constexpr double kGap = 6;
constexpr int kPlacesOfNumber = 12;

struct Half {
  double width = 0;
  double height = 0;
};

Half half_size(Canvas& canvas, const std::string& text, const TextStyle& style) {
  return {0.5 * text_width(canvas, text, style) + 2 * canvas.scale(), 0.55 * style.size * canvas.scale()};
}

Box box_round(Point centre, const Half& half) {
  return {centre.x - half.width, centre.y - half.height, centre.x + half.width, centre.y + half.height};
}

bool within(const Box& inner, const Box& outer) {
  return inner.min_x >= outer.min_x && inner.max_x <= outer.max_x && inner.min_y >= outer.min_y &&
         inner.max_y <= outer.max_y;
}

bool meets(const Box& box, const Polygon& shape) {
  if (contains(shape, box.centre())) return true;
  for (const Ring& ring : rings_of({shape}))
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (clipped(ring[i], ring[(i + 1) % ring.size()], box)) return true;
  return false;
}

// The obstacles in view, on the page: no label may hide one.
class Obstacles {
 public:
  Obstacles(const Canvas& canvas, const Plan& near, const Box& map) : margin_(3 * canvas.scale()) {
    for (const Obstacle& obstacle : near.field.obstacles) {
      if (obstacle.kind != ObstacleKind::kObstacle) continue;
      Polygon shape = on_page(obstacle.shape, canvas.view());
      const Box box = bounds(shape);
      if (intersects(box, map)) shapes_.emplace_back(box, std::move(shape));
    }
  }
  bool meet(const Box& label) const {
    const Box kept_free = label.grown(margin_);
    return std::any_of(shapes_.begin(), shapes_.end(), [&](const auto& shape) {
      return intersects(kept_free, shape.first) && meets(kept_free, shape.second);
    });
  }

 private:
  static Polygon on_page(Polygon shape, const MapView& view) {
    for (Point& p : shape.outer) p = view.to_page(p);
    for (Ring& hole : shape.holes)
      for (Point& p : hole) p = view.to_page(p);
    return shape;
  }
  double margin_;
  std::vector<std::pair<Box, Polygon>> shapes_;
};

bool is_free(const Box& box, const Box& map, const std::vector<Box>& occupied) {
  return within(box, map) && std::none_of(occupied.begin(), occupied.end(),
                                          [&](const Box& other) { return intersects(box, other); });
}

void write_at(Canvas& canvas, Point place, const Half& half, const std::string& text, const TextStyle& style,
              std::vector<Box>& occupied) {
  occupied.push_back(box_round(place, half));
  draw_text(canvas, place, text, style);
}

// Writes the text at the first of the places where it has room and hides no obstacle.
bool write_at_first(Canvas& canvas, const std::vector<Point>& places, const std::string& text,
                    const TextStyle& style, const Box& map, const Obstacles& obstacles,
                    std::vector<Box>& occupied) {
  const Half half = half_size(canvas, text, style);
  for (const Point place : places) {
    const Box box = box_round(place, half);
    if (!is_free(box, map, occupied) || obstacles.meet(box)) continue;
    write_at(canvas, place, half, text, style, occupied);
    return true;
  }
  return false;
}

// Round a point, nearest first, and at the same distance first above and to the right of it.
std::vector<Point> places_round(Point centre, const Half& half, double scale) {
  constexpr double kStep = 3, kFarthest = 150;
  std::vector<Point> out;
  for (double away = kStep * scale; away <= kFarthest * scale; away += kStep * scale)
    for (const auto& [x, y] : {std::pair{1, -1}, {-1, -1}, {-1, 1}, {1, 1}, {0, -1}, {1, 0}, {0, 1}, {-1, 0}})
      out.push_back(centre + Point{x * (half.width + away), y * (half.height + away)});
  return out;
}

// Along the radius from the arc inwards, then beside it, and the same outside the arc.
std::vector<Point> places_along(Point hub, Point rim, double step) {
  const double reach = distance(hub, rim);
  if (reach == 0) return {rim};
  const Point inwards = (1 / reach) * (hub - rim);
  const Point aside{-inwards.y, inwards.x};
  std::vector<Point> out;
  const auto add = [&](std::initializer_list<double> shares) {
    for (const double sideways : {0.0, 1.0, -1.0, 2.0, -2.0, 4.0, -4.0})
      for (const double share : shares)
        out.push_back(rim + (share * std::min(reach, 12 * step)) * inwards + (sideways * step) * aside);
  };
  add({0.5, 0.35, 0.65, 0.8, 1.15});
  add({-0.2, -0.35, -0.5, -0.8, -1.15});
  return out;
}

bool left_or_above(Point a, Point b) { return std::abs(a.x - b.x) > 1 ? a.x < b.x : a.y < b.y; }

// Where the number of a track may stand, from best to worst: at the left or upper edge of the map, at
// the other one, at an end that lies within the map.
enum class Entry { kFirstEdge, kSecondEdge, kInside };

struct NumberPlaces {
  Entry entry = Entry::kInside;
  std::vector<Point> centres;
};

// What the number goes by: the line from end to end, past all detours, or the curve; from the left or above.
std::vector<Point> line_on_page(const Canvas& canvas, const TrackPiece& piece) {
  std::vector<Point> out{piece.start, piece.end};
  if (!piece.curve.empty()) out = chords(piece.curve, sagitta_m(canvas.view()));
  for (Point& p : out) p = canvas.view().to_page(p);
  if (!left_or_above(out.front(), out.back())) std::reverse(out.begin(), out.end());
  return out;
}

std::optional<NumberPlaces> places_of_number(Canvas& canvas, const TrackPiece& piece, const Half& half,
                                             const Box& map) {
  const std::vector<Point> line = line_on_page(canvas, piece);
  const auto stretches = stretches_in(line, map);
  if (stretches.empty()) return std::nullopt;
  const Entry entry = !(stretches.front().front() == line.front()) ? Entry::kFirstEdge
                      : !(stretches.back().back() == line.back())  ? Entry::kSecondEdge
                                                                   : Entry::kInside;
  std::vector<Point> inwards = entry == Entry::kSecondEdge ? stretches.back() : stretches.front();
  if (entry == Entry::kSecondEdge) std::reverse(inwards.begin(), inwards.end());
  const Point along = point_along(inwards, 0).along;
  // As far in as the text needs beside a vertical edge of the map, or below a horizontal one; then farther
  // in, where something is in the way there.
  NumberPlaces out{entry, {}};
  for (const double reach :
       {half.width / std::max(std::abs(along.x), 1e-9), half.height / std::max(std::abs(along.y), 1e-9)}) {
    const double step = 2 * half.height, most = length_of(inwards);
    double run = reach + kGap * canvas.scale();
    for (int i = 0; i < kPlacesOfNumber && run < most; ++i, run += step)
      out.centres.push_back(point_along(inwards, run).at);
  }
  return out;
}

}  // namespace

void draw_obstacle_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& occupied) {
  const double k = canvas.scale();
  const TextStyle style{kTextSize, true, Align::kCentre, kInk, true};
  const Obstacles obstacles(canvas, near, map);
  for (std::size_t i = 0; i < near.field.obstacles.size(); ++i) {
    const Polygon& shape = near.field.obstacles[i].shape;
    const std::string text = std::to_string(i + 1);
    const Half half = half_size(canvas, text, style);
    const RoomyPoint inside = roomiest_point(shape, canvas.view());
    const bool roomy = inside.room_px > std::max(half.width, half.height) + 2 * k;
    if (roomy && is_free(box_round(inside.centre, half), map, occupied))
      write_at(canvas, inside.centre, half, text, style, occupied);
    else
      write_at_first(canvas, places_round(inside.centre, half, k), text, style, map, obstacles, occupied);
  }
}

void draw_radii(Canvas& canvas, const Plan& near, std::size_t obstacle, const Box& map,
                std::vector<Box>& occupied) {
  const TextStyle style{kSmallTextSize, true, Align::kCentre, kDetourColour, true};
  const Obstacles obstacles(canvas, near, map);
  for (const PathSegment& arc : tightest_arcs(near, obstacle)) {
    const std::string text = fmt::format("r {:.2f} m", radius(arc));
    const Point hub = canvas.view().to_page(centre(arc));
    const Point rim = canvas.view().to_page(middle_of_arc(arc));
    const double step = half_size(canvas, text, style).height * 2;
    write_at_first(canvas, places_along(hub, rim, step), text, style, map, obstacles, occupied);
  }
}

void draw_strip_numbers(Canvas& canvas, const Plan& near, const Box& map, std::vector<Box>& occupied) {
  const TextStyle style{kSmallTextSize, false, Align::kCentre, kInk, true};
  const Obstacles obstacles(canvas, near, map);
  std::set<std::pair<int, int>> numbered;
  for (const Entry entry : {Entry::kFirstEdge, Entry::kSecondEdge, Entry::kInside}) {
    for (const TrackPiece& piece : near.pieces) {
      const std::pair strip{piece.subfield, piece.track};
      if (numbered.count(strip) > 0) continue;
      const std::string text = strip_name(near, piece.subfield, piece.track);
      const auto places = places_of_number(canvas, piece, half_size(canvas, text, style), map);
      if (!places || places->entry != entry) continue;
      if (write_at_first(canvas, places->centres, text, style, map, obstacles, occupied))
        numbered.insert(strip);
    }
  }
}

}  // namespace tramline::render
