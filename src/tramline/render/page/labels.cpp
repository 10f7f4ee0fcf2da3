#include "tramline/render/page/labels.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "tramline/geometry/polygon/interior_point.h"
#include "tramline/geometry/polygon/outline_distance.h"
#include "tramline/render/page/map_symbols.h"
#include "tramline/render/page/page_headings.h"
#include "tramline/render/page/text.h"

namespace tramline::render {
namespace {

constexpr double kDigitWidth = 0.637;  // of the size, DejaVu Sans
constexpr double kLabelGap = 5;
constexpr double kTrackBadgeRadius = 14;
constexpr double kLongestArrow = 130;
constexpr int kBadgeGrid = 28;
// Share of labels that may find no room before the next stride is tried.
constexpr double kToleratedMisses = 0.04;

// Just behind the start of the piece, so that the label does not hide the track's own end.
std::optional<TrackLabel> label_at_start(const TrackPiece& piece, std::size_t number, const MapView& view,
                                         double scale) {
  if (piece.start == piece.end) return std::nullopt;
  const std::string text = std::to_string(number);
  const double half_width = 0.5 * kDigitWidth * kSmallTextSize * scale * static_cast<double>(text.size());
  const double half_height = 0.42 * kSmallTextSize * scale;
  const Point heading = heading_at_start(piece);
  const double reach =
      std::abs(heading.x) * half_width + std::abs(heading.y) * half_height + kLabelGap * scale;
  const Point centre = view.to_page(piece.start) - reach * heading;
  const double rim = 1.5 * scale;
  return TrackLabel{text,
                    centre,
                    {centre.x - half_width - rim, centre.y - half_height - rim, centre.x + half_width + rim,
                     centre.y + half_height + rim}};
}

bool meets_any(const Box& box, const std::vector<Box>& occupied) {
  return std::any_of(occupied.begin(), occupied.end(),
                     [&](const Box& other) { return intersects(box, other); });
}

struct Attempt {
  std::vector<TrackLabel> labels;
  bool good = false;
};

Attempt label_every(std::size_t stride, const Plan& plan, const MapView& view, double scale,
                    std::vector<Box> occupied) {
  Attempt attempt;
  const std::size_t wanted = plan.pieces.size() / stride + 1;
  const auto tolerated = static_cast<std::size_t>(kToleratedMisses * static_cast<double>(wanted));
  std::size_t misses = 0;
  for (std::size_t number = 1; number <= plan.pieces.size(); ++number) {
    if (number % stride != 0 && number != 1) continue;
    const auto label = label_at_start(plan.pieces[number - 1], number, view, scale);
    if (!label) continue;
    if (meets_any(label->box, occupied)) {
      // Number 1 is an extra where the stride is larger, and so is not missed.
      if (number % stride == 0 && ++misses > tolerated) return attempt;
      continue;
    }
    occupied.push_back(label->box);
    attempt.labels.push_back(*label);
  }
  attempt.good = true;
  return attempt;
}

}  // namespace

// The roomiest of a grid of places; any inside where the polygon slips through the grid.
RoomyPoint roomiest_point(const Polygon& polygon, const MapView& view) {
  assert(polygon.outer.size() >= 3);
  const Box box = bounds(polygon);
  RoomyPoint best{view.to_page(interior_point(polygon)), 0};
  for (int row = 0; row < kBadgeGrid; ++row) {
    for (int column = 0; column < kBadgeGrid; ++column) {
      const Point p{box.min_x + (column + 0.5) / kBadgeGrid * box.width(),
                    box.min_y + (row + 0.5) / kBadgeGrid * box.height()};
      if (!contains(polygon, p)) continue;
      const double room = distance_to_outline(p, polygon) * view.px_per_m;
      // A clear gain only: of nearly equal places the first is taken, whatever the rounding.
      if (room > best.room_px * (1 + 1e-9)) best = {view.to_page(p), room};
    }
  }
  return best;
}

std::vector<SubfieldBadge> place_badges(const Plan& plan, const MapView& view, double scale) {
  std::vector<SubfieldBadge> out;
  for (std::size_t i = 0; i < plan.subfields.size(); ++i) {
    const RoomyPoint place = roomiest_point(plan.subfields[i].shape, view);
    if (place.room_px >= 0.6 * kTrackBadgeRadius * scale) out.push_back({i, place.centre, place.room_px});
  }
  return out;
}

std::vector<Box> boxes_of(const std::vector<SubfieldBadge>& badges, double scale) {
  std::vector<Box> out;
  for (const SubfieldBadge& badge : badges)
    out.push_back(
        Box{badge.centre.x, badge.centre.y, badge.centre.x, badge.centre.y}.grown(kTrackBadgeRadius * scale));
  return out;
}

std::vector<TrackLabel> place_track_labels(const Plan& plan, const MapView& view, double scale,
                                           const std::vector<Box>& occupied) {
  for (std::size_t decade = 1;; decade *= 10) {
    for (const std::size_t step : {1, 2, 5}) {
      const std::size_t stride = decade * step;
      Attempt attempt = label_every(stride, plan, view, scale, occupied);
      if (attempt.good || stride > plan.pieces.size()) return attempt.labels;
    }
  }
}

void draw_badges(Canvas& canvas, const Plan& plan, const std::vector<SubfieldBadge>& badges) {
  const double k = canvas.scale();
  const double r = kTrackBadgeRadius * k;
  const std::vector<int> curved = curved_tracks_by_subfield(plan);
  for (const SubfieldBadge& badge : badges) {
    const Point axis = plan.subfields[badge.subfield].direction.unit();
    const Point along{axis.x, -axis.y};
    const double reach = std::min(0.5 * kLongestArrow * k, badge.room_px);
    // A straight arrow would cross tracks that bend.
    const bool arrow = std::isfinite(along.x) && reach > 2 * r && curved[badge.subfield] == 0;
    if (arrow) {
      const Point a = badge.centre - reach * along;
      const Point b = badge.centre + reach * along;
      stroke_line(canvas, {a, b}, {rgb(kBackgroundHex, 0.85), 7 * k});
      stroke_line(canvas, {a + (6 * k) * along, b - (6 * k) * along}, {kInk, 2.4 * k});
      draw_arrow_head(canvas, b, along, 14 * k, kInk);
      draw_arrow_head(canvas, a, -1 * along, 14 * k, kInk);
    }
    disc(canvas, badge.centre, r, kInk);
    disc(canvas, badge.centre, r - 2 * k, tint(badge.subfield));
    draw_text(canvas, badge.centre, std::to_string(badge.subfield + 1), {kTextSize, true, Align::kCentre});
  }
}

void draw_track_labels(Canvas& canvas, const std::vector<TrackLabel>& labels) {
  for (const TrackLabel& label : labels)
    draw_text(canvas, label.centre, label.text, {kSmallTextSize, false, Align::kCentre, kInk, true});
}

}  // namespace tramline::render
