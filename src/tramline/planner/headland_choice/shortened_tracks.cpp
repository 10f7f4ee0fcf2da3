#include "tramline/planner/headland_choice/shortened_tracks.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/headland/path_stretch.h"

namespace tramline {
namespace {

/// Land within a distance of an edge.
struct EdgeStrip {
  Point from, to;
  double depth_m;
};

std::vector<EdgeStrip> strips_of(const Plan& layout, const PassesByBoundary& passes) {
  std::vector<EdgeStrip> out;
  const double width_m = layout.machine.width_m;
  const auto add = [&](const Ring& ring, auto passes_of) {
    for (std::size_t i = 0; i < ring.size(); ++i)
      if (const int n = passes_of(i); n > 0)
        out.push_back({ring[i], ring[(i + 1) % ring.size()], n * width_m});
  };
  add(layout.field.outer, [&](std::size_t i) { return passes.edges[i]; });
  for (std::size_t k = 0; k < layout.field.obstacles.size(); ++k)
    add(layout.field.obstacles[k].shape.outer, [&](std::size_t) { return passes.obstacles[k]; });
  return out;
}

struct Reach {
  double from_m, to_m;
};

void widen(std::optional<Reach>& reach, double from_m, double to_m) {
  if (from_m > to_m) return;
  if (!reach) reach = Reach{from_m, to_m};
  reach->from_m = std::min(reach->from_m, from_m);
  reach->to_m = std::max(reach->to_m, to_m);
}

/// Where `at + s·slope` is between the two bounds, within `within`.
Reach where_between(double at, double slope, double low, double high, Reach within) {
  if (slope == 0) return at >= low && at <= high ? within : Reach{0, -1};
  double from_m = (low - at) / slope, to_m = (high - at) / slope;
  if (from_m > to_m) std::swap(from_m, to_m);
  return {std::max(within.from_m, from_m), std::min(within.to_m, to_m)};
}

/// The part of a line, from its origin, that lies on the strip: the strip is convex, so there is one at most.
std::optional<Reach> part_on(const EdgeStrip& strip, Point origin, Point along) {
  std::optional<Reach> out;
  for (const Point end : {strip.from, strip.to}) {
    const double ahead_m = dot(end - origin, along), off_m = cross(along, end - origin);
    const double half_chord = strip.depth_m * strip.depth_m - off_m * off_m;
    if (half_chord < 0) continue;
    widen(out, ahead_m - std::sqrt(half_chord), ahead_m + std::sqrt(half_chord));
  }
  const double edge_m = distance(strip.from, strip.to);
  if (edge_m == 0) return out;
  const Point edge = (1 / edge_m) * (strip.to - strip.from);
  const double far_m = 2 * (distance(origin, strip.from) + edge_m + strip.depth_m);
  const Reach beside =
      where_between(dot(origin - strip.from, edge), dot(along, edge), 0, edge_m, {-far_m, far_m});
  const Reach near = where_between(cross(edge, origin - strip.from), cross(edge, along), -strip.depth_m,
                                   strip.depth_m, beside);
  widen(out, near.from_m, near.to_m);
  return out;
}

/// What the strips leave of a line of the given length.
std::vector<Reach> free_parts(const std::vector<EdgeStrip>& strips, Point from, Point to) {
  const double length_m = distance(from, to);
  const Point along = (1 / length_m) * (to - from);
  std::vector<Reach> taken;
  for (const EdgeStrip& strip : strips)
    if (const auto part = part_on(strip, from, along); part && part->to_m > 0 && part->from_m < length_m)
      taken.push_back(*part);
  std::sort(taken.begin(), taken.end(), [](const Reach& a, const Reach& b) { return a.from_m < b.from_m; });
  std::vector<Reach> out;
  double free_from_m = 0;
  for (const Reach& part : taken) {
    if (part.from_m > free_from_m) out.push_back({free_from_m, part.from_m});
    free_from_m = std::max(free_from_m, part.to_m);
  }
  if (free_from_m < length_m) out.push_back({free_from_m, length_m});
  return out;
}

class ShortenedTracks {
 public:
  ShortenedTracks(const Plan& layout, const PassesByBoundary& passes)
      : layout_(layout), strips_(strips_of(layout, passes)), shortest_m_(min_length_m(layout.machine)) {}

  std::vector<TrackPiece> run() {
    for (const TrackPiece& piece : layout_.pieces) {
      const std::size_t before = out_.size();
      if (!piece.curve.empty())
        add_curved(piece);
      else if (!piece.detours.empty())
        add_with_detours(piece);
      else
        add_straight(piece);
      // Where the track before the passable obstacle is gone, the machine comes from elsewhere.
      for (std::size_t i = before; i < out_.size(); ++i)
        out_[i].after_crossing = piece.after_crossing && i == before && crossed_from_;
      crossed_from_ = out_.size() > before && out_.back().end == piece.end;
    }
    return std::move(out_);
  }

 private:
  void add_part(const TrackPiece& piece, Point start, Point end) {
    if (distance(start, end) < shortest_m_) return;
    out_.push_back(piece);
    out_.back().start = start;
    out_.back().end = end;
  }

  void add_straight(const TrackPiece& piece) {
    const double length_m = distance(piece.start, piece.end);
    const Point along = (1 / length_m) * (piece.end - piece.start);
    for (const Reach& part : free_parts(strips_, piece.start, piece.end))
      add_part(piece, part.from_m == 0 ? piece.start : piece.start + part.from_m * along,
               part.to_m == length_m ? piece.end : piece.start + part.to_m * along);
  }

  void add_with_detours(const TrackPiece& piece) {
    const Point first = piece.detours.front().path.front().from, last = piece.detours.back().path.back().to;
    Point start = piece.start, end = piece.end;
    if (start != first) {
      const std::vector<Reach> parts = free_parts(strips_, start, first);
      if (!parts.empty()) start = start + parts.back().from_m / distance(start, first) * (first - start);
      if (parts.empty()) start = first;
    }
    if (end != last) {
      const std::vector<Reach> parts = free_parts(strips_, last, end);
      end = parts.empty() ? last : last + parts.front().to_m / distance(last, end) * (end - last);
    }
    add_part(piece, start, end);
  }

  void add_curved(const TrackPiece& piece) {
    const double length_m = length(piece.curve), step_m = 0.25 * layout_.machine.width_m;
    const auto free_at = [&](double along_m) {
      const Point at =
          along_m >= length_m ? piece.end : stretch_of(piece.curve, along_m, length_m).front().from;
      return std::none_of(strips_.begin(), strips_.end(), [&](const EdgeStrip& strip) {
        return distance_to_segment(at, strip.from, strip.to) < strip.depth_m;
      });
    };
    double from_m = 0, to_m = length_m;
    while (from_m < to_m && !free_at(from_m)) from_m += step_m;
    while (to_m > from_m && !free_at(to_m)) to_m -= step_m;
    if (to_m - from_m < shortest_m_) return;
    out_.push_back(piece);
    out_.back().curve = stretch_of(piece.curve, from_m, to_m);
    out_.back().start = out_.back().curve.front().from;
    out_.back().end = out_.back().curve.back().to;
  }

  const Plan& layout_;
  std::vector<EdgeStrip> strips_;
  double shortest_m_;
  std::vector<TrackPiece> out_;
  bool crossed_from_ = false;
};

}  // namespace

std::vector<TrackPiece> shortened_tracks(const Plan& layout, const PassesByBoundary& passes) {
  return ShortenedTracks(layout, passes).run();
}

}  // namespace tramline
