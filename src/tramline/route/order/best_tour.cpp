#include "tramline/route/order/best_tour.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "tramline/route/order/land_pattern.h"
#include "tramline/route/order/shorten.h"
#include "tramline/route/order/skip_pattern.h"
#include "tramline/route/order/tours.h"

namespace tramline::order {
namespace {

/// The factor by which hops along straight lines may exceed the shortest found, whether to keep clear of
/// obstacles or because the way round is what counts.
constexpr double kMostAbove = 1.2;
/// Hops are far outside the field where the way round is longer by so many working widths.
constexpr double kFar_widths = 2;
/// The prices of a hop through an obstacle or far outside where such hops are to be avoided, as shares of the
/// length of all hops, the highest first.
constexpr std::array kClear{1.0, 0.2, 0.05};
constexpr std::size_t kFewLines = 200;

std::vector<Stretch> each_by_itself(std::size_t lines) {
  std::vector<Stretch> out;
  for (std::size_t i = 0; i < lines; ++i) out.push_back({{2 * i, 2 * i + 1}});
  return out;
}

std::size_t place_of(std::size_t line, const Tour& tour) {
  const auto found = std::find_if(tour.begin(), tour.end(), [&](End end) { return line_of(end) == line; });
  return static_cast<std::size_t>(found - tour.begin());
}

/// The direction of the tour in which the first line comes in the first half; where it comes in the middle,
/// the one in which it is driven forwards.
Tour turned(Tour tour) {
  const std::size_t first = place_of(0, tour), last = tour.size() - 1 - first;
  if (first > last || (first == last && !is_start(tour[first]))) return backwards(tour);
  return tour;
}

/// Nearest-neighbour tours from the start of the first line and, where there are few lines, from others: of
/// these a local search may miss the best, and more of them take no time.
std::vector<Tour> nearest_neighbours(const HopCosts& costs) {
  const std::size_t ends = 2 * costs.lines(),
                    count = std::clamp<std::size_t>(kFewLines / costs.lines(), 1, ends);
  std::vector<Tour> out;
  for (std::size_t i = 0; i < count; ++i) out.push_back(nearest_neighbour(costs, i * ends / count));
  return out;
}

class Search {
 public:
  Search(const std::vector<WorkedLine>& lines, const Field& field, double width_m)
      : blocks_(blocks_of(lines, width_m)),
        ground_(field, kFar_widths * width_m),
        costs_(lines, ground_),
        stretches_(each_by_itself(lines.size())),
        near_(near_ends(stretches_, costs_)),
        prices_{true, 0, width_m},
        by_track_(track_by_track(lines, costs_)),
        by_nearest_(nearest_neighbours(costs_)) {}

  Tour run() {
    Tour best = best_under(prices_, by_nearest_);
    if (!allowed(best))
      best = best_under({false, 0, 0},
                        {by_nearest_.front(), by_track_, nearest_neighbour(costs_, best.front())});
    const double longest_m = kMostAbove * length_m(best, costs_);
    const int barred = barred_hops(best, costs_);
    for (std::size_t i = 0; i < kClear.size() && barred > 0; ++i) {
      HopPrices clear = prices_;
      clear.barred_m = kClear[i] * length_m(best, costs_);
      Tour other = best_under(clear, by_nearest_);
      if (barred_hops(other, costs_) >= barred) break;
      if (allowed(other) && length_m(other, costs_) <= longest_m) return other;
    }
    return best;
  }

 private:
  bool allowed(const Tour& tour) {
    const double whole_m = length_m(tour, costs_), by_track_m = length_m(by_track_, costs_);
    const double by_nearest_m = std::min(length_m(by_nearest_.front(), costs_),
                                         length_m(nearest_neighbour(costs_, tour.front()), costs_));
    if (whole_m > kMostAbove * std::min(by_nearest_m, by_track_m)) return false;
    return whole_m <= by_track_m || barred_hops(tour, costs_) < barred_hops(by_track_, costs_);
  }

  /// The cheapest result of going block by block and of other initial tours; among equals the first.
  Tour best_under(const HopPrices& prices, const std::vector<Tour>& others) {
    costs_.set_prices(prices);
    Tour best = shortened(block_by_block(blocks_, costs_));
    double least = cost(best, costs_);
    for (const Tour& start : others) {
      Tour tour = shortened(start);
      const double whole = cost(tour, costs_);
      if (whole >= least) continue;
      least = whole;
      best = std::move(tour);
    }
    return turned(std::move(best));
  }

  Tour shortened(Tour tour) {
    shorten(tour, stretches_, near_, costs_);
    return tour;
  }

  std::vector<Block> blocks_;
  HopGround ground_;
  HopCosts costs_;
  std::vector<Stretch> stretches_;
  NearEnds near_;
  HopPrices prices_;
  Tour by_track_;
  std::vector<Tour> by_nearest_;
};

/// Block by block. `pattern(tracks)`: the order of so many neighbouring tracks.
template <class Pattern>
Tour patterned_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m,
                    const Pattern& pattern) {
  if (lines.empty()) return {};
  const HopGround ground(field, kFar_widths * width_m);
  HopCosts costs(lines, ground);
  std::vector<Block> blocks;
  for (const Block& block : blocks_of(lines, width_m)) {
    Block ordered;
    for (const std::size_t place : pattern(block.size())) ordered.push_back(block[place]);
    blocks.push_back(std::move(ordered));
  }
  return block_by_block(blocks, costs);
}

}  // namespace

Tour best_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m) {
  if (lines.empty()) return {};
  return Search(lines, field, width_m).run();
}

Tour skip_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m, std::size_t jump) {
  return patterned_tour(lines, field, width_m,
                        [jump](std::size_t tracks) { return skip_pattern(tracks, jump); });
}

Tour land_tour(const std::vector<WorkedLine>& lines, const Field& field, double width_m, std::size_t land) {
  return patterned_tour(lines, field, width_m,
                        [land](std::size_t tracks) { return land_pattern(tracks, land); });
}

std::vector<TrackPiece> pieces_on(const Tour& tour, const std::vector<WorkedLine>& lines) {
  std::vector<TrackPiece> out;
  for (const End end : tour) {
    WorkedLine line = lines[line_of(end)];
    if (!is_start(end)) line = backwards(std::move(line));
    std::move(line.begin(), line.end(), std::back_inserter(out));
  }
  return out;
}

}  // namespace tramline::order
