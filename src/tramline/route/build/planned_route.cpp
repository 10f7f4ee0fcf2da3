#include "tramline/route/build/planned_route.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <memory>

#include "tramline/model/rate_values.h"
#include "tramline/route/build/followed_lines.h"
#include "tramline/route/build/gates.h"
#include "tramline/route/build/lines_through_narrows.h"
#include "tramline/route/build/passes_among_tracks.h"
#include "tramline/route/build/route_driver.h"
#include "tramline/route/build/tour_as_driven.h"
#include "tramline/route/build/work_by_part.h"
#include "tramline/route/connection/squeezed_way.h"
#include "tramline/route/passes/next_pass.h"
#include "tramline/turns/track_ends.h"

namespace tramline {
namespace {

/// Poses of the roadmap are so far apart, as a share of the radius, and at least kLeastSpacing_m.
constexpr double kRoadmapSpacing_radii = 0.75;
constexpr double kLeastSpacing_m = 2;

std::vector<TrackPiece> pieces_of(const std::vector<order::WorkedLine>& lines) {
  std::vector<TrackPiece> out;
  for (const order::WorkedLine& line : lines) out.insert(out.end(), line.begin(), line.end());
  return out;
}

/// Whether all there is of the machine is a bar at its axle: then it works all that it sweeps.
bool machine_is_its_bar(const Machine& machine) {
  const Turning& turning = machine.turning;
  return reach_back_m(turning) == 0 && turning.drawbar_m == 0 && turning.front_overhang_m == 0 &&
         turning.rear_overhang_m == 0;
}

/// Where nothing reaches out, what is driven from the end of a way sweeps the same land.
Senses senses_of(const Machine& machine) {
  const bool alike = machine_is_its_bar(machine) && machine.turning.lift_m == machine.turning.lower_m;
  return alike ? Senses::kCostTheSame : Senses::kDiffer;
}

/// A tour over the lines of a list, numbered by their places in it: those of a tour over all lines, in its
/// order.
order::Tour tour_of_those(const order::Tour& tour, const std::vector<std::size_t>& lines) {
  order::Tour out;
  for (const order::End entered : tour) {
    const auto found = std::ranges::lower_bound(lines, order::line_of(entered));
    if (found == lines.end() || *found != order::line_of(entered)) continue;
    const order::End start = 2 * static_cast<std::size_t>(found - lines.begin());
    out.push_back(order::is_start(entered) ? start : order::other_end(start));
  }
  return out;
}

class RoutePlanner {
 public:
  RoutePlanner(const RouteTask& task, const std::vector<order::WorkedLine>& lines)
      : task_(task),
        lines_(lines),
        turning_(task.machine.turning),
        ground_(task.turning_land, task.field, task.machine, task.body),
        roadmap_([this] { return roadmap(); }, ground_),
        connector_(ground_, roadmap_, {task.settings.towing_error_m, counted_stop_s(task)}),
        squeezed_(connector_, task.field, task.body,
                  [this](const DrivingGround& narrowed) { return roadmap_for(narrowed); }),
        least_(task.machine),
        entries_(entries_by_pass(task.headland, task.machine)),
        start_(with_room(task.settings.route.start, ground_)),
        end_(with_room(task.settings.route.end, ground_)),
        driver_(task, {lines, route_lines_, entries_, connector_, squeezed_, least_}, start_) {
    for (const order::WorkedLine& line : lines) route_lines_.push_back(route_line(line, turning_));
  }

  PlannedRoute run(const std::vector<order::Tour>& given) {
    const std::vector<PartWork> parts = work_by_part(route_lines_, task_.headland, {start_, end_}, ground_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      if (i > 0) driver_.leave_part();
      is_last_part_ = i + 1 == parts.size();
      ahead_ = is_last_part_ ? end_ : parts[i].next;
      add_part(parts[i], given);
    }
    if (end_) driver_.drive_to(*end_);
    RouteSoFar driven = driver_.so_far();
    PlannedRoute out;
    out.tour = std::move(driven.tour);
    out.legs = std::move(driven.legs).finished();
    out.gave_up = gave_up_;
    out.reached = roadmap_.reached();
    out.parts = parts.size();
    out.start = start_;
    out.end = end_;
    measure_room_at_work(out.legs);
    return out;
  }

 private:
  using Groups = std::vector<PassGroup>;

  void add_part(const PartWork& work, const std::vector<order::Tour>& given) {
    const Groups groups = pass_groups(work.passes);
    const bool first = task_.settings.route.passes == PassTime::kFirst;
    if (first) add_groups(groups);
    OrderedTracks tracks =
        ordered_tracks(work.lines, given, first || groups.empty() ? PassGroup{} : groups.front());
    if (first) return drive_tracks(driver_, tracks, {});
    const RouteSoFar before = driver_.so_far();
    drive_with_passes_among_tracks(driver_, tracks.tour, closed_passes(groups), ahead_,
                                   [&](const std::vector<PassesAmongTracks>& among) {
                                     driver_.go_back_to(before);
                                     drive_tracks(driver_, tracks, among);
                                     add_passes_in_best_order(others(groups, among));
                                   });
  }

  /// What lies ahead of the work or behind it may swing off the land in corners of passes and at the ends of
  /// tracks, where the implement itself does not.
  void measure_room_at_work(std::vector<RouteLeg>& legs) const {
    if (machine_is_its_bar(task_.machine)) return;
    for (RouteLeg& leg : legs)
      if (leg.work) leg.missing_m = ground_.lacking_along_m(leg.path);
  }

  double roadmap_spacing_m() const {
    return std::max(kLeastSpacing_m, kRoadmapSpacing_radii * ground_.machine().radius_m);
  }

  std::vector<FollowedLine> lines_to_follow() const {
    const auto& beside = task_.beside_boundaries.found(task_.headland, task_.field, ground_);
    return followed_lines(task_.headland, pieces_of(lines_), beside, task_.machine);
  }

  Roadmap roadmap() const { return {lines_to_follow(), roadmap_spacing_m()}; }

  /// With lines through narrows, in which the machine itself has no room.
  Roadmap roadmap_for(const DrivingGround& narrowed) const {
    std::vector<FollowedLine> lines = lines_to_follow();
    const auto& round_all = task_.for_narrower.round_all(task_.field, narrowed);
    std::ranges::copy(lines_through_narrows(round_all, lines, ground_), std::back_inserter(lines));
    return {lines, roadmap_spacing_m()};
  }

  /// `axle`: the way over the first work.
  Way way_to_first(order::End entered, const SteeredPath& axle, const KnownCosts& costs) const {
    if (so_far().leaves_part) return driver_.way_to(axle);
    return so_far().left.empty() && !start_ ? Way{} : costs.way_to_first(entered);
  }

  BeforeLines before_lines(const KnownCosts& costs) const {
    return {so_far().left,
            [&](order::End entered, const SteeredPath& axle) { return way_to_first(entered, axle, costs); }};
  }

  /// The groups one after the other, or otherwise where the route then lacks room less often or costs less.
  /// On the last part of the land alone: before other work it is not known yet what it takes to come out of
  /// an arm in which passes end.
  void add_passes_in_best_order(const Groups& groups) {
    const RouteSoFar before = so_far();
    add_groups(groups);
    if (!is_last_part_) return;
    for (const Groups& other : grouped_otherwise(groups)) {
      RouteSoFar best = so_far();
      const auto known = effort_to_end();
      driver_.go_back_to(before);
      add_groups(other);
      if (!(effort_to_end() < known)) driver_.go_back_to(std::move(best));
    }
  }

  /// Of the route as it would go on to the gate.
  std::pair<std::size_t, double> effort_to_end() {
    if (!end_) return effort(so_far(), std::nullopt, least_);
    RouteSoFar before = so_far();
    driver_.drive_to(*end_);
    const auto out = effort(so_far(), std::nullopt, least_);
    driver_.go_back_to(std::move(before));
    return out;
  }

  /// Closed passes before open ones, and all as they lie, which for open passes alone is another search.
  static std::vector<Groups> grouped_otherwise(const Groups& groups) {
    if (groups.size() > 1) return {other_way_round(groups), all_in_one(groups)};
    const bool has_other_orders = !groups.empty() && groups[0].as_lines && groups[0].passes.size() > 1;
    return has_other_orders ? std::vector<Groups>{all_in_one(groups)} : std::vector<Groups>{};
  }

  static Groups other_way_round(Groups groups) {
    std::swap(groups.front().ahead, groups.back().ahead);
    std::ranges::reverse(groups);
    return groups;
  }

  static Groups all_in_one(const Groups& groups) {
    PassGroup all{{}, false, groups.back().ahead};
    for (const PassGroup& group : groups) std::ranges::copy(group.passes, std::back_inserter(all.passes));
    std::ranges::sort(all.passes);
    return {all};
  }

  void add_groups(const Groups& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].as_lines)
        add_open(groups[i].passes, i + 1 < groups.size() ? groups[i + 1] : PassGroup{});
      else
        driver_.drive_passes(groups[i]);
  }

  /// Closed passes, which mostly go round the outside, first where passes come first and last where they come
  /// last: the others lie between them and the tracks.
  Groups pass_groups(const std::vector<std::size_t>& passes) const {
    PassGroup open{{}, true}, closed, all{passes};
    for (const std::size_t i : passes)
      (is_closed(task_.headland.passes[i]) ? closed : open).passes.push_back(i);
    Groups out{open, closed};
    if (task_.settings.route.passes == PassTime::kFirst) std::swap(out.front(), out.back());
    if (task_.settings.route.sequence != PassSequence::kAny) out = {all};
    std::erase_if(out, [](const PassGroup& group) { return group.passes.empty(); });
    if (!out.empty() && task_.settings.route.passes == PassTime::kLast) out.back().ahead = ahead_;
    return out;
  }

  /// Open passes, which have two ends like tracks, in the best order that is found. `behind`: the passes
  /// that follow.
  void add_open(const std::vector<std::size_t>& passes, const PassGroup& behind) {
    std::vector<RouteLine> lines;
    order::Tour as_given;
    for (const std::size_t pass : passes) {
      as_given.push_back(2 * lines.size());
      lines.push_back(route_line(task_.headland.passes[pass], pass, turning_));
    }
    KnownCosts costs(lines, connector_, least_);
    set_starts(lines, costs);
    set_finishes(lines, behind, costs);
    const TrackTour tour = best_tour_as_driven({as_given}, senses_of(task_.machine), task_.patience, lines,
                                               before_lines(costs), connector_, costs);
    gave_up_ = gave_up_ || tour.gave_up;
    for (std::size_t i = 0; i < tour.tour.size(); ++i) {
      const order::End entered = tour.tour[i];
      const SteeredPath& axle = lines[order::line_of(entered)].entered_by(entered).first;
      const Sense sense = order::is_start(entered) ? Sense::kAlong : Sense::kAgainst;
      driver_.drive_pass(i > 0 ? way_on(tour.ways[i - 1], so_far().left, axle, connector_)
                               : way_to_first(entered, axle, costs),
                         passes[order::line_of(entered)], {0, sense, axle.front().start, end_of(axle)});
    }
  }

  /// What the way from the last line costs at least, by its end: to the passes that follow, or else to the
  /// next part or the gate.
  void set_finishes(const std::vector<RouteLine>& lines, const PassGroup& behind, KnownCosts& costs) const {
    if (!behind.passes.empty()) {
      const auto next = std::make_shared<const NextPass>(driver_.pass_task(behind));
      costs.set_way_from_last([this, &lines, next](order::End end) {
        const SteeredPath& left = lines[order::line_of(end)].left_by(end).last;
        Way way = way_to_pass(*next, left);
        if (way.has_room()) return way;
        Way supposed = way_to_pass(*next, connector_.come_straight_on(left));
        return supposed.has_room() ? supposed : way;
      });
      for (order::End end = 0; end < 2 * lines.size(); ++end)
        costs.set_finish(end, next->about_s(pose_left_by(lines[order::line_of(end)], end)));
    } else if (ahead_) {
      for (order::End end = 0; end < 2 * lines.size(); ++end)
        costs.set_finish(end, least_.to_gate(*ahead_, pose_left_by(lines[order::line_of(end)], end)));
    }
  }

  /// What lies ahead counts with the way to the next pass.
  static Way way_to_pass(const NextPass& next, const SteeredPath& left) {
    NextPass::Chosen chosen = next.after(left);
    chosen.pass.before.cost_s += chosen.more_s;
    return std::move(chosen.pass.before);
  }

  /// What the way to the first line costs at least, by its end.
  void set_starts(const std::vector<RouteLine>& lines, KnownCosts& costs) const {
    const SteeredPath& left = so_far().left;
    if ((!left.empty() || start_) && !so_far().leaves_part)
      costs.set_way_to_first([&](order::End entered) {
        return driver_.way_to(lines[order::line_of(entered)].entered_by(entered).first);
      });
    for (order::End end = 0; end < 2 * lines.size(); ++end) {
      const RouteLine& line = lines[order::line_of(end)];
      if (!left.empty())
        costs.set_start(end, least_.between(end_of(left), pose_entered_by(line, end)));
      else if (start_)
        costs.set_start(end, least_.to_gate(*start_, pose_entered_by(line, end)));
    }
  }

  /// `behind`: the passes that follow.
  OrderedTracks ordered_tracks(const std::vector<std::size_t>& on_part, const std::vector<order::Tour>& given,
                               const PassGroup& behind) {
    OrderedTracks out;
    if (on_part.empty()) return out;
    std::vector<RouteLine> lines;
    for (const std::size_t line : on_part) lines.push_back(route_lines_[line]);
    std::vector<order::Tour> tours;
    for (const order::Tour& tour : given) tours.push_back(tour_of_those(tour, on_part));
    KnownCosts costs(lines, connector_, least_);
    set_starts(lines, costs);
    set_finishes(lines, behind, costs);
    const Senses senses = senses_of(task_.machine);
    const bool best = task_.settings.route.order == TrackOrder::kBest;
    TrackTour tour = best ? best_tour_as_driven(tours, senses, task_.patience, lines, before_lines(costs),
                                                connector_, costs)
                          : with_ways(tours.front(), senses, costs);
    gave_up_ = gave_up_ || tour.gave_up;
    const order::End first = tour.tour.front();
    out.found.push_back(way_to_first(first, lines[order::line_of(first)].entered_by(first).first, costs));
    std::ranges::move(tour.ways, std::back_inserter(out.found));
    for (const order::End entered : tour.tour) {
      const std::size_t line = on_part[order::line_of(entered)];
      out.tour.push_back(order::is_start(entered) ? 2 * line : 2 * line + 1);
    }
    return out;
  }

  static std::vector<std::size_t> closed_passes(const Groups& groups) {
    return groups.empty() || groups.back().as_lines ? std::vector<std::size_t>{} : groups.back().passes;
  }

  /// The groups without passes that are worked among the tracks.
  static Groups others(Groups groups, const std::vector<PassesAmongTracks>& among) {
    for (PassGroup& group : groups)
      std::erase_if(group.passes, [&](std::size_t pass) {
        return std::ranges::any_of(
            among, [&](const PassesAmongTracks& one) { return std::ranges::count(one.passes, pass) > 0; });
      });
    std::erase_if(groups, [](const PassGroup& group) { return group.passes.empty(); });
    return groups;
  }

  const RouteSoFar& so_far() const { return driver_.so_far(); }

  const RouteTask& task_;
  const std::vector<order::WorkedLine>& lines_;
  Turning turning_;
  DrivingGround ground_;
  RoadmapOnDemand roadmap_;
  Connector connector_;
  SqueezedWays squeezed_;
  LeastSeconds least_;
  EntriesByPass entries_;
  std::vector<RouteLine> route_lines_;
  std::optional<Point> start_, end_;  ///< gates
  RouteDriver driver_;
  bool gave_up_ = false;        ///< an order of lines
  std::optional<Point> ahead_;  ///< where the route goes once the part is worked
  bool is_last_part_ = false;
};

}  // namespace

double counted_stop_s(const RouteTask& task) {
  return task.settings.aim == Aim::kWholeCost ? stop_seconds(rates_of(task.machine)) : 0;
}

PlannedRoute planned_route(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                           const std::vector<order::Tour>& given) {
  assert(!lines.empty() || !task.headland.passes.empty());
  return RoutePlanner(task, lines).run(given);
}

}  // namespace tramline
