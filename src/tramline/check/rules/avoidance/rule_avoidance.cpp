#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "tramline/check/measure/swath_core.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

void check_all_cut(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    for (std::size_t k = 0; k < c.plan.pieces[i].detours.size(); ++k)
      out.push_back({Rule::kEncounters, detour_name(i, k) + " is driven, and all tracks were to be cut",
                     c.plan.pieces[i].detours[k].path.front().from, 1});
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i)
    if (c.plan.encounters[i].chosen != Passing::kCut)
      out.push_back({Rule::kEncounters,
                     fmt::format("encounter {} is passed, and all tracks were to be cut", i + 1),
                     c.plan.encounters[i].at, 1});
}

/// The extent of a polygon across a heading.
double extent_across_m(const Polygon& shape, const PieceFrame& frame) {
  Box box;
  for (const Point p : shape.outer) box.extend(frame.to_local(p));
  return box.width();
}

/// Versleijen passes one obstacle at a time, and none as wide as the threshold.
class PaperDetour {
 public:
  /// `line`: the stretch of its track's line that the detour replaces.
  PaperDetour(const Case& c, const Detour& detour, std::string name, const Path& line,
              std::vector<const Encounter*> encounters)
      : c_(c),
        detour_(detour),
        name_(std::move(name)),
        encounters_(std::move(encounters)),
        replaced_(line, c.plan.machine.width_m),
        frame_(frame_where_met(line)) {}

  void run(Violations& out) const {
    if (const auto met = encounters_.size(); met > 1)
      out.push_back({Rule::kEncounters,
                     fmt::format("{} passes {} encounters at once, against the paper's rule", name_, met),
                     detour_.path.front().from, static_cast<double>(met)});
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      if (obstacles[k].kind != ObstacleKind::kObstacle || !on_its_track(k)) continue;
      const double across_m = extent_across_m(obstacles[k].shape, frame_);
      if (across_m < threshold_m() + kLengthTolerance_m) continue;
      out.push_back(
          {Rule::kEncounters,
           fmt::format("{}: obstacle {} is {:.3f} m across, and the paper's rule cuts from {:.3f} m on",
                       name_, k + 1, across_m, threshold_m()),
           obstacles[k].shape.outer.front(), across_m - threshold_m()});
    }
  }

 private:
  /// A frame along the line at the obstacle, in the middle of the stretch that cannot be driven. Versleijen
  /// has straight tracks only: a curved one is replaced by its tangent there.
  PieceFrame frame_where_met(const Path& line) const {
    const ReferenceSide side(line);
    const double along_m =
        encounters_.empty() ? 0.5 * side.length_m() : side.foot_of(encounters_.front()->at).along_m;
    const Point at = side.beside(along_m, 0);
    return {at, at + side.heading_at(along_m)};
  }
  double threshold_m() const {
    const double given = c_.plan.settings.avoid_threshold_m;
    return given < 0 ? c_.plan.machine.width_m : given;
  }
  /// Whether the obstacle lies on the line and not only beside it, where it is not the reason for the detour.
  bool on_its_track(std::size_t obstacle) const {
    const BoundedPolygon bounded{&c_.plan.field.obstacles[obstacle].shape, c_.obstacle_boxes[obstacle]};
    return replaced_.part_on({bounded}).area_m2 > kTouch_m2;
  }

  const Case& c_;
  const Detour& detour_;
  std::string name_;
  std::vector<const Encounter*> encounters_;
  SwathCore replaced_;
  PieceFrame frame_;
};

bool has_detours(const Plan& plan, std::size_t subfield, int track) {
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

/// Versleijen has one way past an obstacle, and chooses it unless another detour of the track is in its way.
std::string paper_fault(const Plan& plan, const Encounter& encounter) {
  if (encounter.left.possible && encounter.right.possible)
    return "can be passed on both sides, and the paper's rule names one";
  const bool possible = encounter.left.possible || encounter.right.possible;
  if (encounter.chosen != Passing::kCut || !possible) return "";
  if (has_detours(plan, encounter.subfield, encounter.track) || was_dropped(plan, encounter)) return "";
  return "was to be cut, and the paper's rule passes it";
}

void check_paper(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
    const TrackPiece& piece = c.plan.pieces[i];
    for (std::size_t k = 0; k < piece.detours.size(); ++k) {
      const Detour& detour = piece.detours[k];
      // A detour that replaces nothing is a fault by itself (check_detours).
      if (const std::optional<Path> line = replaced_line(c, piece, detour))
        PaperDetour(c, detour, detour_name(i, k), *line, encounters_at(c, piece, detour)).run(out);
    }
  }
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = paper_fault(c.plan, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back(
          {Rule::kEncounters, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
}

}  // namespace

void check_avoidance(const Case& c, Violations& out) {
  if (c.plan.settings.avoid == Avoidance::kCut) check_all_cut(c, out);
  if (c.plan.settings.avoid == Avoidance::kPaper) check_paper(c, out);
}

}  // namespace tramline::check
