#include "tramline/planner/repair/repair_choice.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/geometry/tolerances.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/repair/line_positions.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

constexpr int kMostRounds = 8;
/// With more lines than these, exchanges of two and more than two rounds take longer than they win.
constexpr std::size_t kManyLines = 80;

/// The gaps that rows of lines are laid for.
enum class RowsOver { kAllGaps, kOneGap };

/// A position with its lines over the open land.
struct CandidateLine {
  LinePosition position;
  std::vector<RepairLine> lines;
  bool stale = true;
};

class Choice {
 public:
  Choice(RepairGround& ground, std::vector<CandidateLine> candidates, const SearchContext& context)
      : ground_(ground), candidates_(std::move(candidates)), context_(context) {
    refresh();
  }

  const std::vector<CandidateLine>& candidates() const { return candidates_; }
  const std::vector<RepairLine>& lines() const { return lines_; }
  double cost() const { return cost_with(lines_, ground_); }

  /// Rows of lines over wide gaps, the largest gap first, going on over other gaps in line or not.
  void lay_rows(RowsOver what) {
    std::vector<std::size_t> order(ground_.gaps());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
      return area(ground_.gap(a)) > area(ground_.gap(b));
    });
    for (const std::size_t gap : order) lay_rows(gap, what);
  }

  /// Adds lines as long as one is worth more than the turn to it.
  void grow(std::size_t most = static_cast<std::size_t>(-1)) {
    for (std::size_t i = 0; i < most; ++i) {
      const RepairLine* line = best();
      if (line == nullptr || line->worth - turn() <= kLeastGain_cost) return;
      add(RepairLine(*line));
    }
  }

  void improve() {
    const int rounds = lines_.size() > kManyLines ? 2 : kMostRounds;
    for (int round = 0; round < rounds; ++round) {
      bool better = false;
      for (std::size_t i = 0; i < lines_.size(); ++i) better = exchange({i}) || better;
      for (std::size_t i = 0; i < lines_.size() && lines_.size() <= kManyLines; ++i)
        for (std::size_t j = i + 1; j < lines_.size(); ++j)
          if (are_neighbours(lines_[i], lines_[j])) better = exchange({i, j}) || better;
      grow();
      if (!better) return;
    }
  }

 private:
  double turn() const { return ground_.terms().objective.turn; }

  void refresh() {
    std::vector<std::size_t> stale;
    for (std::size_t i = 0; i < candidates_.size(); ++i)
      if (candidates_[i].stale) stale.push_back(i);
    for_each_index(stale.size(), context_, [&](std::size_t k) {
      CandidateLine& candidate = candidates_[stale[k]];
      candidate.lines = ground_.lines_at(candidate.position);
      candidate.stale = false;
    });
  }

  /// The line that is worth most; among equals the one that works most, then the first.
  const RepairLine* best() {
    refresh();
    const RepairLine* out = nullptr;
    for (const CandidateLine& candidate : candidates_)
      for (const RepairLine& line : candidate.lines)
        if (out == nullptr || line.worth > out->worth + kLeastGain_cost ||
            (line.worth > out->worth - kLeastGain_cost &&
             line.line.covered_m2 > out->line.covered_m2 + kLeastGain_m2))
          out = &line;
    return out;
  }

  void add(RepairLine line) {
    const LinePosition position = line.position;
    lines_.push_back(std::move(line));
    changed(lines_.back().swaths);
    const double width_m = ground_.terms().machine.width_m;
    for (const double left_m : {position.left_m - width_m, position.left_m + width_m}) {
      const bool known =
          std::any_of(candidates_.begin(), candidates_.end(), [&](const CandidateLine& candidate) {
            return candidate.position.direction == position.direction &&
                   std::abs(candidate.position.left_m - left_m) < kSamePlace_m;
          });
      if (!known) candidates_.push_back({{position.direction, left_m}, {}, true});
    }
  }

  /// Marks candidates near swaths that were added or removed: their lines have changed.
  void changed(const Region& swaths) {
    ground_.cover(lines_, swaths);
    const double width_m = ground_.terms().machine.width_m;
    std::vector<Box> boxes;
    for (std::size_t d = 0; d < ground_.directions(); ++d)
      boxes.push_back(bounds(ground_.frame(d).to_track(swaths)));
    for (std::size_t i = 0; i < candidates_.size(); ++i) {
      CandidateLine& candidate = candidates_[i];
      const Box& box = boxes[candidate.position.direction];
      if (candidate.stale || candidate.position.left_m >= box.max_x ||
          candidate.position.left_m + width_m <= box.min_x)
        continue;
      if (saved_ != nullptr) saved_->emplace_back(i, candidate);
      candidate.stale = true;
    }
  }

  void lay_rows(std::size_t gap, RowsOver what) {
    const double width_m = ground_.terms().machine.width_m;
    constexpr double kWide = 1.25;
    std::vector<RepairLine> best;
    double most = 0;
    for (std::size_t d = 0; d < ground_.directions(); ++d) {
      const std::vector<std::size_t>& gaps = ground_.gaps_in(d);
      if (!std::binary_search(gaps.begin(), gaps.end(), gap)) continue;
      const Region open = ground_.frame(d).to_track(ground_.open(gap));
      if (open.empty() || bounds(open).width() < kWide * width_m) continue;
      for (const double first_m : first_lefts(bounds(open), width_m)) {
        double worth = 0;
        std::vector<RepairLine> rows = rows_from({d, first_m}, bounds(open).max_x, gap, what, worth);
        if (worth > most + kLeastGain_cost) {
          most = worth;
          best = std::move(rows);
        }
      }
    }
    for (RepairLine& line : best) add(std::move(line));
  }

  static std::vector<double> first_lefts(const Box& box, double width_m) {
    const double rows = std::ceil(box.width() / width_m - kRounding_share);
    std::vector<double> out{box.min_x, box.max_x - rows * width_m,
                            0.5 * (box.min_x + box.max_x - rows * width_m)};
    for (int k = 1; k < 8; ++k) out.push_back(box.min_x - k * width_m / 8);
    return out;
  }

  std::vector<RepairLine> rows_from(LinePosition position, double until_m, std::size_t gap, RowsOver what,
                                    double& worth) const {
    std::vector<RepairLine> out;
    for (; position.left_m < until_m; position.left_m += ground_.terms().machine.width_m)
      for (RepairLine& line :
           what == RowsOver::kAllGaps ? ground_.lines_at(position) : ground_.lines_at(position, gap)) {
        const double gain = line.worth - turn();
        if (gain <= kLeastGain_cost) continue;
        worth += gain;
        out.push_back(std::move(line));
      }
    return out;
  }

  /// Whether two lines are side by side or one behind the other.
  bool are_neighbours(const RepairLine& a, const RepairLine& b) const {
    return a.position.direction == b.position.direction &&
           std::abs(a.position.left_m - b.position.left_m) < 2 * ground_.terms().machine.width_m;
  }

  /// Replaces these lines by the best ones, where that costs less.
  bool exchange(const std::vector<std::size_t>& indices) {
    if (context_.has_to_end()) return false;
    refresh();
    const double before = cost();
    const std::vector<RepairLine> lines = lines_;
    const std::size_t known = candidates_.size();
    std::vector<std::pair<std::size_t, CandidateLine>> saved;
    saved_ = &saved;
    Region swaths;
    for (auto i = indices.rbegin(); i != indices.rend(); ++i) {
      const Region& of_line = lines_[*i].swaths;
      swaths.insert(swaths.end(), of_line.begin(), of_line.end());
      lines_.erase(lines_.begin() + static_cast<std::ptrdiff_t>(*i));
    }
    changed(swaths);
    const std::size_t kept = lines_.size();
    grow(indices.size() + 1);
    saved_ = nullptr;
    if (cost() < before - kLeastGain_cost) return true;
    for (std::size_t i = kept; i < lines_.size(); ++i)
      swaths.insert(swaths.end(), lines_[i].swaths.begin(), lines_[i].swaths.end());
    lines_ = lines;
    candidates_.resize(known);
    for (auto i = saved.rbegin(); i != saved.rend(); ++i)
      if (i->first < known) candidates_[i->first] = std::move(i->second);
    ground_.cover(lines_, swaths);
    return false;
  }

  RepairGround& ground_;
  std::vector<CandidateLine> candidates_;
  std::vector<RepairLine> lines_;
  SearchContext context_;
  std::vector<std::pair<std::size_t, CandidateLine>>* saved_ = nullptr;  ///< as they were, during an exchange
};

}  // namespace

double cost_with(const std::vector<RepairLine>& lines, const RepairGround& ground) {
  const Objective& objective = ground.terms().objective;
  const double open_m2 = ground.open_m2();
  double whole_m2 = 0, sum = objective.uncovered * open_m2;
  for (std::size_t i = 0; i < ground.gaps(); ++i) whole_m2 += area(ground.gap(i));
  double covered_by_each_m2 = 0;
  for (const RepairLine& line : lines) {
    sum += price_of(line.line, ground.terms());
    covered_by_each_m2 += line.line.covered_m2;
  }
  sum += objective.overlap * (covered_by_each_m2 - (whole_m2 - open_m2));
  return sum + objective.turn * static_cast<double>(lines.size());
}

std::vector<RepairLine> chosen_lines(RepairGround& ground, const SearchContext& context) {
  std::vector<CandidateLine> candidates;
  for (const LinePosition& position : line_positions(ground)) candidates.push_back({position, {}, true});
  const Region everywhere{ground.free()};
  constexpr int kSteps = 4;
  std::vector<RepairLine> best;
  double least = 0;
  for (int step = 0; step < kSteps; ++step) {
    context.count(step, kSteps);
    ground.cover({}, everywhere);
    Choice choice(ground, candidates, context);
    if (step == 0) {  // looks at all places: the next ones begin with what it found
      candidates = choice.candidates();
      least = choice.cost();
      continue;
    }
    if (step > 1 && context.has_to_end()) break;
    if (step > 1) choice.lay_rows(step == 2 ? RowsOver::kAllGaps : RowsOver::kOneGap);
    if (step > 1 && choice.lines().empty()) break;
    choice.grow();
    choice.improve();
    if (choice.cost() >= least - kLeastGain_cost) continue;
    least = choice.cost();
    best = choice.lines();
  }
  ground.cover(best, everywhere);
  return best;
}

}  // namespace tramline
