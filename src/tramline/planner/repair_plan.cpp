#include "tramline/planner/repair_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <deque>
#include <limits>
#include <optional>
#include <utility>

#include "tramline/cost/piece_overlap.h"
#include "tramline/cost/worked_regions.h"
#include "tramline/geometry/boolean.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/interior_point.h"
#include "tramline/headland/body.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/join_gaps.h"
#include "tramline/planner/line_order.h"
#include "tramline/planner/pulse.h"
#include "tramline/planner/warnings.h"
#include "tramline/tracks/end_rule.h"

namespace tramline {
namespace {

/// Smaller polygons are what the precision grid makes of two edges that should be one, m².
constexpr double kNoGround_m2 = 1e-4;

/// Ground with the lines that were laid for it, and what of it was left for others.
struct Job {
  Region region;
  Direction direction;
  GapLines lines;
  int gap = 0;           ///< the number of the largest gap in it
  Region left_for_more;  ///< regions of later jobs
};

Region sized(Region region, double least_m2) {
  std::erase_if(region, [&](const Polygon& polygon) { return area(polygon) < least_m2; });
  return region;
}

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

class RepairMaker {
 public:
  RepairMaker(const Field& field, const std::vector<Gap>& gaps, const RepairTerms& terms, double min_area_m2,
              int threads, const RepairProgress& progress)
      : field_(field),
        terms_(terms),
        min_area_m2_(min_area_m2),
        threads_(threads),
        progress_(progress),
        free_(body_of(field)),
        obstacles_(obstacle_shapes(field, ObstacleKind::kObstacle)) {
    for (const Region& passable : {obstacle_shapes(field, ObstacleKind::kPassable)})
      obstacles_.insert(obstacles_.end(), passable.begin(), passable.end());
    for (Polygon& polygon : free_) polygon = oriented(std::move(polygon));
    sort_out(gaps);
  }

  RepairPlan run(const Region& missed) {
    std::vector<GapGroup> groups = groups_of_one();
    require_any(groups);
    groups = join_where_it_pays(std::move(groups), free_, obstacles_, terms_, threads_);
    std::stable_sort(groups.begin(), groups.end(), [](const GapGroup& a, const GapGroup& b) {
      return a.ground.gaps_m2 > b.ground.gaps_m2;
    });
    for (GapGroup& group : groups) lay(std::move(group));
    while (!open_.empty()) {
      Job job = std::move(open_.front());
      open_.pop_front();
      lay_more(std::move(job));
    }
    finish(missed);
    return std::move(out_);
  }

 private:
  void sort_out(const std::vector<Gap>& gaps) {
    out_.gaps = static_cast<int>(gaps.size());
    for (const Gap& gap : gaps) {
      if (gap.area_m2 >= min_area_m2_)
        gaps_.push_back(gap);
      else
        out_.ignored.push_back({gap.number, gap.area_m2, gap.centre,
                                fmt::format("smaller than the least area of {:g} m²", min_area_m2_)});
    }
  }

  GapGround ground_of(Region region) const {
    for (Polygon& polygon : region) polygon = oriented(std::move(polygon));
    return gap_ground(std::move(region), free_, obstacles_, terms_.machine.width_m);
  }

  /// What has to be covered of ground so large that it is worth another line: as much as is no gap any
  /// more when it is left, or enough for the rest to be none.
  double least_covered_m2(double ground_m2) const {
    return std::max(kNoGround_m2, std::min(min_area_m2_, ground_m2 - min_area_m2_));
  }

  std::optional<GapChoice> chosen(const GapGround& ground, GapEffort effort) {
    const std::vector<Direction> directions = gap_directions(ground, terms_.machine.width_m, effort);
    return best_lines(ground, directions, terms_, least_covered_m2(ground.gaps_m2), kTail_m,
                      ShortLines::kLeave);
  }

  std::optional<GapChoice> chosen_thoroughly(const GapGround& ground) const {
    const std::vector<Direction> directions =
        gap_directions(ground, terms_.machine.width_m, GapEffort::kThorough);
    for (const double least_width_m : {kTail_m, kWidthTolerance})
      if (auto found = best_lines(ground, directions, terms_, least_covered_m2(ground.gaps_m2), least_width_m,
                                  ShortLines::kLeave))
        return found;
    return std::nullopt;
  }

  /// Every gap by itself; those that no swath enters are sorted out.
  std::vector<GapGroup> groups_of_one() {
    std::vector<std::optional<GapGroup>> found(gaps_.size());
    for_each_index(gaps_.size(), threads_, [&](std::size_t i) {
      GapGround ground = ground_of({gaps_[i].shape});
      std::optional<GapChoice> choice = chosen(ground, GapEffort::kLook);
      if (!choice) choice = chosen_thoroughly(ground);
      if (choice) found[i] = GapGroup{std::move(ground), std::move(*choice)};
    });
    std::vector<GapGroup> out;
    for (std::size_t i = 0; i < gaps_.size(); ++i) {
      if (found[i]) {
        taken_.push_back(gaps_[i]);
        out.push_back(std::move(*found[i]));
      } else {
        out_.unreachable.push_back({gaps_[i].number, gaps_[i].area_m2, gaps_[i].centre, why_unreachable()});
      }
    }
    out_.taken = static_cast<int>(taken_.size());
    return out;
  }

  std::string why_unreachable() const {
    return fmt::format(
        "the machine cannot enter: no straight swath {:g} m wide that stays in the field and out of "
        "obstacles "
        "works as much of it as counts",
        terms_.machine.width_m);
  }

  void require_any(const std::vector<GapGroup>& groups) const {
    if (out_.gaps == 0) throw bad_input(fmt::format("nothing of the field '{}' was missed", field_.id));
    if (!groups.empty()) return;
    throw bad_input(fmt::format(
        "none of the {} gaps of field '{}' can be repaired: {} are smaller than {:g} m², and into {} no "
        "swath "
        "{:g} m wide fits without leaving the field; use a smaller --min-area or a narrower machine",
        out_.gaps, field_.id, out_.ignored.size(), min_area_m2_, out_.unreachable.size(),
        terms_.machine.width_m));
  }

  int gap_at(const Region& region) const {
    const auto largest = std::max_element(
        region.begin(), region.end(), [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
    const Point inside = interior_point(*largest);
    for (const Gap& gap : taken_)
      if (contains(gap.shape, inside)) return gap.number;
    return taken_.front().number;
  }

  /// What no swath laid so far covers.
  Region uncovered(const Region& region) const {
    Region near;
    const Box box = bounds(region);
    for (std::size_t i = 0; i < swaths_.size(); ++i)
      if (intersects(swath_boxes_[i], box)) near.push_back(swaths_[i]);
    return near.empty() ? region : difference(region, unite(near));
  }

  void lay(GapGroup group) {
    Job job{group.ground.gaps,
            group.choice.lines.grid.frame.direction(),
            {group.choice.lines.grid, {}, 0, 0},
            gap_at(group.ground.gaps),
            {}};
    const Region left = sized(uncovered(job.region), min_area_m2_);
    if (left.empty()) {
      jobs_.push_back(std::move(job));
      return;
    }
    if (area(left) < group.ground.gaps_m2 - kNoGround_m2) {
      // Others have covered part of it: what is left may be better worked another way.
      const GapGround ground = ground_of(left);
      std::optional<GapChoice> other = chosen(ground, GapEffort::kLook);
      if (other) group.choice = std::move(*other);
    }
    take_on(std::move(job), std::move(group.choice.lines), left);
  }

  /// `left`: the part of the job's region that has to be covered yet.
  void take_on(Job job, GapLines lines, const Region& left) {
    job.direction = lines.grid.frame.direction();
    job.lines = std::move(lines);
    for (Polygon& swath : swaths_of(job.lines)) {
      swath_boxes_.push_back(bounds(swath));
      swaths_.push_back(oriented(std::move(swath)));
    }
    const std::size_t parent = jobs_.size();
    for (const Polygon& part : sized(uncovered(left), min_area_m2_)) {
      Job more{{part}, job.direction, {job.lines.grid, {}, 0, 0}, job.gap, {}};
      open_.push_back(std::move(more));
      parents_.push_back(parent);
    }
    jobs_.push_back(std::move(job));
  }

  void lay_more(Job job) {
    const std::size_t parent = parents_.front();
    parents_.pop_front();
    const Region left = sized(uncovered(job.region), min_area_m2_);
    if (left.empty()) return;
    const GapGround ground = ground_of(left);
    std::optional<GapChoice> choice = chosen_thoroughly(ground);
    if (!choice) {
      for (const Polygon& part : left)
        out_.unreachable.push_back(
            {job.gap, area(part), interior_point(part), "part of a gap taken on: " + why_unreachable()});
      return;
    }
    jobs_[parent].left_for_more.insert(jobs_[parent].left_for_more.end(), job.region.begin(),
                                       job.region.end());
    take_on(std::move(job), std::move(choice->lines), left);
    tell();
  }

  void tell() const {
    if (progress_) progress_(static_cast<int>(jobs_.size()), static_cast<int>(jobs_.size() + open_.size()));
  }

  /// The jobs' regions without those of the jobs that came of them, a subfield for each polygon, and the
  /// index of the first for each job.
  std::vector<int> add_subfields(Plan& plan) const {
    std::vector<int> first;
    for (const Job& job : jobs_) {
      Region own = job.left_for_more.empty() ? job.region : difference(job.region, unite(job.left_for_more));
      std::stable_sort(own.begin(), own.end(),
                       [](const Polygon& a, const Polygon& b) { return area(a) > area(b); });
      first.push_back(static_cast<int>(plan.subfields.size()));
      for (std::size_t i = 0; i < own.size(); ++i)
        if (i == 0 || area(own[i]) >= kNoGround_m2)
          plan.subfields.push_back({std::move(own[i]), job.direction});
    }
    return first;
  }

  void finish(const Region& missed) {
    Plan& plan = out_.plan;
    plan.field = field_;
    plan.machine = terms_.machine;
    plan.objective = terms_.objective;
    plan.settings.end_rule = terms_.end_rule;
    plan.settings.boundary = EdgeKind::kHard;
    plan.settings.avoid = Avoidance::kCut;
    for (const Gap& gap : taken_) plan.body.push_back(oriented(gap.shape));
    plan.body = unite(plan.body);
    plan.worked = sized(difference(free_, plan.body), kNoGround_m2);
    if (plan.worked.empty())
      throw bad_input(
          fmt::format("nothing of the field '{}' was worked: there is nothing to repair, plan it with "
                      "'tramline plan'",
                      field_.id));
    const std::vector<int> first = add_subfields(plan);
    std::vector<WorkedLine> lines;
    for (std::size_t i = 0; i < jobs_.size(); ++i) append_lines(jobs_[i].lines, first[i], lines);
    plan.pieces = in_driving_order(std::move(lines));
    add_tally(plan);
    WorkedRegions worked = worked_regions(plan.body, swaths_);
    plan.overlap = std::move(worked.overlap);
    plan.uncovered = std::move(worked.uncovered);
    plan.warnings = warnings_about(plan);
    out_.missed_before_m2 = area(missed);
    out_.missed_after_m2 = area(difference(missed, unite(swaths_)));
  }

  static void add_tally(Plan& plan) {
    Tally& tally = plan.tally;
    const double width_m = plan.machine.width_m;
    const std::vector<double> overlaps = overlap_by_piece(plan.body, plan.subfields, plan.pieces, width_m);
    for (std::size_t i = 0; i < overlaps.size(); ++i) {
      TrackPiece& piece = plan.pieces[i];
      piece.overlap_m2 = overlaps[i];
      tally.overlap_m2 += overlaps[i];
      tally.track_length_m += length(piece);
      tally.crossings += piece.after_crossing ? 1 : 0;
      tally.stops += (piece.stop_at_start ? 1 : 0) + (piece.stop_at_end ? 1 : 0);
    }
    tally.pieces = static_cast<int>(plan.pieces.size());
    tally.turns = std::max(0, tally.pieces - 1 - tally.crossings);
    tally.worked_m2 = width_m * tally.track_length_m;
    tally.uncovered_m2 = std::max(0.0, area(plan.body) - (tally.worked_m2 - tally.overlap_m2));
    plan.cost = cost(plan.objective, tally);
  }

  const Field& field_;
  const RepairTerms& terms_;
  double min_area_m2_;
  int threads_;
  const RepairProgress& progress_;
  Region free_;
  Region obstacles_;
  std::vector<Gap> gaps_;   ///< large enough
  std::vector<Gap> taken_;  ///< and entered by some swath
  std::vector<Job> jobs_;
  std::deque<Job> open_;
  std::deque<std::size_t> parents_;  ///< of the open ones
  Region swaths_;
  std::vector<Box> swath_boxes_;
  RepairPlan out_;
};

}  // namespace

RepairPlan repair_plan(const Field& field, const std::vector<Gap>& gaps, const Region& missed,
                       RepairTerms terms, double min_area_m2, int threads, const RepairProgress& progress) {
  if (terms.machine.min_length_m < 0) terms.machine.min_length_m = 0;
  Pulse pulse(progress);
  const RepairProgress counted = pulse.counter();
  return RepairMaker(field, gaps, terms, min_area_m2, threads, counted).run(missed);
}

}  // namespace tramline
