#pragma once
// The linear program of prices on the ground.

#include <memory>
#include <vector>

#include "tramline/planner/prove/strip_sweep.h"

namespace tramline {

/// Prices of cells, from 0 to the price of uncovered land, whose sum over the land is as large as it can be
/// while no piece that was added is worth more than its limit. Solved by Clp; what comes of it is a proposal
/// and proves nothing.
class PriceProgram {
 public:
  /// One price for each cell, of which `inside_m2` is land.
  PriceProgram(const std::vector<double>& inside_m2, double most_price);
  ~PriceProgram();
  PriceProgram(const PriceProgram&) = delete;
  PriceProgram& operator=(const PriceProgram&) = delete;

  /// The prices of its cells have to make no more than `limit` of its area.
  void add(const PieceWorth& piece, double limit);
  /// The best prices; where the program finds none, those that it had.
  std::vector<double> prices();

 private:
  class Solver;
  std::unique_ptr<Solver> solver_;
};

}  // namespace tramline
