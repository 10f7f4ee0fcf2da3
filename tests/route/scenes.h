#pragma once
// Lines to find an order for, and the costs between their ends.

#include <random>
#include <vector>

#include "tramline/geometry/path/steered_path.h"
#include "tramline/route/certificate/connection_bounds.h"
#include "tramline/route/search/end_costs.h"
#include "tramline/route/search/neighbours.h"

namespace tramline::testing {

/// Costs by table, both for the search and for the bound: then the bound may not exceed the search. With
/// `starting` and `finishing` filled the tour starts and finishes at gates. Rings are of the bound alone.
class TableCosts final : public order::EndCosts, public order::ConnectionBounds {
 public:
  explicit TableCosts(std::size_t lines) : between_(2 * lines, std::vector<double>(2 * lines, 0)) {}

  void set(order::End a, order::End b, double cost_s) { between_[a][b] = between_[b][a] = cost_s; }
  void set_gates(std::vector<double> starting, std::vector<double> finishing) {
    starting_ = std::move(starting);
    finishing_ = std::move(finishing);
  }
  /// One more ring, by what connections to all nodes before it cost.
  void add_ring(std::vector<double> costs_s) { rings_.push_back(std::move(costs_s)); }
  /// The lower bound of a cost is this part of it.
  void set_least(double share) { share_ = share; }

  std::size_t lines() const override { return between_.size() / 2; }
  double at_start(order::End entered) const override { return starting_.empty() ? 0 : starting_[entered]; }
  double at_finish(order::End left) const override { return finishing_.empty() ? 0 : finishing_[left]; }
  std::size_t gates() const override { return (starting_.empty() ? 0 : 1) + (finishing_.empty() ? 0 : 1); }
  double between(std::size_t a, std::size_t b) const override {
    if (a > b) return between(b, a);
    if (b < between_.size()) return between_[a][b];
    if (is_ring(b)) return rings_[b - between_.size() - gates()][a];
    return b == between_.size() && !starting_.empty() ? starting_[a] : finishing_[a];
  }
  std::size_t rings() const override { return rings_.size(); }
  double least(std::size_t a, std::size_t b) const override { return share_ * between(a, b); }

  order::Neighbours neighbours(std::size_t count = 10) const;

 private:
  std::vector<std::vector<double>> between_;
  std::vector<double> starting_, finishing_;  ///< by end
  std::vector<std::vector<double>> rings_;
  double share_ = 1;
};

/// Any costs at all, from 1 to 10 s: no triangle inequality holds.
TableCosts random_costs(std::size_t lines, std::mt19937_64& random);
/// The same for as many gates. Before rings.
void add_gates(std::size_t gates, TableCosts& costs, std::mt19937_64& random);
void add_rings(std::size_t rings, TableCosts& costs, std::mt19937_64& random);

/// Poses in which a machine leaves lines, by end.
using LeavingPoses = std::vector<Pose>;

/// Tracks side by side over a rectangle.
LeavingPoses rectangle(std::size_t tracks, double width_m, double length_m);
/// Tracks side by side over a round field with an oblique edge, cut by an obstacle, and a few lines across.
LeavingPoses random_field_lines(std::size_t lines, double width_m, std::mt19937_64& random);

/// The shortest ways forward between lines, at 2 m/s.
TableCosts dubins_costs(const LeavingPoses& leaving, double radius_m);

}  // namespace tramline::testing
