#include "tramline/route/connection/way_search.h"

#include <algorithm>
#include <limits>
#include <queue>

#include "tramline/route/connection/way.h"
#include "tramline/turns/manoeuvres/dubins.h"

namespace tramline {
namespace {

/// So many poses are left at the most; what is farther is not found.
constexpr std::size_t kMostPoses = 4000;
/// Where so many poses did not lead to an end, it is asked whether any pose does; not of many ends, of which
/// some are entered for sure.
constexpr std::size_t kLooksAhead = 50, kFewEnds = 64;
/// What remains is taken to be this much longer than the straight line: the search is far shorter, and what
/// it finds at most as much worse.
constexpr double kHaste = 1.2;

/// From one place to another; to a beginning from itself. The numbers of places: beginnings, poses of the
/// roadmap, ends.
struct Move {
  std::size_t from = 0;
  std::size_t to = 0;
  RoadmapWays::Word* word = nullptr;  ///< to the roadmap; null of steps along lines and to ends
};

/// A step that may be taken, with a lower bound of its cost until it is settled. What it costs from its end
/// on is estimated by straight lines first, and by Dubins paths when the search comes to it: most proposals
/// are never come to.
struct Proposal {
  double estimate_s = 0;  ///< of the whole way
  double cost_s = 0;      ///< up to the end of the step
  Move move{};
  const SteeredPath* way = nullptr;  ///< once it is settled
  std::size_t number = 0;            ///< breaks ties
  bool crude = true;                 ///< estimated by straight lines

  friend bool operator>(const Proposal& a, const Proposal& b) {
    return a.estimate_s != b.estimate_s ? a.estimate_s > b.estimate_s : a.number > b.number;
  }
};

std::vector<Point> headed_for(const std::vector<WayEnd>& ends) {
  std::vector<Point> out;
  for (const WayEnd& end : ends) out.push_back(end.pose.heading.unit());
  return out;
}

std::vector<Pose> poses_of(const std::vector<WayEnd>& ends) {
  std::vector<Pose> out;
  for (const WayEnd& end : ends) out.push_back(end.pose);
  return out;
}

constexpr double kAnyLength_m = std::numeric_limits<double>::infinity();
constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

class WaySearch {
 public:
  WaySearch(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends, RoadmapWays& on_roadmap,
            const DrivingGround& ground, double no_more_than_s)
      : no_more_than_s_(no_more_than_s),
        begins_(begins),
        ends_(ends),
        begins_ahead_(headed_for(begins)),
        ends_ahead_(headed_for(ends)),
        ways_on_(on_roadmap),
        roadmap_(on_roadmap.roadmap()),
        radius_m_(ground.machine().radius_m),
        speed_(ground.machine().turning.turning_speed_mps),
        visits_(begins.size() + roadmap_.poses().size() + ends.size()),
        nowhere_to_(ends.size(), nullptr) {
    look_at_unreachable();
  }

  std::optional<FoundWay> run() {
    for (std::size_t i = 0; i < begins_.size(); ++i) propose({i, i}, begins_[i].cost_s, &begins_[i].path);
    std::size_t reached = 0;
    while (!open_.empty() && reached < kMostPoses) {
      const Proposal next = open_.top();
      open_.pop();
      const std::size_t to = next.move.to;
      if (visits_[to].reached || leads_nowhere(to)) continue;
      if (next.crude && !is_first_by_dubins(next)) continue;
      if (next.way == nullptr) {
        settle(next.move);
        continue;
      }
      visits_[to].reached = true;
      visits_[to].cost_s = next.cost_s;
      visits_[to].from = next.move.from;
      visits_[to].way = next.way;
      if (is_end(to)) return found(to);
      if (!is_begin(to)) ways_on_.count_reached();
      if (!is_begin(to) && ++reached == kLooksAhead && ends_.size() <= kFewEnds)
        drop_ends_that_nothing_enters();
      leave(to);
    }
    if (open_.empty() && !limited_) learn();
    return std::nullopt;
  }

 private:
  struct Visit {
    bool reached = false;
    double hasty_s = -1, least_s = -1;  ///< negative until computed
    double cost_s = 0;
    double settled_s = std::numeric_limits<double>::infinity();  ///< the least cost of a settled step
    std::size_t from = 0;
    const SteeredPath* way = nullptr;
    std::size_t nearest_end = kNone;  ///< to which the shortest Dubins path is so long
    double to_nearest_m = 0;
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
  Point ahead(std::size_t place) const {
    if (is_begin(place)) return begins_ahead_[place];
    return is_end(place) ? ends_ahead_[place - place_of_end(0)] : on_roadmap(place).ahead;
  }

  /// Of the way from a place to the nearest end, as the straight line to it is long: no more than least_s().
  double hasty_s(std::size_t place) {
    if (is_end(place)) return 0;
    Visit& visit = visits_[place];
    if (visit.hasty_s >= 0) return visit.hasty_s;
    visit.hasty_s = std::numeric_limits<double>::infinity();
    const Point from = pose(place).at;
    for (std::size_t i = 0; i < ends_.size(); ++i)
      if (!leads_not_to(i, place))
        visit.hasty_s =
            std::min(visit.hasty_s, kHaste * distance(from, ends_[i].pose.at) / speed_ + ends_[i].cost_s);
    return visit.hasty_s;
  }

  /// Of the way from a place to the nearest end: no way forward is shorter than a shortest Dubins path.
  double least_s(std::size_t place) {
    if (is_end(place)) return 0;
    Visit& visit = visits_[place];
    if (visit.least_s >= 0) return visit.least_s;
    visit.least_s = std::numeric_limits<double>::infinity();
    const Pose& from = pose(place);
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      const WayEnd& end = ends_[i];
      if (leads_not_to(i, place)) continue;
      const double hasty_s = kHaste * distance(from.at, end.pose.at) / speed_;
      if (hasty_s + end.cost_s >= visit.least_s) continue;
      const double forward_m = shortest_m(place, place_of_end(i));
      const double least_s = std::max(hasty_s, forward_m / speed_) + end.cost_s;
      if (least_s >= visit.least_s) continue;
      visit.least_s = least_s;
      visit.nearest_end = place_of_end(i);
      visit.to_nearest_m = forward_m;
    }
    return visit.least_s;
  }

  double shortest_m(std::size_t from, std::size_t to) const {
    const Visit& visit = visits_[from];
    if (visit.nearest_end == to) return visit.to_nearest_m;
    return dubins_length(relative(pose(from), ahead(from), pose(to), ahead(to)), radius_m_);
  }

  /// From poses where no way leads to an end none is looked for.
  bool leads_nowhere(std::size_t place) const {
    return !is_begin(place) && !is_end(place) && nowhere_[place - begins_.size()] != 0;
  }

  /// The same of one of the ends, from a pose of the roadmap.
  bool leads_not_to(std::size_t end, std::size_t place) const {
    return !is_begin(place) && nowhere_to_[end] != nullptr &&
           (*nowhere_to_[end])[place - begins_.size()] != 0;
  }

  void drop_ends_that_nothing_enters() {
    for (const WayEnd& end : ends_)
      if (!ways_on_.is_entered(end.pose)) ways_on_.unreachable().add_all(end.pose);
    look_at_unreachable();
  }

  void look_at_unreachable() {
    const Unreachable& unreachable = ways_on_.unreachable();
    nowhere_ = unreachable.to_any(poses_of(ends_));
    for (std::size_t i = 0; i < ends_.size(); ++i) nowhere_to_[i] = unreachable.to(ends_[i].pose);
  }

  /// All that could be reached was.
  void learn() {
    Unreachable::From nowhere(roadmap_.poses().size(), 0);
    for (std::size_t i = 0; i < nowhere.size(); ++i) nowhere[i] = visits_[begins_.size() + i].reached ? 1 : 0;
    for (const WayEnd& end : ends_) ways_on_.unreachable().add(end.pose, nowhere);
  }

  /// `step_s`: a lower bound, or where the way is given its cost.
  void propose(const Move& move, double step_s, const SteeredPath* way = nullptr) {
    if (leads_nowhere(move.to)) return;
    Proposal proposal;
    proposal.cost_s = visits_[move.from].cost_s + step_s + (is_end(move.to) ? end_at(move.to).cost_s : 0);
    double& settled_s = visits_[move.to].settled_s;
    if (proposal.cost_s >= settled_s) return;
    proposal.estimate_s = proposal.cost_s + hasty_s(move.to);
    if (is_dearer_than_known(proposal)) return;
    if (way != nullptr) settled_s = proposal.cost_s;
    proposal.move = move;
    proposal.way = way;
    proposal.number = proposals_++;
    open_.push(proposal);
  }

  bool is_dearer_than_known(const Proposal& proposal) {
    if (proposal.estimate_s < no_more_than_s_) return false;
    limited_ = true;
    return true;
  }

  /// Whether a proposal is still the first of all as Dubins paths have it; where it is not it is put back.
  bool is_first_by_dubins(Proposal proposal) {
    const Move& move = proposal.move;
    const double crude_s = proposal.estimate_s;
    proposal.crude = false;
    if (!is_end(move.to)) {
      proposal.estimate_s = proposal.cost_s + least_s(move.to);
    } else if (proposal.way == nullptr) {
      const double length_m = shortest_m(move.from, move.to);
      if (!is_begin(move.from) && length_m > ways_on_.longest_word_m()) return false;
      proposal.cost_s = visits_[move.from].cost_s + length_m / speed_ + end_at(move.to).cost_s;
      proposal.estimate_s = proposal.cost_s;
      if (proposal.cost_s >= visits_[move.to].settled_s) return false;
    }
    if (proposal.estimate_s == crude_s) return true;
    if (!is_dearer_than_known(proposal)) open_.push(proposal);
    return false;
  }

  /// Where it is known whether a word has room, the word as it is or none.
  void propose_word(std::size_t from, RoadmapWays::Word& word) {
    const std::size_t to = begins_.size() + word.to;
    if (visits_[to].reached) return;
    if (!word.looked)
      propose({from, to, &word}, word.length_m / speed_);
    else if (word.way != nullptr)
      propose({from, to, &word}, word.way->cost_s, &word.way->path);
  }

  void propose_end(std::size_t from, std::size_t to, double longest_m) {
    const double least_m = distance(pose(from).at, pose(to).at);
    if (least_m <= longest_m) propose({from, to}, least_m / speed_);
  }

  /// Lines lead on from where the machine has backed far along its work: a long word from every place there
  /// would be one too many.
  double longest_to_end_m(std::size_t begin) const {
    const double longest_m = ways_on_.longest_word_m();
    return length(begins_[begin].path) > longest_m ? longest_m : kAnyLength_m;
  }

  void leave(std::size_t place) {
    if (is_begin(place)) {
      for (std::size_t end = 0; end < ends_.size(); ++end)
        propose_end(place, place_of_end(end), longest_to_end_m(place));
      for (RoadmapWays::Word& word : ways_on_.words_from(pose(place))) propose_word(place, word);
      return;
    }
    // Lines lead near the ends; a long word from every pose on them would be one too many.
    for (std::size_t end = 0; end < ends_.size(); ++end)
      if (!leads_not_to(end, place)) propose_end(place, place_of_end(end), ways_on_.longest_word_m());
    if (on_roadmap(place).next)
      propose({place, begins_.size() + *on_roadmap(place).next}, length(on_roadmap(place).to_next) / speed_);
    // Words to other lines ahead that lead on.
    for (RoadmapWays::Word& word : ways_on_.changes(place - begins_.size())) propose_word(place, word);
  }

  /// Replaces a proposal by the way with room, at its own cost, or by nothing.
  void settle(const Move& move) {
    const RoadmapWays::Way* way = nullptr;
    if (is_end(move.to))
      way = ways_on_.word(pose(move.from), pose(move.to));
    else if (move.word == nullptr)
      way = ways_on_.along(move.from - begins_.size());
    else if (is_begin(move.from))
      way = ways_on_.word(pose(move.from), *move.word);
    else
      way = ways_on_.change(move.from - begins_.size(), *move.word);
    if (way != nullptr) propose(move, way->cost_s, &way->path);
  }

  FoundWay found(std::size_t place) const {
    FoundWay out;
    out.cost_s = visits_[place].cost_s;
    out.end = place - place_of_end(0);
    std::vector<const SteeredPath*> parts{&end_at(place).path};
    for (; !is_begin(place); place = visits_[place].from) parts.push_back(visits_[place].way);
    out.begin = place;
    parts.push_back(&begins_[place].path);
    std::reverse(parts.begin(), parts.end());
    for (const SteeredPath* part : parts) out.path.insert(out.path.end(), part->begin(), part->end());
    return out;
  }

  double no_more_than_s_;
  const std::vector<WayEnd>& begins_;
  const std::vector<WayEnd>& ends_;
  std::vector<Point> begins_ahead_, ends_ahead_;
  RoadmapWays& ways_on_;
  const Roadmap& roadmap_;
  double radius_m_;
  double speed_;
  std::vector<Visit> visits_;
  Unreachable::From nowhere_{};                       ///< leads to none of the ends
  std::vector<const Unreachable::From*> nowhere_to_;  ///< by end; null where nothing is known
  bool limited_ = false;                              ///< some steps were left out because they cost too much
  std::size_t proposals_ = 0;
  std::priority_queue<Proposal, std::vector<Proposal>, std::greater<>> open_;
};

}  // namespace

std::optional<FoundWay> quickest_way(const std::vector<WayEnd>& begins, const std::vector<WayEnd>& ends,
                                     RoadmapWays& on_roadmap, const DrivingGround& ground,
                                     double no_more_than_s) {
  return WaySearch(begins, ends, on_roadmap, ground, no_more_than_s).run();
}

}  // namespace tramline
