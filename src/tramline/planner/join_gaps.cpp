#include "tramline/planner/join_gaps.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/interior_point.h"
#include "tramline/planner/for_each_index.h"

namespace tramline {
namespace {

constexpr std::size_t kNeighbours = 8;
constexpr double kReach_widths = 30;
constexpr double kLeastSaving = 1e-6;  ///< less is rounding

double distance_between(const Box& a, const Box& b) {
  return std::hypot(std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x}),
                    std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y}));
}

const Polygon& largest(const Region& gaps) {
  return *std::max_element(gaps.begin(), gaps.end(),
                           [](const Polygon& a, const Polygon& b) { return area(a) < area(b); });
}

struct Pair {
  std::size_t a = 0, b = 0;
  GapGroup whole;
  double saving = 0;
};

class Joining {
 public:
  Joining(std::vector<GapGroup> groups, const Region& free, const Region& obstacles, const RepairTerms& terms,
          int threads)
      : groups_(std::move(groups)),
        gone_(groups_.size(), false),
        free_(free),
        obstacles_(obstacles),
        terms_(terms),
        threads_(threads) {
    for (const GapGroup& group : groups_) boxes_.push_back(bounds(group.ground.gaps));
  }

  std::vector<GapGroup> run() {
    std::vector<std::pair<std::size_t, std::size_t>> wanted;
    for (std::size_t i = 0; i < groups_.size(); ++i) append_neighbours(i, wanted);
    look(std::move(wanted));
    while (!pairs_.empty()) {
      const auto best = std::max_element(pairs_.begin(), pairs_.end(),
                                         [](const Pair& x, const Pair& y) { return x.saving < y.saving; });
      join(std::move(*best));
    }
    std::vector<GapGroup> out;
    for (std::size_t i = 0; i < groups_.size(); ++i)
      if (!gone_[i]) out.push_back(std::move(groups_[i]));
    return out;
  }

 private:
  void join(Pair pair) {
    const std::size_t a = pair.a, b = pair.b;
    groups_[a] = std::move(pair.whole);
    boxes_[a].extend(boxes_[b]);
    gone_[b] = true;
    std::vector<std::pair<std::size_t, std::size_t>> wanted;
    for (const Pair& old : pairs_)
      for (const std::size_t i : {old.a, old.b})
        if (i != a && i != b && (old.a == a || old.a == b || old.b == a || old.b == b))
          wanted.emplace_back(std::min(a, i), std::max(a, i));
    std::erase_if(pairs_,
                  [&](const Pair& old) { return old.a == a || old.b == a || old.a == b || old.b == b; });
    append_neighbours(a, wanted);
    look(std::move(wanted));
  }

  void append_neighbours(std::size_t of, std::vector<std::pair<std::size_t, std::size_t>>& out) const {
    std::vector<std::pair<double, std::size_t>> near;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
      if (i == of || gone_[i]) continue;
      const double apart_m = distance_between(boxes_[of], boxes_[i]);
      if (apart_m <= kReach_widths * terms_.machine.width_m) near.emplace_back(apart_m, i);
    }
    std::sort(near.begin(), near.end());
    if (near.size() > kNeighbours) near.resize(kNeighbours);
    for (const auto& [apart_m, i] : near) out.emplace_back(std::min(of, i), std::max(of, i));
  }

  void look(std::vector<std::pair<std::size_t, std::size_t>> wanted) {
    std::sort(wanted.begin(), wanted.end());
    wanted.erase(std::unique(wanted.begin(), wanted.end()), wanted.end());
    std::vector<std::optional<Pair>> found(wanted.size());
    for_each_index(wanted.size(), threads_,
                   [&](std::size_t i) { found[i] = joined(wanted[i].first, wanted[i].second); });
    for (std::optional<Pair>& pair : found)
      if (pair) pairs_.push_back(std::move(*pair));
  }

  std::optional<Pair> joined(std::size_t a, std::size_t b) const {
    const GapGroup &first = groups_[a], &second = groups_[b];
    Region gaps = first.ground.gaps;
    gaps.insert(gaps.end(), second.ground.gaps.begin(), second.ground.gaps.end());
    const double width_m = terms_.machine.width_m;
    GapGround ground = gap_ground(std::move(gaps), free_, obstacles_, width_m);
    std::vector<Direction> directions{first.choice.lines.grid.frame.direction(),
                                      second.choice.lines.grid.frame.direction()};
    const Point from = interior_point(largest(first.ground.gaps));
    const Point to = interior_point(largest(second.ground.gaps));
    if (distance(from, to) > width_m) directions.push_back(Direction::along(from, to));
    for (const Direction direction : gap_directions(ground, width_m, GapEffort::kGlance))
      directions.push_back(direction);
    directions = along_narrow_gaps(ground, width_m, directions);
    std::optional<GapChoice> choice = best_lines(ground, directions, terms_, 0, kTail_m, ShortLines::kDrive);
    if (!choice) return std::nullopt;
    const double saving = first.choice.price + second.choice.price - choice->price;
    if (saving <= kLeastSaving) return std::nullopt;
    return Pair{a, b, {std::move(ground), std::move(*choice)}, saving};
  }

  std::vector<GapGroup> groups_;
  std::vector<Box> boxes_;
  std::vector<bool> gone_;
  std::vector<Pair> pairs_;
  const Region& free_;
  const Region& obstacles_;
  const RepairTerms& terms_;
  int threads_;
};

}  // namespace

std::vector<GapGroup> join_where_it_pays(std::vector<GapGroup> groups, const Region& free,
                                         const Region& obstacles, const RepairTerms& terms, int threads) {
  return Joining(std::move(groups), free, obstacles, terms, threads).run();
}

}  // namespace tramline
