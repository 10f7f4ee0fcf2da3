#include "tramline/geometry/offset/parallel.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <deque>

#include "tramline/geometry/offset/parallel_pair.h"
#include "tramline/geometry/tolerances.h"

namespace tramline {
namespace {

/// The track pairs of one family; the last ones computed are kept.
class Pairs {
 public:
  Pairs(const Path& reference, const TrackLimits& limits, Sides sides)
      : contour_(contour_of(reference)), limits_(limits), sides_(sides) {}

  const Contour& contour() const { return contour_; }
  const TrackLimits& limits() const { return limits_; }

  const ParallelPair& at(double distance) {
    for (const ParallelPair& pair : kept_)
      if (std::abs(pair.distance_m - distance) < kSameDistance_m) return pair;
    if (kept_.size() > 24) kept_.pop_front();
    kept_.push_back(parallel_pair(contour_, distance, limits_, sides_));
    return kept_.back();
  }

 private:
  Contour contour_;
  const TrackLimits& limits_;
  Sides sides_;
  std::deque<ParallelPair> kept_;
};

bool within(const Intervals& outer, const Interval& inner) {
  return std::any_of(outer.begin(), outer.end(), [&](const Interval& whole) {
    return inner.from >= whole.from - kSamePlace_m && inner.to <= whole.to + kSamePlace_m;
  });
}

/// The stretches of this track that the arcs of its own and of the tracks nearer to the reference work. They
/// lie beyond what is wide for all of these, so only tracks count that are so near that this one's far side
/// is nearer than the centres of their discs.
Intervals worked_by_arcs(Pairs& pairs, double distance) {
  const TrackLimits& limits = pairs.limits();
  Intervals all = pairs.at(distance).lost;
  for (double lower = distance - limits.width_m;
       lower > 0.49 * limits.width_m &&
       lower + limits.least_radius_m() > distance + 0.5 * limits.width_m - kSameDistance_m;
       lower -= limits.width_m) {
    const Intervals lost = pairs.at(lower).lost;
    all.insert(all.end(), lost.begin(), lost.end());
  }
  std::sort(all.begin(), all.end(), [](const Interval& a, const Interval& b) { return a.from < b.from; });
  Intervals joined;
  for (const Interval& lost : all) append_joining(joined, lost);
  return joined;
}

class TrackMaker {
 public:
  TrackMaker(Pairs& pairs, double distance)
      : contour_(pairs.contour()),
        distance_(distance),
        radius_(pairs.limits().least_radius_m()),
        pair_(pairs.at(distance)) {
    bool narrow = false;
    for (const Interval& stretch : pair_.stretches) narrow = narrow || !within(pair_.wide, stretch);
    const Intervals worked = narrow ? worked_by_arcs(pairs, distance) : Intervals{};
    for (const Interval& stretch : pair_.stretches)
      parts_.push_back(stretch.to > stretch.from ? without({stretch}, worked) : Intervals{});
  }

  /// The tracks that begin on one side, by position on the contour.
  std::vector<ParallelTrack> make(bool left) {
    std::vector<const TrackJoin*> next(parts_.size(), nullptr);
    std::vector<bool> entered(parts_.size(), false), done(parts_.size(), false);
    for (const TrackJoin& join : pair_.joins) {
      next[join.before] = &join;
      entered[join.after] = true;
    }
    std::vector<Placed> found;
    for (const bool loops : {false, true})
      for (std::size_t i = 0; i < parts_.size(); ++i)
        if (!done[i] && (loops || !entered[i])) follow(i, next, done, left, loops, found);
    std::stable_sort(found.begin(), found.end(),
                     [](const Placed& a, const Placed& b) { return a.from < b.from; });
    std::vector<ParallelTrack> out;
    for (Placed& each : found) out.push_back(std::move(each.track));
    return out;
  }

 private:
  struct Placed {
    double from;  ///< on the contour
    ParallelTrack track;
  };

  void follow(std::size_t first, const std::vector<const TrackJoin*>& next, std::vector<bool>& done,
              bool left, bool loop, std::vector<Placed>& out) {
    const bool wanted = contour_.on_left(pair_.stretches[first].from) == left;
    Path path;
    bool whole = true;
    double from = pair_.stretches[first].from;
    for (std::size_t i = first;;) {
      done[i] = true;
      for (std::size_t p = 0; p < parts_[i].size(); ++p) {
        // Only a stretch's free end is ever worked by other tracks, but the rest may be in several parts.
        if (p > 0) whole = !end_open_track(path, left, wanted, from, out) && whole;
        if (path.empty()) from = parts_[i][p].from;
        append_parallel(contour_, parts_[i][p].from, parts_[i][p].to, distance_, path);
      }
      if (next[i] == nullptr) break;
      append_arc(*next[i], path);
      i = next[i]->after;
      if (i == first) {
        close(path, loop && whole, left, wanted, from, out);
        return;
      }
    }
    end_open_track(path, left, wanted, from, out);
  }

  void append_arc(const TrackJoin& join, Path& path) const {
    const ContourElement& element = contour_.elements[element_at(contour_, join.corner.before)];
    const Point from = path.empty() ? beside(element, join.corner.before, distance_) : path.back().to;
    std::size_t i = element_at(contour_, join.corner.after);
    if (contour_.elements[i].start + contour_.elements[i].length <= join.corner.after) ++i;
    const Point to = beside(contour_.elements[i], join.corner.after, distance_);
    if (distance(from, to) > kShortest_m) path.push_back({from, to, -1 / radius_});
  }

  void close(Path& path, bool closed, bool left, bool wanted, double from, std::vector<Placed>& out) const {
    if (path.empty()) return;
    if (closed) path.back().to = path.front().from;
    if (wanted) out.push_back({from, {left ? reversed(path) : path, closed}});
  }

  bool end_open_track(Path& path, bool left, bool wanted, double from, std::vector<Placed>& out) const {
    const bool any = !path.empty() && length(path) > kShortestStretch_m;
    if (any && wanted) out.push_back({from, {left ? reversed(path) : path, false}});
    path.clear();
    return any;
  }

  const Contour& contour_;
  double distance_;
  double radius_;
  ParallelPair pair_;
  std::vector<Intervals> parts_;  ///< by stretch
};

std::vector<ParallelTrack> tracks_at(Pairs& pairs, double offset_m) {
  std::vector<ParallelTrack> out = TrackMaker(pairs, std::abs(offset_m)).make(offset_m < 0);
  if (offset_m < 0) std::reverse(out.begin(), out.end());
  return out;
}

/// Tracks of one side may join those of the other where an end of the reference touches it.
Sides sides_for(bool right, bool left) {
  return right && left ? Sides::kBoth : right ? Sides::kRight : Sides::kLeft;
}

}  // namespace

std::vector<ParallelTrack> parallel(const Path& reference, double offset_m, const TrackLimits& limits) {
  assert(std::abs(offset_m) >= 0.5 * limits.width_m * (1 - kRounding_share));
  assert(smallest_radius(reference) >= limits.least_radius_m() * (1 - kPathRadius_share));
  Pairs pairs(reference, limits, sides_for(offset_m > 0, offset_m < 0));
  return tracks_at(pairs, offset_m);
}

std::vector<FamilyTrack> parallel_family(const Path& reference, int first, int last,
                                         const TrackLimits& limits) {
  std::vector<FamilyTrack> out;
  visit_family(reference, first, last, limits, [&out](int index, std::vector<ParallelTrack> tracks) {
    for (ParallelTrack& track : tracks) out.push_back({index, std::move(track)});
    return true;
  });
  std::stable_sort(out.begin(), out.end(),
                   [](const FamilyTrack& a, const FamilyTrack& b) { return a.index < b.index; });
  return out;
}

void visit_family(const Path& reference, int first, int last, const TrackLimits& limits,
                  const std::function<bool(int index, std::vector<ParallelTrack> tracks)>& visit) {
  const auto offset_m = [&limits](int index) { return (index + 0.5) * limits.width_m; };
  if (first < 0) {
    Pairs left(reference, limits, Sides::kLeft);
    for (int k = std::min(last, -1); k >= first; --k)
      if (!visit(k, tracks_at(left, offset_m(k)))) return;
  }
  if (last < 0) return;
  Pairs right(reference, limits, Sides::kRight);
  for (int k = std::max(first, 0); k <= last; ++k)
    if (!visit(k, tracks_at(right, offset_m(k)))) return;
}

double uncut_length(const Path& reference, double offset_m) {
  double sum = 0;
  for (const PathSegment& segment : reference) {
    const double whole = length(segment);
    sum += segment.straight() ? whole : std::max(0.0, whole * (1 + offset_m * segment.curvature));
  }
  return sum;
}

}  // namespace tramline
