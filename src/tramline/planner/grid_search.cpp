#include "tramline/planner/grid_search.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <queue>

#include "tramline/decomposition/candidate_directions.h"
#include "tramline/planner/for_each_index.h"
#include "tramline/planner/turned_ground.h"

namespace tramline {
namespace {

constexpr double kHalfTurn = std::numbers::pi;
constexpr std::size_t kKept = 12;            ///< grids that are told apart
constexpr std::size_t kBatch = 8;            ///< boxes divided at a time, for any number of threads
constexpr double kNearBest = 0.15;           ///< small steps hardly better a grid by more
constexpr int kLookEvery = 200;              ///< boxes, after which the search gives up if …
constexpr double kLeastProgress = 0.025;     ///< … no more than this share of the gap has been closed
constexpr double kLeastWhereHindered = 0.1;  ///< … or this one where obstacles keep the bound from the cost
const Angle kFirstTurn = Angle::degrees(0.4);  ///< of the steps that better a grid …
const Angle kCoarse = Angle::degrees(0.1);     ///< … and where most of them stop
constexpr std::size_t kFollowed = 1;           ///< grids that are bettered by finer steps
constexpr double kFirstHalfAngle = kHalfTurn / 360;
constexpr double kLeastShift =
    1.0 / (1 << 18);  ///< widths by which the grids of a box differ that is not divided

/// A grid by its angle and by its offset from the pivot, across.
struct Place {
  double angle = 0;
  double offset_m = 0;
};

/// What a grid costs, and what it would with stops as cheap as turns: where there are ways round the
/// obstacles, few of the stops remain, and the one may rank grids wrongly where the other does not.
struct Prices {
  double cut = 0;
  double soft = 0;
  bool works = false;  ///< has a piece
};

struct Found {
  Place place;
  double cost = 0;
  bool works = false;
  bool polished = false;  ///< no small step betters it
};

/// Where turns are dear nothing is cheaper than to stay at home, which is no plan.
bool is_better(const Found& a, const Found& b) { return a.works != b.works ? a.works : a.cost < b.cost; }

/// The cheapest grids, no two of them nearly alike.
class Shortlist {
 public:
  explicit Shortlist(double width_m) : width_m_(width_m) {}

  void offer(const Found& found) {
    for (std::size_t i = 0; i < list_.size(); ++i) {
      if (!alike(list_[i].place, found.place)) continue;
      if (is_better(list_[i], found) || (!is_better(found, list_[i]) && !found.polished)) return;
      list_.erase(list_.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    }
    const auto at = std::upper_bound(list_.begin(), list_.end(), found, is_better);
    list_.insert(at, found);
    if (list_.size() > kKept) list_.pop_back();
  }
  const std::vector<Found>& list() const { return list_; }
  const Found& best() const { return list_.front(); }

 private:
  bool alike(const Place& a, const Place& b) const {
    const double turn = std::abs(std::remainder(a.angle - b.angle, kHalfTurn));
    const double shift = std::abs(std::remainder(a.offset_m - b.offset_m, width_m_));
    return turn < Angle::degrees(0.5).radians() && shift < width_m_ / 8;
  }

  double width_m_;
  std::vector<Found> list_;
};

struct SearchBox {
  Place middle;
  double half_angle = 0;
  double half_offset_m = 0;
  double bound = 0;
};

struct LaterBox {
  bool operator()(const SearchBox& a, const SearchBox& b) const {
    if (a.bound != b.bound) return a.bound > b.bound;
    if (a.middle.angle != b.middle.angle) return a.middle.angle > b.middle.angle;
    return a.middle.offset_m > b.middle.offset_m;
  }
};

/// Everything that a grid over the part is priced with.
class Pricing {
 public:
  Pricing(const SearchTask& task, const Polygon& part)
      : task_(task),
        part_(part),
        grid_{task.machine.width_m, min_length_m(task.machine),
              end_criterion(task.settings.end_rule, task.objective, task.machine.width_m)},
        soft_(task.objective),
        bound_{task.objective, bounds(part).centre(),
               std::max(task.machine.radius_m, 0.5 * task.machine.width_m)} {
    soft_.stop = std::min(soft_.stop, soft_.turn);
  }

  GridTally tally(double angle) const {
    const TrackFrame frame = this->frame(angle);
    return {frame, part_, turned_ground(task_, frame), grid_};
  }
  static TrackFrame frame(double angle) {
    return TrackFrame(Direction::clockwise_from_north(Angle::radians(angle)));
  }
  double origin(const GridTally& tally, double offset_m) const {
    return tally.subfield().frame.to_track(bound_.pivot).x + offset_m;
  }
  Prices prices(const GridTally& tally, double offset_m) const {
    const Tally sum = tally.at(origin(tally, offset_m));
    return {separate_cost(task_.objective, sum), separate_cost(soft_, sum), sum.pieces > 0};
  }
  Prices prices(const Place& place) const { return prices(tally(place.angle), place.offset_m); }
  double least(const GridTally& tally, const SearchBox& box, double enough) const {
    return least_cost(tally, bound_, {origin(tally, box.middle.offset_m), box.half_offset_m, box.half_angle},
                      enough);
  }
  PricedGrid priced(const Found& found) const {
    const TrackFrame frame = this->frame(found.place.angle);
    return {frame.direction(), frame.to_track(bound_.pivot).x + found.place.offset_m, found.cost};
  }
  const BoundTerms& bound() const { return bound_; }
  double width_m() const { return grid_.width_m; }
  double radius_m() const {
    const Box box = bounds(part_);
    return 0.5 * std::hypot(box.width(), box.height());
  }
  const Polygon& part() const { return part_; }

 private:
  const SearchTask& task_;
  const Polygon& part_;
  GridTerms grid_;
  Objective soft_;
  BoundTerms bound_;
};

/// Flush with each of the longest edges, in the order of what edges of one direction sum up to.
std::vector<Place> flush_places(const Pricing& pricing, std::size_t most) {
  struct Edges {
    double angle = 0, length = 0, longest = 0;
    Point at;
  };
  std::vector<Edges> all;
  for (const Ring& ring : rings_of({pricing.part()}))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[i + 1 == ring.size() ? 0 : i + 1];
      if (a == b) continue;
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      all.push_back({Direction::along(a, b).angle().radians(), length, length, a});
    }
  std::sort(all.begin(), all.end(), [](const Edges& a, const Edges& b) { return a.angle < b.angle; });
  std::vector<Edges> groups;
  for (const Edges& edge : all) {
    if (groups.empty() || edge.angle - groups.back().angle > kSameDirectionRadians) {
      groups.push_back(edge);
      continue;
    }
    Edges& group = groups.back();
    group.length += edge.length;
    if (edge.longest > group.longest) {
      group.longest = edge.longest;
      group.at = edge.at;
    }
  }
  std::stable_sort(groups.begin(), groups.end(),
                   [](const Edges& a, const Edges& b) { return a.length > b.length; });
  if (groups.size() > most) groups.resize(most);
  std::vector<Place> out;
  for (const Edges& group : groups) {
    const TrackFrame frame = Pricing::frame(group.angle);
    out.push_back({group.angle, frame.to_track(group.at).x - frame.to_track(pricing.bound().pivot).x});
  }
  return out;
}

class GridSearch {
 public:
  GridSearch(const SearchTask& task, const Polygon& part, const SearchEffort& effort, int threads)
      : pricing_(task, part),
        effort_(effort),
        threads_(threads),
        hindered_(!pricing_.tally(0).subfield().obstacles.empty()),
        list_(pricing_.width_m()),
        soft_list_(pricing_.width_m()) {}

  GridSearchResult run(const Rival& rival) {
    try_edges();
    if (effort_.scanned > 0) scan();
    if (!hindered_ || effort_.cut_too) polish(list_, false, effort_.polished);
    if (hindered_) polish(soft_list_, true, effort_.polished);
    if (rival) rival_ = rival(pricing_.priced((hindered_ ? soft_list_ : list_).best()));
    if (effort_.most_boxes > 0) {
      branch();
      polish(list_, false, hindered_ ? effort_.polished : kKept);
      if (hindered_) polish(soft_list_, true, effort_.polished);
    }
    GridSearchResult out;
    out.bound = std::min(bound_, list_.best().cost);
    out.boxes = boxes_;
    for (const Found& found : list_.list()) out.grids.push_back(pricing_.priced(found));
    if (hindered_)
      for (const Found& found : soft_list_.list()) out.unhindered.push_back(pricing_.priced(found));
    if (effort_.exact_offset && !hindered_) refine(out.grids.front());
    return out;
  }

 private:
  void offer(const Place& place, const Prices& prices) {
    list_.offer({place, prices.cut, prices.works});
    if (hindered_) soft_list_.offer({place, prices.soft, prices.works});
  }

  void try_edges() {
    const std::vector<Place> flush = flush_places(pricing_, effort_.most_edges);
    const std::size_t count = effort_.edge_offsets;
    std::vector<Place> places(count * flush.size());
    std::vector<Prices> prices(places.size());
    for_each_index(flush.size(), threads_, [&](std::size_t i) {
      const GridTally tally = pricing_.tally(flush[i].angle);
      const Box& reach = tally.subfield().reach;
      const double pivot = pricing_.origin(tally, 0);
      const double offsets[] = {flush[i].offset_m, reach.min_x - pivot, reach.max_x - pivot,
                                flush[i].offset_m + 0.5 * pricing_.width_m()};
      for (std::size_t k = 0; k < count; ++k) {
        places[count * i + k] = {flush[i].angle, offsets[k]};
        prices[count * i + k] = pricing_.prices(tally, offsets[k]);
      }
    });
    for (std::size_t i = 0; i < places.size(); ++i) offer(places[i], prices[i]);
  }

  /// Steps to better neighbours, halved where there is none.
  void polish(Shortlist& shortlist, bool soft, std::size_t most) {
    if (most == 0) return;
    std::vector<Found> found = shortlist.list();
    if (found.size() > most) found.resize(most);
    const double worth_it = found.front().cost + kNearBest * std::abs(found.front().cost);
    std::erase_if(found, [&](const Found& one) { return one.polished || one.cost > worth_it; });
    for_each_index(found.size(), threads_,
                   [&](std::size_t i) { improve(found[i], soft, kFirstTurn, kCoarse); });
    // Coarse steps tell which hollows are deep.
    std::stable_sort(found.begin(), found.end(), is_better);
    const bool finer = effort_.tolerance.radians() < kCoarse.radians();
    const std::size_t deep = finer ? std::min(found.size(), kFollowed) : 0;
    for_each_index(deep, threads_, [&](std::size_t i) {
      improve(found[i], soft, kCoarse, effort_.tolerance);
      found[i].polished = true;
    });
    for (const Found& one : found) shortlist.offer(one);
  }

  /// Along either axis, and such that what lies on a strip line at some place along the field stays on it:
  /// the cost jumps where a piece comes or goes, and the best grids lie along such cliffs.
  std::array<Place, 12> steps(double turn, double shift) const {
    const double reach = pricing_.radius_m();
    std::array<Place, 12> out{Place{turn, 0}, {-turn, 0}, {0, shift}, {0, -shift}};
    std::size_t i = 4;
    for (const double along : {-1.0, -0.5, 0.5, 1.0})
      for (const double sense : {turn, -turn}) out[i++] = {sense, sense * along * reach};
    return out;
  }

  /// By steps that turn by less and less, from one angle to half the other.
  void improve(Found& best, bool soft, Angle from, Angle to) const {
    double turn = from.radians(), shift = pricing_.width_m() / 8 * (from.radians() / kFirstTurn.radians());
    while (turn > 0.5 * to.radians()) {
      bool better = false;
      for (const Place& step : steps(turn, shift)) {
        const Place next{best.place.angle + step.angle, best.place.offset_m + step.offset_m};
        const Prices prices = pricing_.prices(next);
        const Found found{next, soft ? prices.soft : prices.cut, prices.works};
        if (!is_better(found, best)) continue;
        best = found;
        better = true;
      }
      if (better) continue;
      turn *= 0.5;
      shift *= 0.5;
    }
  }

  /// Bounds the box; prices the grid in its middle if the box may hold anything and is either one of the
  /// first or so small that its middle stands for it.
  std::optional<Prices> look(SearchBox& box, double target) const {
    const GridTally tally = pricing_.tally(box.middle.angle);
    box.bound = std::max(box.bound, pricing_.least(tally, box, target));
    const bool between = box.half_offset_m > pricing_.width_m() / 15 && box.half_angle < kFirstHalfAngle;
    if (box.bound >= target || between) return std::nullopt;
    return pricing_.prices(tally, box.middle.offset_m);
  }

  void look_at_all(std::vector<SearchBox>& boxes) {
    std::vector<std::optional<Prices>> prices(boxes.size());
    const double target = this->target();
    for_each_index(boxes.size(), threads_, [&](std::size_t i) { prices[i] = look(boxes[i], target); });
    boxes_ += static_cast<int>(boxes.size());
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      if (prices[i]) offer(boxes[i].middle, *prices[i]);
      open_.push(boxes[i]);
    }
  }

  /// A box that cannot cost less holds nothing worth finding.
  double target() const {
    const Found& best = list_.best();
    if (!best.works) return std::numeric_limits<double>::infinity();
    const double cheapest = std::min(best.cost, rival_);
    return cheapest - effort_.gap * std::abs(cheapest);
  }

  /// A net over all directions and offsets, so that polishing finds the way into most hollows.
  void scan() {
    constexpr std::size_t kOffsets = 5;
    const auto directions = static_cast<std::size_t>(effort_.scanned);
    std::vector<Place> places(kOffsets * directions);
    std::vector<Prices> prices(places.size());
    for_each_index(directions, threads_, [&](std::size_t i) {
      const double angle = kHalfTurn * (static_cast<double>(i) + 0.5) / static_cast<double>(directions);
      const GridTally tally = pricing_.tally(angle);
      for (std::size_t k = 0; k < kOffsets; ++k) {
        // Staggered from one direction to the next.
        const double share =
            (static_cast<double>(k) + (i % 2 == 0 ? 0.0 : 0.5)) / static_cast<double>(kOffsets);
        places[kOffsets * i + k] = {angle, share * pricing_.width_m()};
        prices[kOffsets * i + k] = pricing_.prices(tally, places[kOffsets * i + k].offset_m);
      }
    });
    for (std::size_t i = 0; i < places.size(); ++i) offer(places[i], prices[i]);
  }

  void branch() {
    const int first = static_cast<int>(std::lround(kHalfTurn / (2 * kFirstHalfAngle)));
    std::vector<SearchBox> boxes;
    for (int i = 0; i < first; ++i)
      boxes.push_back({{(2 * i + 1) * kFirstHalfAngle, 0}, kFirstHalfAngle, 0.5 * pricing_.width_m(), 0});
    look_at_all(boxes);
    bound_ = std::numeric_limits<double>::infinity();
    double at_last_look = open_.top().bound;
    int next_look = boxes_ + kLookEvery;
    while (!open_.empty() && open_.top().bound < target() && boxes_ < effort_.most_boxes) {
      if (boxes_ >= next_look) {
        if (!makes_headway(open_.top().bound - at_last_look)) break;
        at_last_look = open_.top().bound;
        next_look += kLookEvery;
      }
      boxes.clear();
      while (!open_.empty() && boxes.size() < 2 * kBatch && open_.top().bound < target()) {
        divide(open_.top(), boxes);
        open_.pop();
      }
      look_at_all(boxes);
    }
    if (!open_.empty()) bound_ = std::min(bound_, open_.top().bound);
  }

  /// Has the bound risen enough since the last look? Later it rises more slowly: where the boxes that are
  /// left would not close the gap at twice the pace, it is left open.
  bool makes_headway(double closed) const {
    const double open_gap = target() - open_.top().bound;
    const double looks_left = static_cast<double>(effort_.most_boxes - boxes_) / kLookEvery;
    return closed >= (hindered_ ? kLeastWhereHindered : kLeastProgress) * open_gap &&
           2 * closed * looks_left >= open_gap;
  }

  void divide(const SearchBox& box, std::vector<SearchBox>& out) {
    const double by_angle = box.half_angle * pricing_.radius_m();
    const double least_offset = kLeastShift * pricing_.width_m();
    const bool can_turn = by_angle > least_offset;
    if (!can_turn && box.half_offset_m <= least_offset) {
      bound_ = std::min(bound_, box.bound);
      return;
    }
    const bool turn = can_turn && (by_angle > box.half_offset_m || box.half_offset_m <= least_offset);
    SearchBox half = box;
    (turn ? half.half_angle : half.half_offset_m) *= 0.5;
    for (const int side : {-1, 1}) {
      SearchBox next = half;
      if (turn)
        next.middle.angle += side * half.half_angle;
      else
        next.middle.offset_m += side * half.half_offset_m;
      out.push_back(next);
    }
  }

  void refine(PricedGrid& grid) const {
    const GridTally tally = pricing_.tally(grid.direction.angle().radians());
    const PricedOrigin best = best_offset(tally, pricing_.bound(), {grid.origin_m, grid.cost});
    grid.origin_m = best.origin_m;
    grid.cost = best.cost;
  }

  Pricing pricing_;
  SearchEffort effort_;
  int threads_;
  bool hindered_;
  double rival_ = std::numeric_limits<double>::infinity();
  Shortlist list_, soft_list_;
  std::priority_queue<SearchBox, std::vector<SearchBox>, LaterBox> open_;
  double bound_ = 0;
  int boxes_ = 0;
};

}  // namespace

GridSearchResult search_grids(const SearchTask& task, const Polygon& part, const SearchEffort& effort,
                              int threads, const Rival& rival) {
  return GridSearch(task, part, effort, threads).run(rival);
}

}  // namespace tramline
