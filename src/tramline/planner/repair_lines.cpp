#include "tramline/planner/repair_lines.h"

#include <algorithm>
#include <deque>
#include <optional>
#include <utility>

#include "tramline/geometry/boolean.h"
#include "tramline/geometry/interior_point.h"

namespace tramline {
namespace {

Region swaths_of(const GapLines& lines) {
  Region out;
  const StripGrid& grid = lines.grid;
  for (const GapLine& line : lines.lines)
    for (const StripPiece& piece : line.pieces) {
      const double left = grid.line(piece.strip), right = grid.line(piece.strip + 1);
      out.push_back({{grid.frame.to_field({left, piece.from}), grid.frame.to_field({right, piece.from}),
                      grid.frame.to_field({right, piece.to}), grid.frame.to_field({left, piece.to})},
                     {}});
    }
  return out;
}

/// The gap that the largest polygon of the region lies in.
int gap_at(const Region& region, const std::vector<Gap>& gaps) {
  const auto largest = std::max_element(region.begin(), region.end(),
                                        [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
  const Point inside = interior_point(*largest);
  for (const Gap& gap : gaps)
    if (contains(gap.shape, inside)) return gap.number;
  return gaps.front().number;
}

/// Ground that waits for lines, left by those of out.grounds[parent].
struct Rest {
  RepairedGround ground;
  std::size_t parent = 0;
};

class RepairLayer {
 public:
  RepairLayer(const RepairGround& ground, const RepairProgress& progress)
      : ground_(ground), progress_(progress) {}

  RepairLines run(std::vector<GapGroup> groups, const std::vector<Gap>& gaps) {
    std::stable_sort(groups.begin(), groups.end(), [](const GapGroup& a, const GapGroup& b) {
      return a.ground.gaps_m2 > b.ground.gaps_m2;
    });
    for (GapGroup& group : groups) {
      const int gap = gap_at(group.ground.gaps, gaps);
      lay(std::move(group), gap);
    }
    while (!open_.empty()) {
      Rest rest = std::move(open_.front());
      open_.pop_front();
      lay_more(std::move(rest));
    }
    return std::move(out_);
  }

 private:
  /// Of the region, what no swath laid so far covers, as far as it counts.
  Region uncovered(const Region& region) const {
    Region near;
    const Box box = bounds(region);
    for (std::size_t i = 0; i < out_.swaths.size(); ++i)
      if (intersects(swath_boxes_[i], box)) near.push_back(out_.swaths[i]);
    return sized(near.empty() ? region : difference(region, unite(near)), ground_.min_area_m2);
  }

  void lay(GapGroup group, int gap) {
    const StripGrid& grid = group.choice.lines.grid;
    RepairedGround job{group.ground.gaps, grid.frame.direction(), {grid, {}, 0, 0}, gap, {}};
    const Region left = uncovered(job.region);
    if (left.empty()) {
      out_.grounds.push_back(std::move(job));
      return;
    }
    if (area(left) < group.ground.gaps_m2 - kNoGround_m2) {
      // Others have covered part of it: what is left may be better worked another way.
      std::optional<GapChoice> other = chosen_lines(ground_of(left, ground_), ground_, GapEffort::kLook);
      if (other) group.choice = std::move(*other);
    }
    take_on(std::move(job), std::move(group.choice.lines), left);
  }

  void lay_more(Rest rest) {
    const Region left = uncovered(rest.ground.region);
    if (left.empty()) return;
    std::optional<GapChoice> choice = lines_whatever_it_takes(ground_of(left, ground_), ground_);
    if (!choice) {
      for (const Polygon& part : left)
        out_.unreachable.push_back({rest.ground.gap, area(part), interior_point(part),
                                    "part of a gap taken on: " + why_unreachable(ground_)});
      return;
    }
    Region& left_by_parent = out_.grounds[rest.parent].left_for_more;
    left_by_parent.insert(left_by_parent.end(), rest.ground.region.begin(), rest.ground.region.end());
    take_on(std::move(rest.ground), std::move(choice->lines), left);
    tell();
  }

  /// `left`: the part of the region that has to be covered yet.
  void take_on(RepairedGround job, GapLines lines, const Region& left) {
    job.direction = lines.grid.frame.direction();
    job.lines = std::move(lines);
    for (Polygon& swath : swaths_of(job.lines)) {
      swath_boxes_.push_back(bounds(swath));
      out_.swaths.push_back(oriented(std::move(swath)));
    }
    for (const Polygon& part : uncovered(left))
      open_.push_back(
          {{{part}, job.direction, {job.lines.grid, {}, 0, 0}, job.gap, {}}, out_.grounds.size()});
    out_.grounds.push_back(std::move(job));
  }

  void tell() const {
    if (!progress_) return;
    progress_(static_cast<int>(out_.grounds.size()), static_cast<int>(out_.grounds.size() + open_.size()));
  }

  const RepairGround& ground_;
  const RepairProgress& progress_;
  std::deque<Rest> open_;
  std::vector<Box> swath_boxes_;
  RepairLines out_;
};

}  // namespace

RepairLines repair_lines(std::vector<GapGroup> groups, const std::vector<Gap>& gaps,
                         const RepairGround& ground, const RepairProgress& progress) {
  return RepairLayer(ground, progress).run(std::move(groups), gaps);
}

}  // namespace tramline
