#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "tramline/check/prices/dearest_piece.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/polygon/convex_clip.h"

namespace tramline::check {
namespace {

/// Cells may overlap by as much as the rounding of their corners, m.
constexpr double kCornerRounding_m = 1e-5;
/// More cells than any plan has take long to compare.
constexpr std::size_t kMostCells = 5000;

bool is_convex(const Ring& ring) {
  if (ring.size() < 3) return false;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
    if (!(cross(b - a, c - b) >= 0)) return false;
  }
  return signed_area(ring) > 0;
}

class Prices {
 public:
  Prices(const Plan& plan, Violations& out) : plan_(plan), proof_(plan.proof.prices), out_(out) {}

  void run() {
    if (!are_sound()) return;
    PricedLand land{land_of(), passable(), &proof_, plan_.objective.overlap};
    const double sum = worth_of(land.land), turn = plan_.objective.turn;
    if (!(proof_.bound <= sum - turn + kAreaShare * sum))
      add(fmt::format("the prices of the land prove that no plan costs less than {:.6f}, not {:.6f}",
                      sum - turn, proof_.bound),
          proof_.cells.front().shape.front(), proof_.bound - sum + turn);
    if (const std::optional<DearPiece> dear = dear_piece(plan_, land))
      add(fmt::format("a piece of direction {:.3f}° may be worth {:.6f} by the prices of its land, more than "
                      "its turn costs, {:.6f}",
                      dear->direction.degrees(), dear->worth, turn),
          dear->at, dear->worth - turn);
  }

 private:
  void add(std::string what, Point at, double amount) {
    out_.push_back({Rule::kProof, std::move(what), at, amount});
  }

  bool are_sound() {
    const Point at = plan_.field.outer.front();
    if (!std::isfinite(proof_.bound))
      add(fmt::format("the bound by prices of the land is {}", proof_.bound), at, 0);
    if (proof_.cells.empty()) {
      if (proof_.bound > 0)
        add(fmt::format("there are no prices of the land that prove the bound of {:.6f}", proof_.bound), at,
            proof_.bound);
      return false;
    }
    if (proof_.cells.size() > kMostCells) {
      add(fmt::format("the land has {} cells with prices, more than {}", proof_.cells.size(), kMostCells), at,
          static_cast<double>(proof_.cells.size()));
      return false;
    }
    const std::size_t before = out_.size();
    for (const GroundPrices::Cell& cell : proof_.cells) check_cell(cell);
    if (out_.size() == before) check_apart();
    return out_.size() == before && std::isfinite(proof_.bound) && plan_.objective.turn >= 0 &&
           plan_.objective.overlap >= 0 && !plan_.body.empty();
  }

  void check_cell(const GroundPrices::Cell& cell) {
    const Point at = cell.shape.empty() ? plan_.field.outer.front() : cell.shape.front();
    if (!is_convex(cell.shape))
      add(fmt::format("a cell with the price {:.6f} is not convex", cell.price), at, 0);
    if (!(cell.price >= 0 && cell.price <= plan_.objective.uncovered * (1 + kSaidTwice)))
      add(fmt::format("the price of a cell is {:.6f}, not between 0 and {:.6f}, that of uncovered land",
                      cell.price, plan_.objective.uncovered),
          at, cell.price);
  }

  /// Land in two cells would have the price of either.
  void check_apart() {
    const std::vector<GroundPrices::Cell>& cells = proof_.cells;
    std::vector<Box> boxes;
    for (const GroundPrices::Cell& cell : cells) boxes.push_back(bounds(cell.shape));
    for (std::size_t i = 0; i < cells.size(); ++i)
      for (std::size_t k = 0; k < i; ++k) {
        if (!intersects(boxes[i], boxes[k])) continue;
        const Ring common = convex_intersection(cells[i].shape, cells[k].shape);
        if (common.size() < 3) continue;
        const double common_m2 = std::abs(signed_area(common));
        if (common_m2 <= kCornerRounding_m * (boxes[i].width() + boxes[i].height())) continue;
        add(fmt::format("two cells with prices have {:.6f} m² in common", common_m2), common.front(),
            common_m2);
        return;
      }
  }

  Region land_of() const {
    return plan_.given_up.empty() ? plan_.body : difference(plan_.body, plan_.given_up);
  }
  Region passable() const {
    Region out;
    for (const Obstacle& obstacle : plan_.field.obstacles)
      if (obstacle.kind == ObstacleKind::kPassable) out.push_back(obstacle.shape);
    return out;
  }

  double worth_of(const Region& land) const {
    std::vector<Ring> rings = rings_of(land);
    double sum = 0;
    for (const GroundPrices::Cell& cell : proof_.cells)
      sum += cell.price * signed_area(clipped(rings, convex_set(cell.shape)));
    return sum;
  }

  const Plan& plan_;
  const GroundPrices& proof_;
  Violations& out_;
};

}  // namespace

void check_prices(const Plan& plan, Violations& out) { Prices(plan, out).run(); }

}  // namespace tramline::check
