#include "route/exact/tour_program.h"

#include <Cbc_C_Interface.h>
#include <Clp_C_Interface.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "route/exact/line_cuts.h"

namespace tramline::testing {
namespace {

using order::End;

/// Values nearer than this to a whole number are one, as solvers count.
constexpr double kWhole = 1e-6;

struct Connection {
  End a = 0, b = 0;
  double cost_s = 0;
};

/// All connections of the ring of the lines and what is outside of the tour: ends 2n, where it finishes, and
/// 2n + 1, where it starts.
std::vector<Connection> connections_of(const order::EndCosts& costs) {
  const End finish = 2 * costs.lines();
  std::vector<Connection> out;
  for (End a = 0; a < finish; ++a) {
    for (End b = 0; b < a; ++b)
      if (a / 2 != b / 2) out.push_back({a, b, costs.between(a, b)});
    out.push_back({a, finish, costs.at_finish(a)});
    out.push_back({a, finish + 1, costs.at_start(a)});
  }
  return out;
}

/// A row of the program: the sum of some variables is at least `least`, or just that.
struct ProgramRow {
  std::vector<int> variables;
  double least = 0;
  bool exact = false;
};

class TourProgram {
 public:
  explicit TourProgram(const order::EndCosts& costs)
      : connections_(connections_of(costs)), lines_(costs.lines() + 1) {
    rows_.resize(2 * lines_, {{}, 1, true});
    for (std::size_t i = 0; i < connections_.size(); ++i)
      for (const End end : {connections_[i].a, connections_[i].b})
        rows_[end].variables.push_back(static_cast<int>(i));
  }

  LeastTour solve(double known_s, double seconds) {
    LeastTour out;
    relax(known_s, out);
    out.least_s = known_s;
    while (true) {
      double found_s = known_s;
      const Answer answer = solve_whole(seconds, found_s);
      if (answer == Answer::kTimeOut) break;
      if (answer == Answer::kNone || found_s >= known_s) {
        out.proven = true;
        break;
      }
      const int cuts = add_cuts(values_);
      if (cuts == 0) {
        out.least_s = found_s;
        out.proven = true;
        break;
      }
      out.cuts += cuts;
    }
    return out;
  }

 private:
  enum class Answer { kFound, kNone, kTimeOut };

  /// Solves the relaxation, and keeps the connections that a tour of less than known_s may have.
  void relax(double known_s, LeastTour& out) {
    const std::unique_ptr<Clp_Simplex, decltype(&Clp_deleteModel)> model(Clp_newModel(), &Clp_deleteModel);
    Clp_setLogLevel(model.get(), 0);
    const int count = static_cast<int>(connections_.size());
    std::vector<double> zeros(connections_.size(), 0), ones(connections_.size(), 1), costs;
    for (const Connection& connection : connections_) costs.push_back(connection.cost_s);
    const std::vector<int> starts(connections_.size() + 1, 0);
    Clp_addColumns(model.get(), count, zeros.data(), ones.data(), costs.data(), starts.data(), nullptr,
                   nullptr);
    for (std::size_t first = 0; first < rows_.size();) {
      for (; first < rows_.size(); ++first) add_row(rows_[first], model.get());
      Clp_dual(model.get(), 0);
      const double* solution = Clp_primalColumnSolution(model.get());
      values_.assign(solution, solution + count);
      out.cuts += add_cuts(values_);
    }
    out.relaxed_s = Clp_objectiveValue(model.get());
    const double* reduced = Clp_dualColumnSolution(model.get());
    kept_.clear();
    for (int i = 0; i < count; ++i)
      if (out.relaxed_s + reduced[i] <= known_s + kWhole) kept_.push_back(i);
  }

  static void add_row(const ProgramRow& row, Clp_Simplex* model) {
    const std::vector<double> ones(row.variables.size(), 1);
    const int starts[2] = {0, static_cast<int>(row.variables.size())};
    const double upper = row.exact ? row.least : static_cast<double>(row.variables.size());
    Clp_addRows(model, 1, &row.least, &upper, starts, row.variables.data(), ones.data());
  }

  /// Cuts for the sets of lines that the solution enters and leaves too seldom.
  int add_cuts(const std::vector<double>& values) {
    WeightedLines weights(lines_);
    for (std::size_t i = 0; i < connections_.size(); ++i)
      weights.add(connections_[i].a / 2, connections_[i].b / 2, values[i]);
    int added = 0;
    for (const std::vector<bool>& inside : weights.sets_cut_below(2 - kWhole)) {
      ProgramRow row{{}, 2, false};
      for (std::size_t i = 0; i < connections_.size(); ++i)
        if (inside[connections_[i].a / 2] != inside[connections_[i].b / 2])
          row.variables.push_back(static_cast<int>(i));
      rows_.push_back(std::move(row));
      ++added;
    }
    return added;
  }

  /// One solution of CBC in whole numbers, over the kept connections; its values go to values_.
  Answer solve_whole(double seconds, double& found_s) {
    const std::unique_ptr<Cbc_Model, decltype(&Cbc_deleteModel)> model(Cbc_newModel(), &Cbc_deleteModel);
    Cbc_setParameter(model.get(), "logLevel", "0");
    Cbc_setLogLevel(model.get(), 0);
    Cbc_setParameter(model.get(), "seconds", std::to_string(seconds).c_str());
    Cbc_setParameter(model.get(), "ratioGap", "0");
    Cbc_setParameter(model.get(), "allowableGap", "1e-7");
    std::vector<int> column(connections_.size(), -1);
    for (const int kept : kept_) {
      column[static_cast<std::size_t>(kept)] = Cbc_getNumCols(model.get());
      Cbc_addCol(model.get(), std::to_string(kept).c_str(), 0, 1,
                 connections_[static_cast<std::size_t>(kept)].cost_s, 1, 0, nullptr, nullptr);
    }
    for (const ProgramRow& row : rows_) {
      std::vector<int> variables;
      for (const int variable : row.variables)
        if (column[static_cast<std::size_t>(variable)] >= 0)
          variables.push_back(column[static_cast<std::size_t>(variable)]);
      const std::vector<double> ones(variables.size(), 1);
      Cbc_addRow(model.get(), "", static_cast<int>(variables.size()), variables.data(), ones.data(),
                 row.exact ? 'E' : 'G', row.least);
    }
    Cbc_solve(model.get());
    if (Cbc_isProvenInfeasible(model.get()) != 0) return Answer::kNone;
    if (Cbc_isProvenOptimal(model.get()) == 0) return Answer::kTimeOut;
    found_s = Cbc_getObjValue(model.get());
    const double* solution = Cbc_getColSolution(model.get());
    values_.assign(connections_.size(), 0);
    for (std::size_t i = 0; i < kept_.size(); ++i) values_[static_cast<std::size_t>(kept_[i])] = solution[i];
    return Answer::kFound;
  }

  std::vector<Connection> connections_;
  std::size_t lines_;
  std::vector<ProgramRow> rows_;
  std::vector<int> kept_;
  std::vector<double> values_;
};

}  // namespace

LeastTour least_tour(const order::EndCosts& costs, double known_s, double seconds) {
  return TourProgram(costs).solve(known_s, seconds);
}

}  // namespace tramline::testing
