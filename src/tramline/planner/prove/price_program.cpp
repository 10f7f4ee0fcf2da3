#include "tramline/planner/prove/price_program.h"

#include <algorithm>
#include <coin/ClpSimplex.hpp>

namespace tramline {

/// The dual program, whose basis is as large as there are cells: how often each piece is driven, and how much
/// of each cell is left, so that all land is accounted for at the least cost. The prices are its multipliers.
class PriceProgram::Solver {
 public:
  Solver(const std::vector<double>& inside_m2, double most_price) : most_price_(most_price) {
    const auto count = static_cast<int>(inside_m2.size());
    model_.setLogLevel(0);
    model_.resize(count, 0);
    for (int i = 0; i < count; ++i) {
      model_.setRowBounds(i, inside_m2[static_cast<std::size_t>(i)], COIN_DBL_MAX);
      add_column({{i, 1.0}}, most_price);
    }
    prices_.assign(inside_m2.size(), 0);
  }

  void add(const PieceWorth& piece, double limit) { add_column(piece.area_m2, limit); }

  std::vector<double> prices() {
    model_.addColumns(static_cast<int>(costs_.size()), least_.data(), most_.data(), costs_.data(),
                      starts_.data(), rows_.data(), areas_.data());
    forget();
    model_.primal(1);
    if (model_.status() == 0)
      for (std::size_t i = 0; i < prices_.size(); ++i)
        prices_[i] = std::clamp(model_.dualRowSolution()[i], 0.0, most_price_);
    return prices_;
  }

 private:
  void add_column(const std::vector<std::pair<int, double>>& areas_m2, double cost) {
    for (const auto& [cell, area_m2] : areas_m2) {
      rows_.push_back(cell);
      areas_.push_back(area_m2);
    }
    starts_.push_back(static_cast<int>(rows_.size()));
    least_.push_back(0);
    most_.push_back(COIN_DBL_MAX);
    costs_.push_back(cost);
  }
  void forget() {
    starts_.assign(1, 0);
    rows_.clear();
    areas_.clear();
    least_.clear();
    most_.clear();
    costs_.clear();
  }

  ClpSimplex model_;
  // Columns that the model has not got yet.
  std::vector<int> starts_{0}, rows_;
  std::vector<double> areas_, least_, most_, costs_;
  double most_price_;
  std::vector<double> prices_;
};

PriceProgram::PriceProgram(const std::vector<double>& inside_m2, double most_price)
    : solver_(std::make_unique<Solver>(inside_m2, most_price)) {}
PriceProgram::~PriceProgram() = default;
void PriceProgram::add(const PieceWorth& piece, double limit) { solver_->add(piece, limit); }
std::vector<double> PriceProgram::prices() { return solver_->prices(); }

}  // namespace tramline
