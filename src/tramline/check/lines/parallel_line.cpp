#include "tramline/check/lines/parallel_line.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The line at a position where it begins or ends is evaluated this near to it, m.
constexpr double kSameStretch_m = 2 * kLengthTolerance_m;
/// The first step from an edge to where the line is certainly beside it, m; further steps are longer.
constexpr double kFirstStep_m = 1e-6;
constexpr double kSharpestCorner = 2 * std::numbers::pi / 3;

/// How far the heading turns to the right, rad; in (−π, π].
double right_turn(Point from, Point to) { return std::atan2(-cross(from, to), dot(from, to)); }

/// How far round an arc that turns right a point on it is, m.
double round_of(const PathSegment& arc, Point centre, Point p) {
  return radius(arc) * std::max(0.0, right_turn(arc.from - centre, p - centre));
}

}  // namespace

ParallelLine::ParallelLine(const ReferenceSide& reference, const std::vector<double>& looks_m, double off_m,
                           double width_m, double least_radius_m)
    : reference_(reference),
      looks_m_(looks_m),
      off_m_(off_m),
      width_m_(width_m),
      least_radius_m_(least_radius_m) {}

bool ParallelLine::fits(double along_m) const {
  const double far_m = off_m_ + least_radius_m_;
  return reference_.keeps_off(reference_.beside(along_m, far_m), far_m);
}

bool ParallelLine::is_driven(double along_m) const {
  const double curvature = reference_.curvature_at(along_m), far_m = off_m_ + 0.5 * width_m_;
  if (curvature < 0 && -1 / curvature - off_m_ < least_radius_m_ * (1 - kRounding)) return false;
  return reference_.keeps_off(reference_.beside(along_m, far_m), far_m);
}

/// The last position at which something holds, between one where it holds and one where it does not.
template <class Holds>
double ParallelLine::last_that(Holds holds, double holds_m, double not_m) const {
  for (int i = 0; i < 60 && std::abs(not_m - holds_m) > kShortest_m; ++i) {
    const double middle_m = 0.5 * (holds_m + not_m);
    (holds(middle_m) ? holds_m : not_m) = middle_m;
  }
  return holds_m;
}

std::vector<double>::const_iterator ParallelLine::first_look_after(double along_m) const {
  return std::upper_bound(looks_m_.begin(), looks_m_.end(), along_m);
}

ParallelLine::Stretch ParallelLine::stretch(double from_m, Way way) const {
  const auto wide = [this](double s) { return fits(s); };
  Stretch out{from_m, std::nullopt};
  bool was_wide = fits(from_m);
  if (was_wide) out.last_wide_m = from_m;
  if (!was_wide && !is_driven(from_m)) return out;
  const auto go_on_to = [&](double look_m) {
    if (look_m == out.end_m) return true;
    const bool is_wide = fits(look_m);
    if (was_wide && !is_wide) out.last_wide_m = last_that(wide, out.end_m, look_m);
    if (is_wide) out.last_wide_m = look_m;
    if (!is_wide && !is_driven(look_m)) {
      out.end_m = last_that([this](double s) { return is_driven(s); }, out.end_m, look_m);
      return false;
    }
    was_wide = is_wide;
    out.end_m = look_m;
    return true;
  };
  if (way == Way::kForwards) {
    for (auto look = first_look_after(from_m); look != looks_m_.end() && go_on_to(*look);) ++look;
  } else {
    for (auto look = std::make_reverse_iterator(first_look_after(from_m));
         look != looks_m_.rend() && go_on_to(*look);)
      ++look;
  }
  return out;
}

std::optional<double> ParallelLine::nearest_that_fits(double from_m, Way way) const {
  double narrow_m = from_m;
  const auto wide = [this](double s) { return fits(s); };
  const auto look_at = [&](double look_m) -> std::optional<double> {
    if (fits(look_m)) return last_that(wide, look_m, narrow_m);
    narrow_m = look_m;
    return std::nullopt;
  };
  if (way == Way::kForwards) {
    for (auto look = first_look_after(from_m); look != looks_m_.end(); ++look)
      if (const auto found = look_at(*look)) return found;
  } else {
    for (auto look = std::make_reverse_iterator(first_look_after(from_m)); look != looks_m_.rend(); ++look)
      if (const auto found = look_at(*look)) return found;
  }
  return std::nullopt;
}

/// The position where the disc fits again, if that is hardly further on than one where it nearly fits.
double ParallelLine::edge_behind(double along_m, Way way) const {
  if (fits(along_m)) return along_m;
  for (double step_m = kFirstStep_m; step_m < 0.1; step_m *= 4) {
    const double there_m = along_m + (way == Way::kForwards ? step_m : -step_m);
    if (there_m < 0 || there_m > reference_.length_m()) break;
    if (fits(there_m)) return last_that([this](double s) { return fits(s); }, there_m, along_m);
  }
  return along_m;
}

std::optional<double> ParallelLine::other_foot(double edge_m, Way way) const {
  const double far_m = off_m_ + least_radius_m_;
  // A little further on the other position is nearer; the flatter the corner, the further.
  for (double further_m = kFirstStep_m; further_m < 0.1; further_m *= 10) {
    const double there_m = edge_m + (way == Way::kForwards ? further_m : -further_m);
    if (there_m < 0 || there_m > reference_.length_m()) return std::nullopt;
    const Foot foot = reference_.foot_of(reference_.beside(there_m, far_m), far_m);
    if (std::isinf(foot.off_m) || std::abs(foot.along_m - there_m) <= 3 * further_m) continue;
    if (!foot.on_right || !foot.square) return std::nullopt;
    return edge_behind(foot.along_m, way);
  }
  return std::nullopt;
}

std::optional<ParallelLine::Corner> ParallelLine::corner_from(double edge_m) const {
  const bool at_seam = reference_.round() && edge_m >= reference_.length_m() - kLengthTolerance_m;
  const std::optional<double> other = at_seam ? 0.0 : other_foot(edge_m, Way::kForwards);
  if (!other) return std::nullopt;
  Corner out{edge_m, *other, reference_.beside(edge_m, off_m_ + least_radius_m_), {}};
  const double turn = right_turn(reference_.heading_at(edge_m), reference_.heading_at(*other));
  if (turn < -kSameHeading || turn > kSharpestCorner + kSameHeading) return std::nullopt;
  // A side that also has room for the disc before a narrow stretch is not entered behind that stretch.
  const Stretch entered = stretch(*other, Way::kBackwards);
  if (entered.last_wide_m && *entered.last_wide_m < *other - kSameStretch_m) return std::nullopt;
  const Point from = reference_.beside(edge_m, off_m_), to = reference_.beside(*other, off_m_);
  if (distance(from, to) > kJoint_m) out.arc = {{from, to, -1 / least_radius_m_}};
  return out;
}

std::optional<ParallelLine::Corner> ParallelLine::corner_with(Point p, double along_m) const {
  const auto has_it = [&](const std::optional<Corner>& corner) {
    return corner && !corner->arc.empty() &&
           std::abs(distance(p, corner->centre) - least_radius_m_) <= kLengthTolerance_m;
  };
  // There may be several corners, with hardly anything between them.
  auto edge = nearest_that_fits(along_m, Way::kBackwards);
  while (edge) {
    auto corner = corner_from(*edge);
    if (has_it(corner)) return corner;
    if (!corner || corner->to_m <= corner->from_m || corner->to_m > along_m) break;
    edge = stretch(corner->to_m, Way::kForwards).last_wide_m;
  }
  // Or the corner begins before the end of a line that is closed.
  const auto far_edge = nearest_that_fits(along_m, Way::kForwards);
  edge = far_edge ? other_foot(*far_edge, Way::kBackwards) : std::nullopt;
  if (!edge) return std::nullopt;
  const auto corner = corner_from(*edge);
  return has_it(corner) ? corner : std::nullopt;
}

TrackPosition ParallelLine::beside(double along_m) const {
  return {reference_.beside(along_m, off_m_), reference_.heading_at(along_m), along_m, 0, false};
}

/// Rounding must not put a position beyond the end of the stretch.
TrackPosition ParallelLine::settled(const Foot& foot) const {
  if (fits(foot.along_m)) return beside(foot.along_m);
  const double low_m = std::max(0.0, foot.along_m - kSameStretch_m);
  const double high_m = std::min(reference_.length_m(), foot.along_m + kSameStretch_m);
  const auto wide = [this](double s) { return fits(s); };
  if (fits(low_m)) return beside(last_that(wide, low_m, foot.along_m));
  if (fits(high_m)) return beside(last_that(wide, high_m, foot.along_m));
  return beside(foot.along_m);
}

std::optional<TrackPosition> ParallelLine::position_of(Point p) const {
  const Foot foot = reference_.foot_of(p, off_m_ + least_radius_m_ + kLengthTolerance_m);
  if (std::isinf(foot.off_m) || !foot.on_right || foot.off_m < off_m_ - kLengthTolerance_m)
    return std::nullopt;
  const bool beside_it = foot.off_m <= off_m_ + kLengthTolerance_m;
  if (beside_it && !foot.square) return std::nullopt;
  if (beside_it && fits(settled(foot).along_m)) return settled(foot);
  const auto corner = corner_with(p, foot.along_m);
  // The first decimetre of an arc hardly deviates from the side that it leaves.
  if (beside_it && !(corner && corner->from_m < foot.along_m && foot.along_m < corner->to_m))
    return settled(foot);
  if (!corner) return std::nullopt;
  const Point outwards = (1 / distance(p, corner->centre)) * (p - corner->centre);
  return TrackPosition{p, right_of(outwards), corner->from_m,
                       round_of(corner->arc.front(), corner->centre, p), true};
}

bool ParallelLine::rolls_round_corner(const PathSegment& arc, Point on_arc) const {
  if (arc.straight() || std::abs(radius(arc) - least_radius_m_) > kLengthTolerance_m) return false;
  const double far_m = off_m_ + least_radius_m_;
  const Foot touched = reference_.foot_of(centre(arc), far_m + kLengthTolerance_m);
  if (std::isinf(touched.off_m) || !touched.on_right || !touched.square ||
      touched.off_m < far_m - kLengthTolerance_m)
    return false;
  const double across_m = reference_.foot_of(on_arc).along_m;
  for (const Way way : {Way::kForwards, Way::kBackwards}) {
    const auto other = other_foot(touched.along_m, way);
    if (!other) continue;
    const double from_m = way == Way::kForwards ? touched.along_m : *other;
    const double to_m = way == Way::kForwards ? *other : touched.along_m;
    const double turn = right_turn(reference_.heading_at(from_m), reference_.heading_at(to_m));
    if (turn < -kSameHeading || turn > kSharpestCorner + kSameHeading) continue;
    const bool behind = across_m >= from_m, before = across_m <= to_m;
    if (from_m < to_m ? behind && before : behind || before) return true;
  }
  return false;
}

Walk ParallelLine::walk(const TrackPosition& from, const TrackPosition& to) const {
  const bool comes_back = before(to, from);
  Walk out;
  bool came_back = false;
  double at_m = from.along_m, round_m = from.in_corner ? from.round_m : 0;
  for (bool in_corner = from.in_corner;; in_corner = false) {
    const Stretch next = in_corner ? Stretch{at_m, at_m} : stretch(at_m, Way::kForwards);
    const auto corner = next.last_wide_m ? corner_from(*next.last_wide_m) : std::nullopt;
    const double leave_m = corner ? corner->from_m : next.end_m;
    const bool due = came_back || !comes_back;
    if (due && !to.in_corner && to.along_m >= at_m - kSameStretch_m &&
        to.along_m <= leave_m + kSameStretch_m && !in_corner) {
      reference_.append_beside(at_m, to.along_m, off_m_, out.path);
      out.end = WalkEnd::kReached;
      return out;
    }
    reference_.append_beside(at_m, leave_m, off_m_, out.path);
    if (!corner) return out;
    const bool ends_here = due && to.in_corner && std::abs(to.along_m - corner->from_m) <= kSameStretch_m;
    if (!corner->arc.empty()) {
      const PathSegment& arc = corner->arc.front();
      const Point begin = in_corner && round_m > 0 ? from.at : arc.from, end = ends_here ? to.at : arc.to;
      if (distance(begin, end) > kJoint_m) out.path.push_back({begin, end, arc.curvature});
    }
    if (ends_here) {
      out.end = WalkEnd::kReached;
      return out;
    }
    if (corner->to_m <= corner->from_m) {
      if (came_back) return out;
      came_back = true;
    }
    at_m = corner->to_m;
    const bool beyond = to.along_m < at_m - kSameStretch_m && (came_back || !comes_back);
    if (beyond || (came_back && !comes_back)) {
      out.end = WalkEnd::kPassed;
      return out;
    }
  }
}

}  // namespace tramline::check
