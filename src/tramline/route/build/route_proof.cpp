#include "tramline/route/build/route_proof.h"

#include <algorithm>

#include "tramline/route/axle/axle_path.h"
#include "tramline/route/build/least_seconds.h"
#include "tramline/route/build/route_lines.h"
#include "tramline/route/certificate/best_bound.h"

namespace tramline {
namespace {

/// The least times between the ends of lines and the gates, in the numbering of RouteProof.
class LeastConnections final : public order::ConnectionBounds {
 public:
  LeastConnections(std::vector<RouteLine> lines, std::vector<Point> gates, const LeastSeconds& least)
      : lines_(lines.size()), gates_(std::move(gates)), least_(least) {
    for (std::size_t end = 0; end < 2 * lines_; ++end) {
      left_.push_back(pose_left_by(lines[order::line_of(end)], end));
      entered_.push_back(pose_entered_by(lines[order::line_of(end)], end));
    }
  }

  std::size_t lines() const override { return lines_; }
  std::size_t gates() const override { return gates_.size(); }

  double between(std::size_t a, std::size_t b) const override {
    if (is_gate(a)) return to_gate(a, b);
    if (is_gate(b)) return to_gate(b, a);
    return std::min(least_.between(left_[a], entered_[b]), least_.between(left_[b], entered_[a]));
  }

  double least(std::size_t a, std::size_t b) const override {
    if (is_gate(a)) return to_gate(a, b);
    if (is_gate(b)) return to_gate(b, a);
    return std::min(least_.crude(left_[a], entered_[b]), least_.crude(left_[b], entered_[a]));
  }

 private:
  bool is_gate(std::size_t node) const { return node >= 2 * lines_; }
  double to_gate(std::size_t gate, std::size_t end) const {
    const Point at = gates_[gate - 2 * lines_];
    return std::min(least_.to_gate(at, left_[end]), least_.to_gate(at, entered_[end]));
  }

  std::size_t lines_;
  std::vector<Point> gates_;
  const LeastSeconds& least_;
  std::vector<Pose> left_;
  std::vector<Pose> entered_;
};

/// The lines in driving order, in the sense in which they are driven, and the open passes.
std::vector<RouteLine> lines_of_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                                      const order::Tour& tour) {
  const Turning& turning = task.machine.turning;
  std::vector<RouteLine> out;
  for (const order::End entered : tour) {
    const order::WorkedLine& line = lines[order::line_of(entered)];
    out.push_back(route_line(order::is_start(entered) ? line : order::backwards(line), turning));
  }
  for (std::size_t i = 0; i < task.headland.passes.size(); ++i)
    if (!is_closed(task.headland.passes[i])) out.push_back(route_line(task.headland.passes[i], i, turning));
  return out;
}

/// The ways straight on across passable obstacles within lines, m.
double crossings_m(const std::vector<order::WorkedLine>& lines, const Turning& turning) {
  double out = 0;
  for (const order::WorkedLine& line : lines)
    for (std::size_t i = 1; i < line.size(); ++i)
      out +=
          distance(end_of(axle_path(line[i - 1], turning)).at, axle_path(line[i], turning).front().start.at);
  return out;
}

/// Work, headland passes, and crossings of passable obstacles on both: the same on every route.
double fixed_seconds(const std::vector<RouteLeg>& legs, const std::vector<order::WorkedLine>& lines,
                     const Turning& turning) {
  double out = crossings_m(lines, turning) / turning.turning_speed_mps;
  for (const RouteLeg& leg : legs) {
    if (leg.work)
      out += length(leg) / turning.working_speed_mps;
    else if (leg.pass)
      out += length(leg) / turning.turning_speed_mps;
  }
  return out;
}

}  // namespace

RouteProof route_proof(const RouteTask& task, const std::vector<order::WorkedLine>& lines,
                       const order::Tour& tour, const Route& route) {
  const LeastSeconds least(task.machine);
  const Turning& turning = task.machine.turning;
  RouteProof out;
  const double fixed_s = fixed_seconds(route.legs, lines, turning);
  double whole_s = 0;
  for (const RouteLeg& leg : route.legs) whole_s += leg.time_s;
  std::vector<Point> gates;
  for (const std::optional<Point>& gate : {task.settings.route.start, task.settings.route.end})
    if (gate) gates.push_back(*gate);
  const LeastConnections bounds(lines_of_proof(task, lines, tour), gates, least);
  if (bounds.lines() == 0) {
    out.bound_s = fixed_s;
    return out;
  }
  order::PricedBound priced = order::best_bound(bounds, {std::max(0.0, whole_s - fixed_s), 0});
  out.bound_s = fixed_s + std::max(0.0, priced.bound_s);
  out.node_prices_s = std::move(priced.prices_s);
  return out;
}

}  // namespace tramline
