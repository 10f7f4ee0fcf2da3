#include "tramline/route/build/planned_route.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>

#include "tramline/model/rate_values.h"
#include "tramline/route/build/followed_lines.h"
#include "tramline/route/build/gates.h"
#include "tramline/route/build/leg_list.h"
#include "tramline/route/build/lines_through_narrows.h"
#include "tramline/route/build/tour_as_driven.h"
#include "tramline/route/build/work_by_part.h"
#include "tramline/route/connection/squeezed_way.h"
#include "tramline/route/order/point_grid.h"
#include "tramline/route/passes/pass_tour.h"
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
        legs_(task.field, turning_) {
    for (const order::WorkedLine& line : lines) route_lines_.push_back(route_line(line, turning_));
    out_.start = with_room(task.settings.route.start, ground_);
    out_.end = with_room(task.settings.route.end, ground_);
  }

  PlannedRoute run(const std::vector<order::Tour>& given) {
    const std::vector<PartWork> parts =
        work_by_part(route_lines_, task_.headland, {out_.start, out_.end}, ground_);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      leaves_part_ = i > 0;
      ahead_ = i + 1 < parts.size() ? parts[i].next : out_.end;
      add_part(parts[i], given);
    }
    out_.parts = parts.size();
    if (out_.end && !left_.empty()) legs_.add(connector_.measured(connector_.to_gate(left_, *out_.end)));
    out_.legs = std::move(legs_).finished();
    measure_room_at_work();
    return std::move(out_);
  }

 private:
  /// Passes that are ordered together.
  struct Group {
    std::vector<std::size_t> passes{};
    bool as_lines = false;  ///< they have two ends, like tracks
  };
  using Groups = std::vector<Group>;

  void add_part(const PartWork& work, const std::vector<order::Tour>& given) {
    const Groups groups = pass_groups(work.passes);
    const bool first = task_.settings.route.passes == PassTime::kFirst;
    if (first) add_passes(groups);
    add_tracks(work.lines, given,
               first || groups.empty() ? std::vector<std::size_t>{} : groups.front().passes);
    if (!first) add_passes(groups);
  }

  /// What lies ahead of the work or behind it may swing off the land in corners of passes and at the ends of
  /// tracks, where the implement itself does not.
  void measure_room_at_work() {
    if (machine_is_its_bar(task_.machine)) return;
    for (RouteLeg& leg : out_.legs)
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
    const auto& round_all = task_.beside_boundaries.round_all(task_.field, narrowed);
    std::ranges::copy(lines_through_narrows(round_all, lines, ground_), std::back_inserter(lines));
    return {lines, roadmap_spacing_m()};
  }

  /// The way from where the route is, or from its gate, to the beginning of a work.
  Way way_to(const SteeredPath& entered) const {
    if (!left_.empty()) return connector_.between(left_, entered);
    return out_.start ? connector_.from_gate(*out_.start, entered) : Way{};
  }

  /// `axle`: the way over the first work.
  Way way_to_first(order::End entered, const SteeredPath& axle, const KnownCosts& costs) const {
    if (leaves_part_) return way_to(axle);
    return left_.empty() && !out_.start ? Way{} : costs.way_to_first(entered);
  }

  BeforeLines before_lines(const KnownCosts& costs) const {
    return {left_,
            [&](order::End entered, const SteeredPath& axle) { return way_to_first(entered, axle, costs); }};
  }

  /// Goes a way to a work and over it.
  void go(Way way, const SteeredPath& work) {
    if (!left_.empty() && way.has_room() && (way.backs_out || way.backs_in))
      way = connector_.with_less_backing(way, left_, work);
    way = connector_.measured(std::move(way));
    if (!way.has_room() && !left_.empty()) way = squeezed_.along_the_land(std::move(way), left_, work);
    if (!way.path.empty()) legs_.add(way);
    left_ = driven_forward(left_, way, work);
    leaves_part_ = false;
  }

  /// `gate`: where the route goes once they are worked.
  PassTask pass_task(const std::vector<std::size_t>& passes, std::optional<Point> gate = {}) const {
    return {task_.headland, entries_, passes, task_.settings.route.sequence, connector_, least_, gate};
  }

  /// Those round the outside first where passes come first, and last where they come last: the others lie
  /// between them and the tracks.
  void add_passes(const Groups& groups) {
    for (std::size_t i = 0; i < groups.size(); ++i)
      if (groups[i].as_lines)
        add_open(groups[i].passes, i + 1 < groups.size() ? groups[i + 1].passes : std::vector<std::size_t>{});
      else
        add_nearest(groups[i].passes,
                    i + 1 == groups.size() && task_.settings.route.passes == PassTime::kLast);
  }

  /// In the order in which they are driven.
  Groups pass_groups(const std::vector<std::size_t>& passes) const {
    Group open{{}, true}, closed, all{passes};
    for (const std::size_t i : passes)
      (is_closed(task_.headland.passes[i]) ? closed : open).passes.push_back(i);
    Groups out{open, closed};
    if (task_.settings.route.passes == PassTime::kFirst) std::swap(out.front(), out.back());
    if (task_.settings.route.sequence != PassSequence::kAny) out = {all};
    std::erase_if(out, [](const Group& group) { return group.passes.empty(); });
    return out;
  }

  /// Passes in the order in which each is the nearest, or one after another.
  void add_nearest(const std::vector<std::size_t>& passes, bool ends) {
    const std::vector<WorkedPass> tour =
        pass_tour(pass_task(passes, ends ? ahead_ : std::optional<Point>{}), left_);
    for (const WorkedPass& worked : tour) {
      const HeadlandPass& pass = task_.headland.passes[worked.pass];
      const SteeredPath axle = axle_path(pass, worked.entry, turning_);
      go(worked.before.path.empty() ? way_to(axle) : worked.before, axle);
      legs_.add(pass, worked.pass, worked.entry);
    }
  }

  /// Open passes, which have two ends like tracks, in the best order that is found. `next`: the passes
  /// behind.
  void add_open(const std::vector<std::size_t>& passes, const std::vector<std::size_t>& next) {
    std::vector<RouteLine> lines;
    order::Tour as_given;
    for (const std::size_t pass : passes) {
      as_given.push_back(2 * lines.size());
      lines.push_back(route_line(task_.headland.passes[pass], pass, turning_));
    }
    KnownCosts costs(lines, connector_, least_);
    set_starts(lines, costs);
    set_finishes(lines, next, costs);
    const TrackTour tour = best_tour_as_driven({as_given}, senses_of(task_.machine), task_.patience, lines,
                                               before_lines(costs), connector_, costs);
    out_.gave_up = out_.gave_up || tour.gave_up;
    for (std::size_t i = 0; i < tour.tour.size(); ++i) {
      const order::End entered = tour.tour[i];
      const SteeredPath& axle = lines[order::line_of(entered)].entered_by(entered).first;
      go(i > 0 ? way_on(tour.ways[i - 1], left_, axle, connector_) : way_to_first(entered, axle, costs),
         axle);
      const std::size_t pass = passes[order::line_of(entered)];
      const Sense sense = order::is_start(entered) ? Sense::kAlong : Sense::kAgainst;
      legs_.add(task_.headland.passes[pass], pass, {0, sense, axle.front().start, end_of(axle)});
    }
  }

  /// What the way from the last line costs at least, by its end: to the passes that follow, or else to the
  /// next part or the gate.
  void set_finishes(const std::vector<RouteLine>& lines, const std::vector<std::size_t>& passes,
                    KnownCosts& costs) const {
    if (!passes.empty())
      costs.set_way_from_last([this, &lines, passes](order::End end) {
        const SteeredPath& left = lines[order::line_of(end)].left_by(end).last;
        Way way = nearest_pass(pass_task(passes), left).before;
        if (way.has_room()) return way;
        Way supposed = nearest_pass(pass_task(passes), connector_.come_straight_on(left)).before;
        return supposed.has_room() ? supposed : way;
      });
    std::vector<Pose> entered;
    std::vector<Point> places;
    for (const std::size_t pass : passes)
      for (const PassEntry& entry : entries_[pass]) {
        entered.push_back(entry.entered);
        places.push_back(entry.entered.at);
      }
    const order::PointGrid near(places);
    for (order::End end = 0; end < 2 * lines.size(); ++end) {
      const Pose left = pose_left_by(lines[order::line_of(end)], end);
      if (!passes.empty())
        costs.set_finish(end, least_.crude(left, entered[near.nearest(left.at, 1).front()]));
      else if (ahead_)
        costs.set_finish(end, least_.to_gate(*ahead_, left));
    }
  }

  /// What the way to the first line costs at least, by its end.
  void set_starts(const std::vector<RouteLine>& lines, KnownCosts& costs) const {
    if ((!left_.empty() || out_.start) && !leaves_part_)
      costs.set_way_to_first([&](order::End entered) {
        return way_to(lines[order::line_of(entered)].entered_by(entered).first);
      });
    for (order::End end = 0; end < 2 * lines.size(); ++end) {
      const RouteLine& line = lines[order::line_of(end)];
      if (!left_.empty())
        costs.set_start(end, least_.between(end_of(left_), pose_entered_by(line, end)));
      else if (out_.start)
        costs.set_start(end, least_.to_gate(*out_.start, pose_entered_by(line, end)));
    }
  }

  /// `next`: the passes behind them.
  void add_tracks(const std::vector<std::size_t>& on_part, const std::vector<order::Tour>& given,
                  const std::vector<std::size_t>& next) {
    if (on_part.empty()) return;
    std::vector<RouteLine> lines;
    for (const std::size_t line : on_part) lines.push_back(route_lines_[line]);
    std::vector<order::Tour> tours;
    for (const order::Tour& tour : given) tours.push_back(tour_of_those(tour, on_part));
    KnownCosts costs(lines, connector_, least_);
    set_starts(lines, costs);
    set_finishes(lines, next, costs);
    const Senses senses = senses_of(task_.machine);
    const bool best = task_.settings.route.order == TrackOrder::kBest;
    const TrackTour tour = best ? best_tour_as_driven(tours, senses, task_.patience, lines,
                                                      before_lines(costs), connector_, costs)
                                : with_ways(tours.front(), senses, costs);
    out_.gave_up = out_.gave_up || tour.gave_up;
    for (std::size_t i = 0; i < tour.tour.size(); ++i) {
      const order::End entered = tour.tour[i];
      const std::size_t line = on_part[order::line_of(entered)];
      const DrivenSense& sense = route_lines_[line].entered_by(entered);
      go(i > 0 ? way_on(tour.ways[i - 1], left_, sense.first, connector_)
               : way_to_first(entered, sense.first, costs),
         sense.first);
      const order::WorkedLine& worked = lines_[line];
      legs_.add(order::is_start(entered) ? worked : order::backwards(worked), piece_);
      if (worked.size() > 1) left_ = sense.last;
      piece_ += worked.size();
      out_.tour.push_back(order::is_start(entered) ? 2 * line : 2 * line + 1);
    }
  }

  const RouteTask& task_;
  const std::vector<order::WorkedLine>& lines_;
  Turning turning_;
  DrivingGround ground_;
  RoadmapOnDemand roadmap_;
  Connector connector_;
  SqueezedWays squeezed_;
  LeastSeconds least_;
  EntriesByPass entries_;
  LegList legs_;
  std::vector<RouteLine> route_lines_;
  SteeredPath left_;       ///< what was driven forward to the end of the work so far; empty at the beginning
  std::size_t piece_ = 0;  ///< the next one, in driving order
  bool leaves_part_ = false;    ///< the way to the next work leads from one part of the land to another
  std::optional<Point> ahead_;  ///< where the route goes once the part is worked
  PlannedRoute out_;
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
