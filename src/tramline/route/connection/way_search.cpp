#include "tramline/route/connection/way_search.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"
#include "tramline/turns/manoeuvres/reeds_shepp.h"

namespace tramline {
namespace {

/// So many poses are left at the most; what is farther is not found.
constexpr std::size_t kMostPoses = 4000;
/// Where so many poses did not lead to an end, it is asked whether any pose does.
constexpr std::size_t kLooksAhead = 50;
/// What remains is taken to be this much longer than the straight line: the search is far shorter, and what
/// it finds at most as much worse.
constexpr double kHaste = 1.2;

enum class Step { kWord, kAlong };
/// The cost of a step is a lower bound, or what it is with room.
enum class Known { kAtLeast, kSettled };

/// From one place to another. The numbers of places: beginnings, poses of the roadmap, ends.
struct Move {
  std::size_t from = 0;
  std::size_t to = 0;
  Step step = Step::kWord;
  std::size_t change = 0;  ///< of a word between lines: its number among the changes of its place
};

/// A step that may be taken, with a lower bound of its cost until it is settled.
struct Proposal {
  double estimate_s = 0;  ///< of the whole way
  double cost_s = 0;      ///< up to the end of the step
  Move move{};
  bool settled = false;
  std::size_t number = 0;  ///< breaks ties

  friend bool operator>(const Proposal& a, const Proposal& b) {
    return a.estimate_s != b.estimate_s ? a.estimate_s > b.estimate_s : a.number > b.number;
  }
};

std::vector<Pose> poses_of(const std::vector<WayEnd>& ends) {
  std::vector<Pose> out;
  for (const WayEnd& end : ends) out.push_back(end.pose);
  return out;
}

class WaySearch {
 public:
  WaySearch(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends, RoadmapWays& on_roadmap,
            const DrivingGround& ground, double no_more_than_s)
      : no_more_than_s_(no_more_than_s),
        begins_(begins),
        ends_(ends),
        ways_on_(on_roadmap),
        roadmap_(on_roadmap.roadmap()),
        radius_m_(ground.machine().radius_m),
        speed_(ground.machine().turning.turning_speed_mps),
        visits_(begins.size() + roadmap_.poses().size() + ends.size()),
        nowhere_(on_roadmap.unreachable().to_any(poses_of(ends))) {}

  std::optional<FoundWay> run() {
    for (std::size_t i = 0; i < begins_.size(); ++i) {
      visits_[i].cost_s = begins_[i].cost_s;
      visits_[i].reached = true;
      leave(i);
    }
    std::size_t reached = 0;
    while (!open_.empty() && reached < kMostPoses) {
      const Proposal next = open_.top();
      open_.pop();
      const std::size_t to = next.move.to;
      if (visits_[to].reached || leads_nowhere(to)) continue;
      if (!next.settled) {
        settle(next.move);
        continue;
      }
      visits_[to].reached = true;
      visits_[to].cost_s = next.cost_s;
      visits_[to].from = next.move.from;
      visits_[to].way = std::move(ways_[next.number]);
      if (is_end(to)) return found(to);
      if (++reached == kLooksAhead) drop_ends_that_nothing_enters();
      leave(to);
    }
    if (open_.empty() && !limited_) learn();
    return std::nullopt;
  }

 private:
  struct Visit {
    bool reached = false;
    double least_s = -1;  ///< negative until computed
    double cost_s = 0;
    std::size_t from = 0;
    SteeredPath way{};
  };

  bool is_begin(std::size_t place) const { return place < begins_.size(); }
  bool is_end(std::size_t place) const { return place >= begins_.size() + roadmap_.poses().size(); }
  std::size_t place_of_end(std::size_t end) const { return begins_.size() + roadmap_.poses().size() + end; }
  const RoadmapPose& on_roadmap(std::size_t place) const { return roadmap_.poses()[place - begins_.size()]; }
  const WayEnd& end_at(std::size_t place) const { return ends_[place - place_of_end(0)]; }
  const Pose& pose(std::size_t place) const {
    if (is_begin(place)) return begins_[place].pose;
    return is_end(place) ? end_at(place).pose : on_roadmap(place).pose;
  }

  /// Of the way from a place to the nearest end: no way forward is shorter than a shortest Dubins path.
  double least_s(std::size_t place) {
    if (is_end(place)) return 0;
    double& known_s = visits_[place].least_s;
    if (known_s >= 0) return known_s;
    known_s = std::numeric_limits<double>::infinity();
    const Pose& from = pose(place);
    for (const WayEnd& end : ends_) {
      const double hasty_s = kHaste * distance(from.at, end.pose.at) / speed_;
      if (std::max(hasty_s, least_length(from, end.pose, radius_m_) / speed_) + end.cost_s >= known_s)
        continue;
      const double forward_s = dubins_length(from, end.pose, radius_m_) / speed_;
      known_s = std::min(known_s, std::max(hasty_s, forward_s) + end.cost_s);
    }
    return known_s;
  }

  /// From poses where no way leads to an end none is looked for.
  bool leads_nowhere(std::size_t place) const {
    return !is_begin(place) && !is_end(place) && nowhere_[place - begins_.size()] != 0;
  }

  void drop_ends_that_nothing_enters() {
    for (const WayEnd& end : ends_)
      if (!ways_on_.is_entered(end.pose)) ways_on_.unreachable().add_all(end.pose);
    nowhere_ = ways_on_.unreachable().to_any(poses_of(ends_));
  }

  /// All that could be reached was.
  void learn() {
    Unreachable::From nowhere(roadmap_.poses().size(), 0);
    for (std::size_t i = 0; i < nowhere.size(); ++i) nowhere[i] = visits_[begins_.size() + i].reached ? 1 : 0;
    for (const WayEnd& end : ends_) ways_on_.unreachable().add(end.pose, nowhere);
  }

  void propose(const Move& move, double step_s, Known known, SteeredPath way) {
    if (leads_nowhere(move.to)) return;
    Proposal proposal;
    proposal.cost_s = visits_[move.from].cost_s + step_s + (is_end(move.to) ? end_at(move.to).cost_s : 0);
    proposal.estimate_s = proposal.cost_s + least_s(move.to);
    if (proposal.estimate_s >= no_more_than_s_) {
      limited_ = true;
      return;
    }
    proposal.move = move;
    proposal.settled = known == Known::kSettled;
    proposal.number = ways_.size();
    ways_.push_back(std::move(way));
    open_.push(proposal);
  }

  void propose_word(std::size_t from, std::size_t to, double longest_m) {
    if (visits_[to].reached || leads_nowhere(to)) return;
    if (distance(pose(from).at, pose(to).at) > longest_m) return;
    const double length_m = dubins_length(pose(from), pose(to), radius_m_);
    if (length_m <= longest_m) propose({from, to, Step::kWord}, length_m / speed_, Known::kAtLeast, {});
  }

  void leave(std::size_t place) {
    const double longest_m = ways_on_.longest_word_m();
    const bool on_line = !is_begin(place);
    // Lines lead near the ends; a long word from every pose on them would be one too many.
    const double to_end_m = on_line ? longest_m : std::numeric_limits<double>::infinity();
    for (std::size_t end = 0; end < ends_.size(); ++end) propose_word(place, place_of_end(end), to_end_m);
    if (on_line && on_roadmap(place).next)
      propose({place, begins_.size() + *on_roadmap(place).next, Step::kAlong},
              length(on_roadmap(place).to_next) / speed_, Known::kAtLeast, {});
    if (on_line)
      change_lines(place);
    else
      roadmap_.each_near(pose(place).at, ways_on_.reach_m(),
                         [&](std::size_t i) { propose_word(place, begins_.size() + i, longest_m); });
  }

  /// Words from a place on a line to others ahead that lead on.
  void change_lines(std::size_t place) {
    const std::vector<RoadmapWays::Change>& changes = ways_on_.changes(place - begins_.size());
    for (std::size_t i = 0; i < changes.size(); ++i)
      if (const std::size_t to = begins_.size() + changes[i].to; !visits_[to].reached)
        propose({place, to, Step::kWord, i}, changes[i].length_m / speed_, Known::kAtLeast, {});
  }

  /// Replaces a proposal by the way with room, at its own cost, or by nothing.
  void settle(const Move& move) {
    const RoadmapWays::Way* way = nullptr;
    if (is_begin(move.from) || is_end(move.to))
      way = ways_on_.word(pose(move.from), pose(move.to));
    else if (move.step == Step::kAlong)
      way = ways_on_.along(move.from - begins_.size());
    else
      way = ways_on_.change(move.from - begins_.size(), move.change);
    if (way != nullptr) propose(move, way->cost_s, Known::kSettled, way->path);
  }

  FoundWay found(std::size_t place) const {
    FoundWay out;
    out.cost_s = visits_[place].cost_s;
    out.end = place - place_of_end(0);
    std::vector<const SteeredPath*> parts{&end_at(place).path};
    for (; !is_begin(place); place = visits_[place].from) parts.push_back(&visits_[place].way);
    out.begin = place;
    parts.push_back(&begins_[place].path);
    std::reverse(parts.begin(), parts.end());
    for (const SteeredPath* part : parts) out.path.insert(out.path.end(), part->begin(), part->end());
    return out;
  }

  double no_more_than_s_;
  const std::vector<WayEnd>& begins_;
  const std::vector<WayEnd>& ends_;
  RoadmapWays& ways_on_;
  const Roadmap& roadmap_;
  double radius_m_;
  double speed_;
  std::vector<Visit> visits_;
  Unreachable::From nowhere_;      ///< leads to none of the ends
  bool limited_ = false;           ///< some steps were left out because they cost too much
  std::vector<SteeredPath> ways_;  ///< by number of proposal; empty until settled
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<>> open_;
};

}  // namespace

std::optional<FoundWay> quickest_way(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                                     RoadmapWays& on_roadmap, const DrivingGround& ground,
                                     double no_more_than_s) {
  return WaySearch(begins, ends, on_roadmap, ground, no_more_than_s).run();
}

}  // namespace tramline
