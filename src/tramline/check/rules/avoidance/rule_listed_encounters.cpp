#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/measure/bands.h"
#include "tramline/check/measure/sound_path.h"
#include "tramline/check/measure/swath_core.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// A piece of a subfield, or a dropped piece that was too short.
struct Laid {
  Point start;
  Point end;
  Point heading;  ///< at the start
  std::optional<std::size_t> piece;
};

/// The same on the line of its track, from the position that comes first in the line's heading.
struct LaidOnLine {
  TrackPosition from;
  TrackPosition to;
  std::optional<std::size_t> piece;
};

/// A line with all that was laid along it.
struct LaidLine {
  TrackLine line;
  std::optional<int> track;  ///< where it is the line of that number
  std::vector<LaidOnLine> laid;
};

/// The gap between two pieces along one line.
struct Gap {
  const LaidOnLine& before;
  const LaidOnLine& behind;
  Path path;
};

std::vector<Laid> laid_in(const Plan& plan, std::size_t subfield) {
  std::vector<Laid> out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i) {
    const TrackPiece& piece = plan.pieces[i];
    if (piece.subfield != subfield) continue;
    const Point heading =
        piece.curve.empty() ? piece.end - piece.start : direction_at_start(piece.curve.front());
    out.push_back({piece.start, piece.end, heading, i});
  }
  for (const DroppedPiece& dropped : plan.dropped)
    if (dropped.subfield == subfield && on_the_map(dropped.start) && on_the_map(dropped.end))
      out.push_back({dropped.start, dropped.end, dropped.end - dropped.start, std::nullopt});
  return out;
}

/// Straight lines in one direction, by their positions, whatever the numbers of their tracks.
std::vector<LaidLine> straight_lines(std::vector<Laid> all, Point heading, Point origin) {
  const auto across_m = [=](const Laid& laid) {
    return -cross(heading, midpoint(laid.start, laid.end) - origin);
  };
  std::stable_sort(all.begin(), all.end(),
                   [&](const Laid& a, const Laid& b) { return across_m(a) < across_m(b); });
  std::vector<LaidLine> out;
  for (auto first = all.begin(), next = first; first != all.end(); first = next) {
    const StraightLine line(midpoint(first->start, first->end), heading);
    out.push_back({TrackLine(line), std::nullopt, {}});
    for (; next != all.end() && across_m(*next) <= across_m(*first) + kLengthTolerance_m; ++next) {
      TrackPosition from = line.foot_of(next->start), to = line.foot_of(next->end);
      if (before(to, from)) std::swap(from, to);
      out.back().laid.push_back({from, to, next->piece});
    }
  }
  return out;
}

/// The lines of numbered tracks. The file does not give the number of a dropped piece, which is therefore put
/// on all lines it may belong to.
std::vector<LaidLine> numbered_lines(const Plan& plan, const std::vector<Laid>& all,
                                     const TrackLines& lines) {
  std::map<int, LaidLine> tracks;
  for (const Laid& laid : all) {
    const std::vector<int> numbers =
        laid.piece ? std::vector{plan.pieces[*laid.piece].track} : lines.tracks_near(laid.start);
    for (const int number : numbers) {
      LaidLine& track =
          tracks.try_emplace(number, LaidLine{TrackLine(lines.line(number)), number, {}}).first->second;
      auto from = track.line.position_of(laid.start), to = track.line.position_of(laid.end);
      if (!from || !to) continue;
      // A piece may lie across the beginning of a closed line.
      const bool back = laid.piece ? dot(laid.heading, from->heading) < 0 : before(*to, *from);
      if (back) std::swap(from, to);
      track.laid.push_back({*from, *to, laid.piece});
    }
  }
  std::vector<LaidLine> out;
  for (auto& [number, track] : tracks) out.push_back(std::move(track));
  return out;
}

/// None where it is not known on which lines the tracks lie.
std::vector<LaidLine> laid_lines(const Case& c, std::size_t subfield) {
  const std::vector<Laid> all = laid_in(c.plan, subfield);
  if (!follows_curve(c.plan, subfield))
    return straight_lines(all, c.plan.subfields[subfield].direction.unit(), c.plan.field.outer.front());
  const TrackLines& lines = c.lines.of(subfield);
  return lines.known() ? numbered_lines(c.plan, all, lines) : std::vector<LaidLine>{};
}

/// Checks the gaps along one line against the encounters there.
class Meetings {
 public:
  Meetings(const Case& c, std::size_t subfield, LaidLine along, Violations& out)
      : c_(c), subfield_(subfield), along_(std::move(along)), out_(out) {
    std::stable_sort(along_.laid.begin(), along_.laid.end(),
                     [](const LaidOnLine& a, const LaidOnLine& b) { return before(a.from, b.from); });
  }

  void check() {
    for (std::size_t i = 0; i < along_.laid.size(); ++i) check_behind(i);
  }

 private:
  /// The gap up to the next piece: other lines of the same number may lie between.
  void check_behind(std::size_t i) {
    const auto& laid = along_.laid;
    if (is_across_beginning(laid[i]) || goes_on(i)) return;
    for (std::size_t next = i + 1; next < laid.size(); ++next)
      if (before(laid[i].to, laid[next].from) && !leads_beyond(laid[i], laid[next])) return;
    // A piece across the beginning of a closed line leaves no gap there.
    if (along_.line.may_close() && std::none_of(laid.begin(), laid.end(), is_across_beginning))
      leads_beyond(laid[i], laid.front());
  }

  static bool is_across_beginning(const LaidOnLine& laid) { return before(laid.to, laid.from); }

  /// Whether another piece begins where one ends. Of several that end there only the first is checked.
  bool goes_on(std::size_t i) const {
    const auto& laid = along_.laid;
    const TrackPosition& end = laid[i].to;
    for (std::size_t other = 0; other < laid.size(); ++other) {
      if (other < i && !before(laid[other].to, end) && !before(end, laid[other].to)) return true;
      if (!before(end, laid[other].from) && before(end, laid[other].to)) return true;
    }
    return false;
  }

  /// Checks the gap between the two; false where it leads from the one to the other, or ends.
  bool leads_beyond(const LaidOnLine& from, const LaidOnLine& to) {
    Walk walk = along_.line.walk(from.to, to.from);
    if (walk.end == WalkEnd::kReached && !walk.path.empty()) check({from, to, std::move(walk.path)});
    return walk.end == WalkEnd::kPassed;
  }

  void check(const Gap& gap) {
    const SwathCore core(gap.path, c_.plan.machine.width_m);
    if (core.empty()) return;
    const Clipped blocked = core.part_on(c_.blocking), left_out = core.part_on(c_.given_up);
    if (blocked.area_m2 + left_out.area_m2 <= kTouch_m2) return;
    const std::vector<const Encounter*> there = encounters_in(gap);
    if (there.empty())
      out_.push_back({Rule::kEncounters,
                      describe(gap) + " is cut by an obstacle or land given up, and no encounter is there",
                      point_on(gap.path, 0.5 * length(gap.path)), 1});
    else if (blocked.area_m2 > kTouch_m2)
      check_names(gap, core, there);
  }

  std::vector<const Encounter*> encounters_in(const Gap& gap) const {
    std::vector<const Encounter*> out;
    for (const Encounter& encounter : c_.plan.encounters)
      if (encounter.subfield == subfield_ && is_of_track(encounter, gap.before) &&
          is_of_track(encounter, gap.behind) && holds(gap.path, encounter.at))
        out.push_back(&encounter);
    return out;
  }

  /// The track of a dropped piece is known only where its line has a number.
  bool is_of_track(const Encounter& encounter, const LaidOnLine& laid) const {
    return laid.piece ? c_.plan.pieces[*laid.piece].track == encounter.track
                      : along_.track.value_or(encounter.track) == encounter.track;
  }

  void check_names(const Gap& gap, const SwathCore& core, const std::vector<const Encounter*>& there) {
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || passes_round(c_.plan, k) > 0) continue;
      if (names(there, k)) continue;
      const Clipped part = core.part_on({{&obstacles[k].shape, c_.obstacle_boxes[k]}});
      if (part.area_m2 <= kTouch_m2) continue;
      out_.push_back(
          {Rule::kEncounters,
           fmt::format("{} is cut by obstacle {}, which no encounter there names", describe(gap), k + 1),
           part.at, static_cast<double>(k + 1)});
    }
  }

  static std::string describe(const Gap& gap) {
    if (gap.before.piece && gap.behind.piece)
      return fmt::format("the track between {} and {}", piece_name(*gap.before.piece),
                         piece_name(*gap.behind.piece));
    const auto& piece = gap.before.piece ? gap.before.piece : gap.behind.piece;
    return piece ? fmt::format("the track between {} and a dropped one", piece_name(*piece))
                 : "the track between two dropped pieces";
  }

  const Case& c_;
  std::size_t subfield_;
  LaidLine along_;
  Violations& out_;
};

}  // namespace

void check_listed_encounters(const Case& c, Violations& out) {
  if (is_repair(c.plan)) return;
  for (std::size_t i = 0; i < c.plan.subfields.size(); ++i)
    for (LaidLine& line : laid_lines(c, i)) Meetings(c, i, std::move(line), out).check();
}

}  // namespace tramline::check
