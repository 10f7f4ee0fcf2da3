#include "tramline/planner/prove/ground_prices.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/prove/price_program.h"
#include "tramline/planner/prove/strip_sweep.h"

namespace tramline {
namespace {

constexpr int kMostLines = 10;
/// Rounds look at every so many directions; after them some look at all.
constexpr int kStride = 6, kWholeRounds = 2;
/// The former take so many samples across the width.
constexpr int kCoarseLines = 4;
/// A round finds no more pieces of one direction, and none that is worth less more than its turn.
constexpr std::size_t kMostPieces = 4;
constexpr double kExcess = 0.002;
/// What is proven once more by another sweep is allowed so much.
constexpr double kMargin = 0.004;
/// Areas that are measured another way differ by less.
constexpr double kAreaRounding = 1e-6;

/// What came of one direction.
struct Looked {
  double most = 0;
  std::vector<PieceWorth> pieces;  ///< worth more than their turn
};

class PriceSearch {
 public:
  PriceSearch(const SearchTask& task, Direction along, const SearchContext& context,
              const PriceEffort& effort)
      : context_(context), effort_(effort), price_(task.objective), width_m_(task.machine.width_m) {
    const Region& ground = task.ground.plannable;
    const Region land = task.ground.passable.empty() ? ground : difference(ground, task.ground.passable);
    grid_ = price_grid(land, ground, along, effort.most_cells, width_m_ / 3);
    const TrackFrame& frame = grid_.frame;
    const Region turned = frame.to_track(land);
    set_scale(bounds(frame.to_track(ground)));
    labels_ = std::make_unique<GroundLabels>(grid_, turned, frame.to_track(task.ground.passable),
                                             scale_.reach_m(), 0.5 * scale_.step_m());
  }

  GroundPrices run() {
    std::vector<double> inside_m2;
    for (const PriceGrid::Cell& cell : grid_.cells) inside_m2.push_back(cell.inside_m2);
    PriceProgram program(inside_m2, price_.uncovered);
    // Prices that no piece collects more of than its turn, if only because none is so long.
    std::vector<double> prices(inside_m2.size(),
                               std::min(price_.uncovered, price_.turn / (2 * width_m_ * scale_.radius_m)));
    std::vector<double> best;
    double most_value = 0;
    for (int round = 0; round < effort_.rounds && !context_.has_to_end(); ++round) {
      const double excess = look(prices, coarse(), kStride, round % kStride, program);
      scale(prices, excess);
      if (const double value = worth_of_land(prices); best.empty() || value > most_value) {
        most_value = value;
        best = prices;
      }
      const std::vector<double> proposed = program.prices();
      // Between the best known and the proposal, which alone would jump to and fro.
      for (std::size_t i = 0; i < prices.size(); ++i) prices[i] = 0.5 * (best[i] + proposed[i]);
    }
    GroundPrices out;
    prices = best;
    for (int round = 0; round < kWholeRounds && !best.empty() && !context_.has_to_end(); ++round) {
      scale(prices, look(prices, scale_, 1, 0, program) * (1 + kMargin));
      if (worth_of_land(prices) - price_.turn > out.bound) {
        best = prices;
        out = as_proof(best);
      }
      const std::vector<double> proposed = program.prices();
      for (std::size_t i = 0; i < prices.size(); ++i) prices[i] = 0.5 * (best[i] + proposed[i]);
    }
    return out;
  }

 private:
  void set_scale(const Box& box) {
    pivot_ = box.centre();
    scale_.width_m = width_m_;
    scale_.radius_m = 0.5 * std::hypot(box.width(), box.height());
    const double step_m =
        std::cbrt(std::numbers::pi * scale_.radius_m * box.width() * box.height() / effort_.samples);
    scale_.lines = std::clamp(static_cast<int>(width_m_ / step_m), effort_.fewest_lines, kMostLines);
    directions_ =
        std::max(kStride, static_cast<int>(std::ceil(std::numbers::pi * scale_.radius_m / scale_.step_m())));
    scale_.half_angle = std::numbers::pi / (2 * directions_);
  }

  /// For rounds that prove nothing.
  SweepScale coarse() const {
    SweepScale out = scale_;
    out.lines = std::min(out.lines, kCoarseLines);
    return out;
  }

  double worth_of_land(const std::vector<double>& prices) const {
    double sum = 0;
    for (std::size_t i = 0; i < prices.size(); ++i) sum += prices[i] * grid_.cells[i].inside_m2;
    return sum;
  }

  /// Lowers prices so that no piece is worth more than its turn: land that is none stays as it is.
  void scale(std::vector<double>& prices, double most) const {
    if (most <= price_.turn) return;
    for (double& price : prices) price *= price_.turn / most;
  }

  GroundPrices as_proof(const std::vector<double>& prices) const {
    GroundPrices out;
    for (std::size_t i = 0; i < prices.size(); ++i) {
      if (!(prices[i] > 0)) continue;
      const Box box = grid_.box(grid_.cells[i]);
      Ring shape;
      for (const Point corner : {Point{box.min_x, box.min_y}, Point{box.max_x, box.min_y},
                                 Point{box.max_x, box.max_y}, Point{box.min_x, box.max_y}})
        shape.push_back(grid_.frame.to_field(corner));
      out.cells.push_back({std::move(shape), prices[i]});
    }
    out.bound = (1 - kAreaRounding) * worth_of_land(prices) - price_.turn;
    return out;
  }

  /// Sweeps every so many directions, adds to the program what is worth too much, and returns the most that
  /// any piece is worth.
  double look(const std::vector<double>& prices, const SweepScale& by, int stride, int phase,
              PriceProgram& program) const {
    const PixelWorth worth = labels_->worth(prices, price_.overlap);
    std::vector<Looked> found(static_cast<std::size_t>((directions_ - phase + stride - 1) / stride));
    for_each_index(found.size(), context_.uncounted(), [&](std::size_t i) {
      const double angle = (2 * (phase + stride * static_cast<double>(i)) + 1) * scale_.half_angle;
      found[i] = look_along(angle, by, worth);
    });
    double most = 0;
    for (const Looked& one : found) {
      most = std::max(most, one.most);
      for (const PieceWorth& piece : one.pieces)
        program.add(piece, price_.turn + price_.overlap * piece.outside_m2);
    }
    return most;
  }

  Looked look_along(double angle, const SweepScale& by, const PixelWorth& worth) const {
    StripSweep sweep(*labels_, worth, by, pivot_);
    sweep.lay(angle);
    Looked out;
    out.most = sweep.most();
    // One at most for each width.
    std::vector<int> offsets;
    for (int from = 0; from < sweep.offsets(); from += by.lines) {
      int best = from;
      for (int k = from; k < std::min(sweep.offsets(), from + by.lines); ++k)
        if (sweep.worth(k) > sweep.worth(best)) best = k;
      if (sweep.worth(best) > price_.turn * (1 + kExcess)) offsets.push_back(best);
    }
    std::stable_sort(offsets.begin(), offsets.end(),
                     [&](int a, int b) { return sweep.worth(a) > sweep.worth(b); });
    if (offsets.size() > kMostPieces) offsets.resize(kMostPieces);
    for (const int offset : offsets) out.pieces.push_back(sweep.piece(offset));
    return out;
  }

  SearchContext context_;
  PriceEffort effort_;
  Objective price_;
  double width_m_;
  PriceGrid grid_;
  Point pivot_;
  SweepScale scale_;
  int directions_ = 1;
  std::unique_ptr<GroundLabels> labels_;
};

}  // namespace

GroundPrices proven_prices(const SearchTask& task, Direction along, const SearchContext& context,
                           const PriceEffort& effort) {
  // Detours round an obstacle would work land beside the strips that are swept.
  if (!task.ground.hazards.empty() || task.ground.plannable.empty() || !(task.objective.turn > 0) ||
      !(task.objective.uncovered > 0))
    return {};
  return PriceSearch(task, along, context, effort).run();
}

}  // namespace tramline
