#include "tramline/render/close_up/close_up_window.h"

#include <algorithm>

#include "tramline/render/page/visible_stretches.h"

namespace tramline::render {
namespace {

constexpr double kMarginWidths = 3;
constexpr double kSagitta = 0.01;

Box overlap_of(const Box& a, const Box& b) {
  return {std::max(a.min_x, b.min_x), std::max(a.min_y, b.min_y), std::min(a.max_x, b.max_x),
          std::min(a.max_y, b.max_y)};
}

Region parts_in(const Region& region, const Box& box) {
  Region out;
  for (const Polygon& polygon : region)
    if (intersects(bounds(polygon), box)) out.push_back(polygon);
  return out;
}

// Headlands run round the field: their own boxes say nothing about what is seen of them.
bool shows(const Box& box, const Path& path) { return !stretches_in(chords(path, kSagitta), box).empty(); }

bool shows(const Box& box, const Polygon& polygon) {
  if (contains(polygon, box.centre())) return true;
  for (Ring ring : rings_of({polygon})) {
    ring.push_back(ring.front());
    if (!stretches_in(ring, box).empty()) return true;
  }
  return false;
}

}  // namespace

bool avoids(const Detour& detour, std::size_t obstacle) {
  return std::binary_search(detour.obstacles.begin(), detour.obstacles.end(), obstacle);
}

Box box_of(const Path& path) {
  Box box;
  for (const Point p : chords(path, kSagitta)) box.extend(p);
  return box;
}

Box close_up_window(const Plan& plan, std::size_t obstacle) {
  const double width_m = plan.machine.width_m;
  const Polygon& shape = plan.field.obstacles[obstacle].shape;
  Box box = bounds(shape).grown(kMarginWidths * width_m);
  for (const TrackPiece& piece : plan.pieces)
    for (const Detour& detour : piece.detours)
      if (avoids(detour, obstacle)) box.extend(box_of(detour.path).grown(width_m));
  return overlap_of(box, drawn_box(plan));
}

Box shown_box(const PageLayout& page) {
  const double half_width = 0.5 * page.map.width() / page.view.px_per_m;
  const double half_height = 0.5 * page.map.height() / page.view.px_per_m;
  const Point middle = page.view.centre_m;
  return {middle.x - half_width, middle.y - half_height, middle.x + half_width, middle.y + half_height};
}

Plan part_in(const Plan& plan, const Box& box) {
  Plan out;
  out.field = plan.field;
  out.machine = plan.machine;
  out.objective = plan.objective;
  out.settings = plan.settings;
  out.subfields = plan.subfields;
  for (Subfield& subfield : out.subfields)
    if (!subfield.reference.empty() && !shows(box, subfield.reference)) subfield.reference.clear();
  const Box reach = box.grown(0.5 * plan.machine.width_m);
  for (const TrackPiece& piece : plan.pieces)
    if (!(piece.start == piece.end) && intersects(box_of(centre_line(piece)), reach))
      out.pieces.push_back(piece);
  for (const DroppedPiece& piece : plan.dropped)
    if (intersects(bounds(piece.start, piece.end), reach)) out.dropped.push_back(piece);
  for (const HeadlandPass& pass : plan.headland.passes)
    if (shows(reach, pass.path)) out.headland.passes.push_back(pass);
  for (const Polygon& polygon : plan.headland.ground)
    if (shows(box, polygon)) out.headland.ground.push_back(polygon);
  out.headland.unworked = parts_in(plan.headland.unworked, box);
  out.given_up = parts_in(plan.given_up, box);
  out.overlap = parts_in(plan.overlap, box);
  out.uncovered = parts_in(plan.uncovered, box);
  return out;
}

}  // namespace tramline::render
