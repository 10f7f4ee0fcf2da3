#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

void check_all_cut(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    for (std::size_t k = 0; k < c.plan.pieces[i].detours.size(); ++k)
      out.push_back({rule::kEncounters, detour_name(i, k) + " is driven, and all tracks were to be cut",
                     c.plan.pieces[i].detours[k].path.front().from, 1});
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i)
    if (c.plan.encounters[i].chosen != Passing::kCut)
      out.push_back({rule::kEncounters,
                     fmt::format("encounter {} is passed, and all tracks were to be cut", i + 1),
                     c.plan.encounters[i].at, 1});
}

/// How far a polygon reaches across the piece.
double extent_across_m(const Polygon& shape, const PieceFrame& frame) {
  Box box;
  for (const Point p : shape.outer) box.extend(frame.to_local(p));
  return box.width();
}

/// S1 passes one obstacle at a time, and none as wide as the threshold.
class PaperDetour {
 public:
  PaperDetour(const Case& c, std::size_t index, std::size_t number)
      : c_(c),
        piece_(c.plan.pieces[index]),
        detour_(piece_.detours[number]),
        name_(detour_name(index, number)),
        frame_(is_curved() ? PieceFrame(detour_.path.front().from, detour_.path.back().to)
                           : PieceFrame(piece_)) {}

  void run(Violations& out) const {
    if (const auto met = encounters_at(c_, piece_, detour_).size(); met > 1)
      out.push_back({rule::kEncounters,
                     fmt::format("{} passes {} encounters at once, against S1's rule", name_, met),
                     detour_.path.front().from, static_cast<double>(met)});
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || !on_its_track(k)) continue;
      const double across_m = extent_across_m(obstacles[k].shape, frame_);
      if (across_m < threshold_m() + slack_m(across_m)) continue;
      out.push_back({rule::kEncounters,
                     fmt::format("{}: obstacle {} is {:.3f} m across, and S1's rule cuts from {:.3f} m on",
                                 name_, k + 1, across_m, threshold_m()),
                     obstacles[k].shape.outer.front(), across_m - threshold_m()});
    }
  }

 private:
  bool is_curved() const { return !piece_.curve.empty(); }
  /// A curved track is seen along the chord of the detour, which all but has the track's direction beside the
  /// obstacle.
  double slack_m(double across_m) const { return kLengthTolerance_m + (is_curved() ? 0.05 * across_m : 0); }
  double threshold_m() const {
    const double given = c_.plan.settings.avoid_threshold_m;
    return given < 0 ? c_.plan.machine.width_m : given;
  }
  /// Not only beside it: then it is not for its sake that the detour is driven.
  bool on_its_track(std::size_t obstacle) const {
    const double half = 0.5 * c_.plan.machine.width_m;
    const Box replaced{-half, frame_.to_local(detour_.path.front().from).y, half,
                       frame_.to_local(detour_.path.back().to).y};
    const Box core = replaced.grown(-kLengthTolerance_m);
    if (core.width() <= 0 || core.height() <= 0) return false;
    return intersects(c_.obstacle_boxes[obstacle], frame_.field_box(core)) &&
           clipped(c_.plan.field.obstacles[obstacle].shape, frame_, core).area_m2 > kTouch_m2;
  }

  const Case& c_;
  const TrackPiece& piece_;
  const Detour& detour_;
  std::string name_;
  PieceFrame frame_;
};

bool has_detours(const Plan& plan, int subfield, int track) {
  return std::any_of(plan.pieces.begin(), plan.pieces.end(), [=](const TrackPiece& piece) {
    return piece.subfield == subfield && piece.track == track && !piece.detours.empty();
  });
}

bool was_dropped(const Plan& plan, const Encounter& encounter) {
  return std::any_of(plan.dropped.begin(), plan.dropped.end(), [&](const DroppedPiece& dropped) {
    return dropped.subfield == encounter.subfield &&
           distance_to_edge({dropped.start, dropped.end, 0}, encounter.at, encounter.at) <=
               kLengthTolerance_m;
  });
}

/// S1 knows one way past an obstacle, and takes it unless another detour of the track is in its way.
std::string paper_fault(const Plan& plan, const Encounter& encounter) {
  if (encounter.left.possible && encounter.right.possible)
    return "can be passed on both sides, and S1's rule names one";
  const bool possible = encounter.left.possible || encounter.right.possible;
  if (encounter.chosen != Passing::kCut || !possible) return "";
  if (has_detours(plan, encounter.subfield, encounter.track) || was_dropped(plan, encounter)) return "";
  return "was to be cut, and S1's rule passes it";
}

void check_paper(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    for (std::size_t k = 0; k < c.plan.pieces[i].detours.size(); ++k) PaperDetour(c, i, k).run(out);
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = paper_fault(c.plan, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back(
          {rule::kEncounters, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
}

}  // namespace

void check_avoidance(const Case& c, Violations& out) {
  if (c.plan.settings.avoid == Avoidance::kCut) check_all_cut(c, out);
  if (c.plan.settings.avoid == Avoidance::kPaper) check_paper(c, out);
}

}  // namespace tramline::check
