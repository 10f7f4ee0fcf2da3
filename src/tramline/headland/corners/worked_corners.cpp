#include "tramline/headland/corners/worked_corners.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "tramline/headland/body.h"
#include "tramline/headland/driven_on.h"
#include "tramline/headland/pass_boundaries.h"
#include "tramline/headland/pass_tally.h"
#include "tramline/headland/path_stretch.h"
#include "tramline/headland/ring_groups.h"
#include "tramline/headland/worth/pass_work.h"

namespace tramline {
namespace {

/// Arcs wider than the tightest by more than this share are bends of the boundary rather than corners.
constexpr double kTightTurn_share = 1.5;
/// Open passes shorter than so many times the tightest turn and a width lie in tips.
constexpr double kTip_turns = 2;
/// In such parts of the width it is found how far new land reaches.
constexpr double kStep_share = 0.125;
/// So many steps before an arc the pass may be left, where its line follows a boundary that is not quite
/// straight: from some of its bends straight on leads farther than from others.
constexpr int kStepsBefore = 8;
/// By so much its heading may differ there from that at the arc, rad: more is no straight edge.
constexpr double kSameLine_rad = 0.03;
/// Of what a step works so much at least is new land where new land goes on.
constexpr double kNewLand_share = 0.02;

/// A stretch of a pass, m along it.
struct AlongPass {
  double from_m = 0, to_m = 0;

  double length_m() const { return to_m - from_m; }
};

/// A corner that is worked out.
struct Corner {
  AlongPass arc;
  double leaves_m = 0;   ///< where it is left straight on, at the beginning of the arc or shortly before, m
  Path on;               ///< from there
  double resumes_m = 0;  ///< where the next part of the pass begins, m along the pass
  double saved = 0;
};

/// Passes have the boundary that they follow on their right, unless they are driven the other way round.
enum class Turn { kLeft, kRight };

/// The tight turns of a path to one side.
std::vector<AlongPass> tight_turns(const Path& path, Turn side, double tightest_m) {
  const auto is_tight = [&](const PathSegment& segment) {
    const double curvature = side == Turn::kLeft ? segment.curvature : -segment.curvature;
    return curvature > 0 && radius(segment) <= kTightTurn_share * tightest_m;
  };
  std::vector<AlongPass> out;
  double at_m = 0, turned = 0, from_m = 0;
  for (std::size_t i = 0; i < path.size(); ++i) {
    if (turned == 0) from_m = at_m;
    at_m += length(path[i]);
    if (is_tight(path[i])) turned += std::abs(turning(path[i]));
    const bool ends = i + 1 == path.size() || !is_tight(path[i + 1]);
    if (ends && std::exchange(turned, 0) > kCorner_rad) out.push_back({from_m, at_m});
  }
  return out;
}

/// By which a closed path turns in all, a full turn one way or the other, rad.
double turning_of(const Path& path) {
  double out = 0;
  for (const PathSegment& segment : path) out += turning(segment);
  return out;
}

/// A closed path that begins in the middle of its longest line, so that none of its corners is at its ends.
Path begun_on_a_line(const Path& path) {
  double at_m = 0, begin_m = 0, longest_m = 0;
  for (const PathSegment& segment : path) {
    const double length_m = length(segment);
    if (segment.straight() && length_m > longest_m) {
      longest_m = length_m;
      begin_m = at_m + 0.5 * length_m;
    }
    at_m += length_m;
  }
  return longest_m > 0 ? stretch_of(path, begin_m, begin_m + at_m) : path;
}

/// Whether land that short passes in tips work counts as worked where passes go straight on into the tips.
enum class Tips { kWorked, kLeft };

class CornerWork {
 public:
  CornerWork(const Field& field, const HeadlandTerms& terms, const Headland& headland,
             const CornerPrices& prices, const std::vector<Round>& rounds, Tips tips)
      : terms_(terms),
        headland_(headland),
        prices_(prices),
        rounds_(rounds),
        boundaries_(boundaries_of(field, terms)),
        passable_(obstacle_shapes(field, ObstacleKind::kPassable)),
        tips_(tips),
        covered_(terms.width_m) {
    for (const HeadlandPass& pass : headland.passes)
      if (tips == Tips::kWorked || !lies_in_a_tip(pass)) covered_.add(pass.path);
  }

  /// The passes with their corners worked out.
  std::vector<HeadlandPass> all() {
    const std::vector<HeadlandPass>& passes = headland_.passes;
    std::vector<std::vector<HeadlandPass>> parts(passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i)
      if (!lies_in_a_tip(passes[i]))
        parts[i] = parts_of(passes[i], i < rounds_.size() ? rounds_[i] : Round{});
    for (std::size_t i = 0; i < passes.size(); ++i)
      if (parts[i].empty() && is_still_worth_driving(passes[i])) parts[i] = {passes[i]};
    std::vector<HeadlandPass> out;
    for (std::vector<HeadlandPass>& of_one : parts)
      for (HeadlandPass& part : of_one) out.push_back(std::move(part));
    return out;
  }

  /// Whether there is any pass for which it matters how tips count.
  bool has_tips() const {
    return std::ranges::any_of(headland_.passes,
                               [this](const HeadlandPass& pass) { return lies_in_a_tip(pass); });
  }

  /// By all corners so far.
  double saved() const { return saved_; }

 private:
  /// From the corner before, or the beginning of the pass, to the next one, or the end.
  struct Part {
    AlongPass stretch;
    const Corner* begin = nullptr;
    const Corner* end = nullptr;
  };

  /// Whether it may only work what a pass straight on into the corner works as well.
  bool lies_in_a_tip(const HeadlandPass& pass) const {
    return !is_closed(pass.path) &&
           length(pass.path) < kTip_turns * (tightest_turn_m(terms_) + terms_.width_m);
  }

  /// Whether a pass in a tip is still worth its stop once the others are driven, and those in tips before it.
  bool is_still_worth_driving(const HeadlandPass& pass) {
    if (tips_ == Tips::kWorked) return true;
    const double before = worth_with_stop(pass, all_but(pass));
    const double after = worth_with_stop(pass, covered_);
    saved_ += std::max(after, 0.0) - before;
    if (after > 0) covered_.add(pass.path);
    return after > 0;
  }

  /// The parts of a pass whose corners are worked out; the pass alone where none is.
  std::vector<HeadlandPass> parts_of(const HeadlandPass& pass, const Round& round) {
    const bool closed = is_closed(pass.path) && !round.entered;
    const Path& driven = round.path.empty() ? pass.path : round.path;
    const Path path = closed ? begun_on_a_line(driven) : driven;
    const bool other_way = turning_of(driven) * turning_of(pass.path) < 0;
    const Turn side = other_way ? Turn::kRight : Turn::kLeft;
    std::vector<Corner> corners;
    for (const AlongPass& arc : tight_turns(path, side, tightest_turn_m(terms_)))
      if (std::optional<Corner> corner = worked_out(arc, path, pass)) {
        corners.push_back(*corner);
        covered_.add(corner->on);
      }
    const double length_m = length(path);
    while (drops_one(corners, length_m, closed)) continue;
    if (corners.empty()) return {pass};
    std::vector<HeadlandPass> out;
    for (const Part& part : parts_between(corners, length_m, closed)) {
      out.push_back(pass);
      out.back().path = stretch_of(path, part.stretch.from_m, part.stretch.to_m);
      if (part.end != nullptr) append(part.end->on, out.back().path);
    }
    for (const Corner& corner : corners) saved_ += corner.saved;
    return out;
  }

  GroundToWork to_work() const { return {headland_.ground, passable_, terms_.width_m}; }

  double worth(const PassWork& work) const {
    return prices_.missed_per_m2 * work.fresh_m2 - prices_.doubled_per_m2 * work.in_vain_m2();
  }

  double worth_with_stop(const HeadlandPass& pass, const Swaths& covered) const {
    return worth(work_of(pass.path, to_work(), covered)) - prices_.per_stop -
           prices_.in_and_out_per_m * length(pass.path);
  }

  static void append(const Path& on, Path& path) {
    if (path.back().straight())
      path.back().to = on.front().to;
    else
      path.push_back(on.front());
  }

  /// The corner of an arc worked out, if that saves anything.
  std::optional<Corner> worked_out(const AlongPass& arc, const Path& path, const HeadlandPass& pass) const {
    if (arc.from_m <= 0) return std::nullopt;
    const std::optional<Corner> found = left_straight_on(arc, path, pass.number);
    if (!found) return std::nullopt;
    Corner out = *found;
    const double before_m = arc.from_m - out.leaves_m;
    const Path into = stretch_of(out.on, before_m, length(out.on));
    out.saved = worth(work_of(into, to_work(), covered_)) - prices_.per_stop -
                prices_.in_and_out_per_m * length(into);
    const double worth_of_arc =
        worth(work_of(stretch_of(path, arc.from_m, arc.to_m), to_work(), all_but(arc, path, pass, into)));
    if (worth_of_arc > 0)
      out.resumes_m = arc.from_m;
    else
      out.saved -= worth_of_arc;
    if (out.saved <= 0) return std::nullopt;
    return out;
  }

  /// The corner with the pass left where straight on leads farthest, as far as there is new land; nullopt
  /// where there is no room.
  std::optional<Corner> left_straight_on(const AlongPass& arc, const Path& path, int number) const {
    const double step_m = kStep_share * terms_.width_m;
    const auto heading_at = [&](double at_m) {
      return direction_at_end(stretch_of(path, at_m - std::min(step_m, at_m), at_m).back());
    };
    const Point heading = heading_at(arc.from_m);
    const std::vector<SwathLimit> limits = limits_of(number);
    std::optional<Corner> out;
    double farthest_m = 0;
    for (int i = 0; i <= kStepsBefore; ++i) {
      const double leaves_m = arc.from_m - i * step_m;
      if (leaves_m < step_m || dot(heading_at(leaves_m), heading) < std::cos(kSameLine_rad)) break;
      const Path on = room_straight_on(stretch_of(path, leaves_m - step_m, leaves_m), limits);
      const double beyond_m = length(on) - (arc.from_m - leaves_m);
      if (beyond_m < farthest_m + step_m) continue;
      farthest_m = beyond_m;
      out = {arc, leaves_m, on, arc.to_m};
    }
    if (!out) return std::nullopt;
    const double before_m = arc.from_m - out->leaves_m;
    const double reach_m = new_land_m(out->on, before_m);
    if (reach_m <= before_m) return std::nullopt;
    out->on = stretch_of(out->on, 0, reach_m);
    return out;
  }

  /// What a pass of this number keeps off: boundaries, with the land of the passes farther out.
  std::vector<SwathLimit> limits_of(int number) const {
    std::vector<SwathLimit> out;
    for (const Boundary& boundary : boundaries_)
      out.push_back(
          {boundary.ring, headland_depth_m(boundary, std::min(number - 1, boundary.passes), terms_.width_m)});
    return out;
  }

  /// Straight on from the end of a stretch of a pass, as far as the limits leave room.
  Path room_straight_on(const Path& before, const std::vector<SwathLimit>& limits) const {
    const double tightest_m = tightest_turn_m(terms_);
    const Point from = before.back().to, heading = direction_at_end(before.back());
    const Path on = driven_on(straight_path(from - heading, from), limits,
                              {terms_.width_m, tightest_m, 4 * (tightest_m + terms_.width_m), Along::kNone});
    return straight_path(from, on.back().to);
  }

  /// How far along the path there is new land, from so far on.
  double new_land_m(const Path& on, double from_m) const {
    const double step_m = kStep_share * terms_.width_m;
    double out = from_m;
    for (double at_m = from_m; at_m < length(on) - kSamePlace_m; at_m += step_m) {
      const double end_m = std::min(at_m + step_m, length(on));
      const PassWork work = work_of(stretch_of(on, at_m, end_m), to_work(), covered_);
      if (work.fresh_m2 > kNewLand_share * terms_.width_m * (end_m - at_m)) out = end_m;
    }
    return out;
  }

  /// All passes but for one.
  Swaths all_but(const HeadlandPass& pass) const {
    Swaths out(terms_.width_m);
    for (const HeadlandPass& other : headland_.passes)
      if (&other != &pass) out.add(other.path);
    return out;
  }

  /// All passes but for an arc of one, and what is driven straight on in its place.
  Swaths all_but(const AlongPass& arc, const Path& path, const HeadlandPass& pass, const Path& on) const {
    Swaths out = all_but(pass);
    out.add(stretch_of(path, 0, arc.from_m));
    if (const double length_m = length(path); arc.to_m < length_m)
      out.add(stretch_of(path, arc.to_m, length_m));
    out.add(on);
    return out;
  }

  /// Parts end where the pass is left for a corner.
  static std::vector<Part> parts_between(const std::vector<Corner>& corners, double length_m, bool closed) {
    std::vector<Part> out;
    const Corner& last = corners.back();
    if (!closed) out.push_back({{0, corners.front().leaves_m}, nullptr, &corners.front()});
    for (std::size_t i = 0; i + 1 < corners.size(); ++i)
      out.push_back({{corners[i].resumes_m, corners[i + 1].leaves_m}, &corners[i], &corners[i + 1]});
    if (closed)
      out.push_back({{last.resumes_m, length_m + corners.front().leaves_m}, &last, &corners.front()});
    else if (last.resumes_m < length_m)
      out.push_back({{last.resumes_m, length_m}, &last, nullptr});
    return out;
  }

  /// Drops the lesser corner of a part that is too short.
  bool drops_one(std::vector<Corner>& corners, double length_m, bool closed) const {
    if (corners.empty()) return false;
    for (const Part& part : parts_between(corners, length_m, closed)) {
      if (part.stretch.length_m() >= terms_.width_m) continue;
      const Corner* const drop =
          part.begin == nullptr || (part.end != nullptr && part.end->saved < part.begin->saved) ? part.end
                                                                                                : part.begin;
      corners.erase(corners.begin() + (drop - corners.data()));
      return true;
    }
    return false;
  }

  const HeadlandTerms& terms_;
  const Headland& headland_;
  const CornerPrices& prices_;
  const std::vector<Round>& rounds_;
  std::vector<Boundary> boundaries_;
  Region passable_;
  Tips tips_;
  Swaths covered_;  ///< by all passes, and into the corners so far
  double saved_ = 0;
};

}  // namespace

WorkedCorners with_worked_corners(const Field& field, const HeadlandTerms& terms, const Headland& headland,
                                  const CornerPrices& prices, const std::vector<Round>& rounds) {
  assert(headland.construction == HeadlandConstruction::kDrivable);
  WorkedCorners out{headland, 0};
  for (const Tips tips : {Tips::kWorked, Tips::kLeft}) {
    CornerWork corners(field, terms, headland, prices, rounds, tips);
    if (tips == Tips::kLeft && !corners.has_tips()) break;
    std::vector<HeadlandPass> passes = corners.all();
    if (corners.saved() <= out.saved) continue;
    out.headland.passes = std::move(passes);
    out.saved = corners.saved();
  }
  const Region passable = obstacle_shapes(field, ObstacleKind::kPassable);
  if (out.saved > 0) tally_passes(passable, terms.width_m, out.headland);
  return out;
}

}  // namespace tramline
