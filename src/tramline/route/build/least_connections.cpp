#include "tramline/route/build/least_connections.h"

#include <algorithm>
#include <cassert>
#include <set>

namespace tramline {
namespace {

constexpr double kChange_s = 1e6;
/// Rings nearer to one another than so many widths are next to one another.
constexpr double kNextRings_widths = 1.5;
constexpr double kUnknown_s = -1;

}  // namespace

LeastConnections::LeastConnections(RouteMembers members, double width_m, const LeastSeconds& least,
                                   std::optional<LeastBacking> backing)
    : members_(std::move(members)),
      least_(least),
      backing_(std::move(backing)),
      next_rings_m_(kNextRings_widths * width_m) {
  assert(members_.line_phases.size() == lines() && members_.ring_phases.size() == rings());
  std::set<std::size_t> phases;
  for (std::size_t node = 0; node < nodes(); ++node) phases.insert(phase(node));
  if (!phases.empty()) between_phases_s_ = kChange_s * static_cast<double>(phases.size() - 1);
  for (std::size_t end = 0; end < 2 * lines(); ++end) {
    const RouteLine& line = members_.lines[order::line_of(end)];
    left_.push_back(pose_left_by(line, end));
    entered_.push_back(pose_entered_by(line, end));
    if (!backing_) continue;
    exits_left_.push_back(backing_->left(line.left_by(end).last));
    exits_entered_.push_back(backing_->entered(line.entered_by(end).first));
  }
  same_both_ways_ =
      least.lift_m() == least.lower_m() && std::ranges::equal(left_, entered_, {}, &Pose::at, &Pose::at);
  for (std::size_t i = 0; i < rings(); ++i) {
    apart_m_.emplace_back();
    for (std::size_t node = 0; node < nodes(); ++node) apart_m_[i].push_back(distance_to_ring(node, i));
    known_s_.emplace_back(nodes(), kUnknown_s);
  }
}

double LeastConnections::between(std::size_t a, std::size_t b) const {
  if (a > b) return between(b, a);
  if (is_ring(b)) return change_s(a, b) + known_to_ring(a, ring(b));
  if (is_gate(b)) return change_s(a, b) + to_gate(a, b);
  const double there_s = one_way(a, b);
  return change_s(a, b) + (same_both_ways_ ? there_s : std::min(there_s, one_way(b, a)));
}

double LeastConnections::one_way(std::size_t left, std::size_t entered) const {
  const double least_s = least_.between(left_[left], entered_[entered]);
  return backing_ ? backing_->between(exits_left_[left], exits_entered_[entered], least_s) : least_s;
}

double LeastConnections::least(std::size_t a, std::size_t b) const {
  if (a > b) return least(b, a);
  if (is_ring(b)) return change_s(a, b) + apart_m_[ring(b)][a] / least_.fastest_mps();
  if (is_gate(b)) return change_s(a, b) + to_gate(a, b);
  return change_s(a, b) + std::min(least_.crude(left_[a], entered_[b]), least_.crude(left_[b], entered_[a]));
}

std::size_t LeastConnections::phase(std::size_t node) const {
  if (is_ring(node)) return members_.ring_phases[ring(node)];
  return is_gate(node) ? gate(node).phase : members_.line_phases[order::line_of(node)];
}

double LeastConnections::change_s(std::size_t a, std::size_t b) const {
  return phase(a) == phase(b) ? 0 : kChange_s;
}

double LeastConnections::to_gate(std::size_t end, std::size_t gate_node) const {
  const Point at = gate(gate_node).at;
  return std::min(least_.to_gate(at, left_[end]), least_.to_gate(at, entered_[end]));
}

double LeastConnections::distance_to_ring(std::size_t node, std::size_t which) const {
  const RingPlaces& places = members_.rings[which];
  if (is_ring(node)) return ring(node) < which ? least_distance_m(members_.rings[ring(node)], places) : 0;
  if (is_gate(node)) return least_distance_m(places, gate(node).at);
  return std::min(least_distance_m(places, left_[node].at), least_distance_m(places, entered_[node].at));
}

double LeastConnections::known_to_ring(std::size_t node, std::size_t which) const {
  double& known_s = known_s_[which][node];
  if (known_s == kUnknown_s) known_s = to_ring(node, which);
  return known_s;
}

double LeastConnections::to_ring(std::size_t node, std::size_t which) const {
  const RingPlaces& places = members_.rings[which];
  const double apart_m = apart_m_[which][node], apart_s = apart_m / least_.fastest_mps();
  if (is_gate(node) || (is_ring(node) && apart_m > next_rings_m_)) return apart_s;
  if (is_ring(node))
    return std::max(apart_s, least_between_rings(members_.rings[ring(node)], places, least_));
  double to_s = least_to_ring(left_[node], least_.lift_m(), places, least_),
         from_s = least_from_ring(places, entered_[node], least_.lower_m(), least_);
  if (backing_) {
    const auto on_s = [&](const Pose& from) { return least_to_ring(from, 0, places, least_); };
    const auto before_s = [&](const Pose& to) { return least_from_ring(places, to, 0, least_); };
    to_s = backing_->to_ring(exits_left_[node], places.lines, on_s, std::max(to_s, apart_s));
    from_s = backing_->to_ring(exits_entered_[node], places.lines, before_s, std::max(from_s, apart_s));
  }
  return std::max(apart_s, std::min(to_s, from_s));
}

}  // namespace tramline
