#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/bands.h"
#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/boolean.h"

namespace tramline::check {
namespace {

/// A piece, or what was too short to be one, along the line of its track: from the place that comes first in
/// the line's heading.
struct Laid {
  TrackPlace from;
  TrackPlace to;
};

/// All that was laid along the lines of one track.
class TrackMeetings {
 public:
  TrackMeetings(const Case& c, int subfield, int track, Violations& out)
      : c_(c),
        subfield_(subfield),
        track_(track),
        lines_(c.lines.of(subfield)),
        line_(lines_.line(track)),
        out_(out) {}

  void add(const TrackPiece& piece) {
    const auto start = line_.place_of(piece.start), end = line_.place_of(piece.end);
    if (!start || !end) return;
    const bool back = dot(direction_at_start(piece.curve.front()), start->heading) < 0;
    laid_.push_back(back ? Laid{*end, *start} : Laid{*start, *end});
  }
  void add(const DroppedPiece& dropped) {
    const auto start = line_.place_of(dropped.start), end = line_.place_of(dropped.end);
    if (!start || !end) return;
    laid_.push_back(before(*end, *start) ? Laid{*end, *start} : Laid{*start, *end});
  }

  void check() {
    std::sort(laid_.begin(), laid_.end(),
              [](const Laid& a, const Laid& b) { return before(a.from, b.from); });
    for (std::size_t i = 0; i < laid_.size(); ++i) check_behind(i);
  }

 private:
  /// Up to what comes next on the same line: other lines of the track may lie between.
  void check_behind(std::size_t i) {
    const TrackPlace& end = laid_[i].to;
    if (before(end, laid_[i].from)) return;  // across the beginning of a closed line
    const bool overlaid = std::any_of(laid_.begin(), laid_.end(), [&](const Laid& other) {
      return before(other.from, end) && before(end, other.to);
    });
    if (overlaid) return;
    for (std::size_t next = i + 1; next < laid_.size(); ++next)
      if (before(end, laid_[next].from) && !goes_on_beyond(end, laid_[next].from)) return;
    // What lies across the beginning of a closed line leaves no gap there.
    const bool round = std::any_of(laid_.begin(), laid_.end(),
                                   [](const Laid& other) { return before(other.to, other.from); });
    if (lines_.may_close() && !round) goes_on_beyond(end, laid_.front().from);
  }

  /// Judges the gap between two places; false where it leads from the one to the other, or ends.
  bool goes_on_beyond(const TrackPlace& from, const TrackPlace& to) {
    const Walk walk = line_.walk(from, to);
    if (walk.end == WalkEnd::kReached && !walk.path.empty()) check_gap(walk.path);
    return walk.end == WalkEnd::kPassed;
  }

  void check_gap(const Path& gap) {
    const Path path = shortened(gap, kLengthTolerance_m);
    const double width_m = c_.plan.machine.width_m - 2 * kLengthTolerance_m;
    if (path.empty() || width_m <= 0) return;
    const Region core = bands_along(path, width_m);
    const double blocked_m2 = common_m2(core, c_.blocking);
    if (blocked_m2 + common_m2(core, c_.given_up) <= kTouch_m2) return;
    std::vector<const Encounter*> there;
    for (const Encounter& encounter : c_.plan.encounters)
      if (encounter.subfield == subfield_ && encounter.track == track_ && holds(gap, encounter.at))
        there.push_back(&encounter);
    const Point at = place_on(path, 0.5 * length(path));
    const std::string name = fmt::format("track {}", track_ + 1);
    if (there.empty()) {
      out_.push_back({rule::kEncounters,
                      name + " is cut by an obstacle or land given up, and no encounter is there", at, 1});
      return;
    }
    if (blocked_m2 > kTouch_m2) check_names(core, there, name, at);
  }

  void check_names(const Region& core, const std::vector<const Encounter*>& there, const std::string& name,
                   Point at) {
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || passes_round(c_.plan, k) > 0) continue;
      const BoxedRegion one{{&obstacles[k].shape, c_.obstacle_boxes[k]}};
      if (common_m2(core, one) <= kTouch_m2 || names(there, static_cast<int>(k))) continue;
      out_.push_back({rule::kEncounters,
                      fmt::format("{} is cut by obstacle {}, which no encounter there names", name, k + 1),
                      at, static_cast<double>(k + 1)});
    }
  }

  static double common_m2(const Region& core, const BoxedRegion& land) {
    double sum = 0;
    for (const Polygon& part : core)
      for (const Boxed& polygon : land)
        if (intersects(bounds(part), polygon.box)) sum += area(intersection({part}, {*polygon.shape}));
    return sum;
  }

  const Case& c_;
  int subfield_;
  int track_;
  const TrackLines& lines_;
  TrackLine line_;
  Violations& out_;
  std::vector<Laid> laid_;
};

}  // namespace

void check_curved_meetings(const Case& c, Violations& out) {
  std::map<std::pair<int, int>, TrackMeetings> tracks;  // by subfield and track
  const auto of = [&](int subfield, int track) -> TrackMeetings& {
    return tracks.try_emplace({subfield, track}, c, subfield, track, out).first->second;
  };
  for (const TrackPiece& piece : c.plan.pieces)
    if (!piece.curve.empty() && c.lines.of(piece.subfield).known())
      of(piece.subfield, piece.track).add(piece);
  for (const DroppedPiece& dropped : c.plan.dropped)
    if (const TrackLines& lines = c.lines.of(dropped.subfield); lines.known())
      for (const int track : lines.tracks_near(dropped.start)) of(dropped.subfield, track).add(dropped);
  for (auto& [place, meetings] : tracks) meetings.check();
}

}  // namespace tramline::check
