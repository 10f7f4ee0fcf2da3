#include "tramline/planner/repair/repair_ground.h"

#include <algorithm>
#include <utility>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/body.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

Region all_oriented(Region region) {
  for (Polygon& polygon : region) polygon = oriented(std::move(polygon));
  return region;
}

Region swaths_of(const GapLine& line, const StripGrid& grid) {
  Region out;
  const double left = grid.line(0), right = grid.line(1);
  for (const LaidPiece& piece : line.pieces)
    out.push_back(
        oriented({{grid.frame.to_field({left, piece.from}), grid.frame.to_field({right, piece.from}),
                   grid.frame.to_field({right, piece.to}), grid.frame.to_field({left, piece.to})},
                  {}}));
  return out;
}

Region obstacles_of(const Field& field) {
  Region out = obstacle_shapes(field, ObstacleKind::kObstacle);
  for (Polygon& strip : obstacle_shapes(field, ObstacleKind::kPassable)) out.push_back(std::move(strip));
  return all_oriented(std::move(out));
}

}  // namespace

RepairGround::RepairGround(const Field& field, const std::vector<Gap>& gaps, DrivenDirections directions,
                           RepairTerms terms)
    : terms_(std::move(terms)), free_(all_oriented(body_of(field))) {
  for (const Gap& gap : gaps) {
    shapes_.push_back(oriented(gap.shape));
    boxes_.push_back(bounds(gap.shape));
    open_.push_back({shapes_.back()});
  }
  const Region obstacles = obstacles_of(field);
  for (std::size_t d = 0; d < directions.directions.size(); ++d) {
    Turned turned{TrackFrame(directions.directions[d]), {}, {}, {}, {}, {}};
    for (std::size_t i = 0; i < gaps.size(); ++i) {
      const std::vector<std::size_t>& of_gap = directions.of_gaps[i];
      if (std::find(of_gap.begin(), of_gap.end(), d) != of_gap.end()) turned.gaps.push_back(i);
    }
    turned.open.resize(turned.gaps.size());
    turned.boxes.resize(turned.gaps.size());
    for (std::size_t k = 0; k < turned.gaps.size(); ++k) turn(turned, k);
    turned.free = turned.frame.to_track(free_);
    turned.obstacles = turned.frame.to_track(obstacles);
    turned_.push_back(std::move(turned));
  }
}

void RepairGround::turn(Turned& turned, std::size_t k) const {
  turned.open[k] = turned.frame.to_track(open_[turned.gaps[k]]);
  turned.boxes[k] = bounds(turned.open[k]);
}

double RepairGround::open_m2() const {
  double sum = 0;
  for (const Region& region : open_) sum += area(region);
  return sum;
}

std::vector<RepairLine> RepairGround::lines_at(const LinePosition& position) const {
  const Turned& turned = turned_[position.direction];
  const double right_m = position.left_m + terms_.machine.width_m;
  Region gaps;
  for (std::size_t k = 0; k < turned.gaps.size(); ++k)
    if (turned.boxes[k].min_x < right_m && turned.boxes[k].max_x > position.left_m)
      gaps.insert(gaps.end(), turned.open[k].begin(), turned.open[k].end());
  return lines_at(position, gaps, terms_.end_rule, WantedPieces::kWorthDriving);
}

std::vector<RepairLine> RepairGround::lines_at(const LinePosition& position, std::size_t gap) const {
  return lines_at(position, turned_[position.direction].frame.to_track(open_[gap]), terms_.end_rule,
                  WantedPieces::kWorthDriving);
}

std::vector<RepairLine> RepairGround::lines_over(std::size_t gap, const LinePosition& position,
                                                 EndRule end_rule) const {
  return lines_at(position, turned_[position.direction].frame.to_track(Region{shapes_[gap]}), end_rule,
                  WantedPieces::kAll);
}

std::vector<RepairLine> RepairGround::lines_at(const LinePosition& position, const Region& turned_gaps,
                                               EndRule end_rule, WantedPieces wanted) const {
  if (turned_gaps.empty()) return {};
  const Turned& turned = turned_[position.direction];
  const StripGrid grid{turned.frame, position.left_m, terms_.machine.width_m};
  constexpr StripRange kOne{0, 0};
  Track strip;
  strip.subfield = TrackProfile(cross_sections(turned_gaps, grid, kOne).front());
  if (strip.subfield.empty()) return {};
  strip.hard = TrackProfile(cross_sections(turned.obstacles, grid, kOne).front());
  const Intervals open = where_at_least(cross_sections(turned.free, grid, kOne).front(),
                                        terms_.machine.width_m - kWidthTolerance);
  std::vector<RepairLine> out;
  RepairTerms terms = terms_;
  terms.end_rule = end_rule;
  for (GapLine& line : lines_on(strip, open, terms, wanted)) {
    RepairLine found{position, std::move(line), {}, 0};
    found.worth = worth_of(found.line, found.line.covered_m2, terms_);
    found.swaths = swaths_of(found.line, grid);
    out.push_back(std::move(found));
  }
  return out;
}

void RepairGround::cover(const std::vector<RepairLine>& lines, const Region& changed) {
  const Box near = bounds(changed);
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    if (!intersects(boxes_[i], near)) continue;
    const bool meets = std::any_of(changed.begin(), changed.end(), [&](const Polygon& swath) {
      return intersects(bounds(swath), boxes_[i]);
    });
    if (!meets) continue;
    Region swaths;
    for (const RepairLine& line : lines)
      for (const Polygon& swath : line.swaths)
        if (intersects(bounds(swath), boxes_[i])) swaths.push_back(swath);
    open_[i] = {shapes_[i]};
    if (!swaths.empty()) open_[i] = all_oriented(difference(open_[i], unite(swaths)));
    std::erase_if(open_[i], [](const Polygon& polygon) { return area(polygon) < kNoGround_m2; });
    for (Turned& turned : turned_) {
      const auto found = std::lower_bound(turned.gaps.begin(), turned.gaps.end(), i);
      if (found != turned.gaps.end() && *found == i)
        turn(turned, static_cast<std::size_t>(found - turned.gaps.begin()));
    }
  }
}

}  // namespace tramline
