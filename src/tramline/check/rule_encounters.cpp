#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tramline/check/bands.h"
#include "tramline/check/rule_names.h"
#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

/// The pieces of each track, by subfield and track.
using Tracks = std::map<std::pair<int, int>, std::vector<std::size_t>>;

Tracks tracks_of(const Plan& plan) {
  Tracks out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    out[{plan.pieces[i].subfield, plan.pieces[i].track}].push_back(i);
  return out;
}

bool extends_over(const Case& c, const TrackPiece& piece, const Detour& detour, Point at) {
  if (!piece.curve.empty()) {
    const std::optional<Path> left = line_left(c, piece, detour);
    return left && holds(*left, at);
  }
  const PieceFrame frame(piece);
  const Point p = frame.to_local(at);
  // Written so that NaN lies nowhere.
  return std::abs(p.x) <= kLengthTolerance_m &&
         p.y >= frame.to_local(detour.path.front().from).y - kLengthTolerance_m &&
         p.y <= frame.to_local(detour.path.back().to).y + kLengthTolerance_m;
}

/// The detour that passes the place of an encounter; nullptr where none does.
const Detour* detour_over(const Case& c, const Tracks& tracks, const Encounter& encounter) {
  const auto pieces = tracks.find({encounter.subfield, encounter.track});
  if (pieces == tracks.end()) return nullptr;
  for (const std::size_t i : pieces->second)
    for (const Detour& detour : c.plan.pieces[i].detours)
      if (extends_over(c, c.plan.pieces[i], detour, encounter.at)) return &detour;
  return nullptr;
}

/// Does one of the pieces lead straight over a place?
bool driven_over(const Plan& plan, const std::vector<std::size_t>& pieces, Point at) {
  return std::any_of(pieces.begin(), pieces.end(), [&](std::size_t i) {
    const PieceFrame frame(plan.pieces[i]);
    const double along_m = frame.to_local(at).y;
    return along_m > kLengthTolerance_m && along_m < frame.length() - kLengthTolerance_m;
  });
}

/// Does one of the pieces lead over a place, away from its ends? For tracks that follow a curve.
bool curved_over(const Plan& plan, const std::vector<std::size_t>& pieces, Point at) {
  return std::any_of(pieces.begin(), pieces.end(), [&](std::size_t i) {
    const Path inner = shortened(centre_line(plan.pieces[i]), kLengthTolerance_m);
    return std::any_of(inner.begin(), inner.end(), [at](const PathSegment& segment) {
      return distance_to_edge(segment, at, at) <= kLengthTolerance_m;
    });
  });
}

bool includes(const std::vector<int>& all, int index) {
  return std::find(all.begin(), all.end(), index) != all.end();
}

bool includes_all(const std::vector<int>& all, const std::vector<int>& some) {
  return std::all_of(some.begin(), some.end(), [&all](int index) { return includes(all, index); });
}

/// In which way the track is not cut at an encounter that no detour passes, or "".
std::string cut_fault(const Plan& plan, const Tracks& tracks, const Encounter& encounter) {
  const auto pieces = tracks.find({encounter.subfield, encounter.track});
  if (pieces == tracks.end()) return "";
  constexpr const char* kGoesOn = "was to be cut, and its track goes on there";
  if (follows_curve(plan, encounter.subfield))
    return curved_over(plan, pieces->second, encounter.at) ? kGoesOn : "";
  const PieceFrame frame(plan.pieces[pieces->second.front()]);
  if (std::abs(frame.to_local(encounter.at).x) > kLengthTolerance_m) return "does not lie on its track";
  if (driven_over(plan, pieces->second, encounter.at)) return kGoesOn;
  return "";
}

/// In which way an encounter is not what the tracks do, or "".
std::string contradiction(const Case& c, const Tracks& tracks, const Encounter& encounter) {
  const Plan& plan = c.plan;
  const auto subfields = static_cast<int>(plan.subfields.size());
  if (encounter.subfield < 0 || encounter.subfield >= subfields) return "is in a subfield that there is not";
  // Written so that NaN lies nowhere.
  if (!(std::abs(encounter.at.x) <= kFarthest_m && std::abs(encounter.at.y) <= kFarthest_m))
    return "lies off the map";
  if (!exist(plan, encounter.obstacles)) return "names an obstacle that there is not";
  const Detour* detour = detour_over(c, tracks, encounter);
  if (encounter.chosen == Passing::kCut && detour != nullptr)
    return "was to be cut, and a detour passes there";
  if (encounter.chosen == Passing::kCut) return cut_fault(plan, tracks, encounter);
  if (detour == nullptr)
    return fmt::format("was to be passed {}, and no detour is there", name(encounter.chosen));
  if (detour->side != encounter.chosen)
    return fmt::format("was to be passed {}, and the detour passes {}", name(encounter.chosen),
                       name(detour->side));
  if (!includes_all(detour->obstacles, encounter.obstacles))
    return "has an obstacle that its detour does not name";
  return "";
}

/// A detour in the frame of its piece: which side of it things are on.
class Course {
 public:
  Course(const PieceFrame& frame, const Detour& detour) : frame_(frame) {
    constexpr double kSagitta_m = 1e-4;
    right_ = chords(moved(detour.path, [&frame](Point p) { return frame.to_local(p); }), kSagitta_m);
    from_m_ = right_.front().y;
    to_m_ = right_.back().y;
  }

  /// How near to the line that was left something lies, on either side of the detour; infinite where
  /// nothing does.
  struct Sides {
    double left_m = std::numeric_limits<double>::infinity();
    double right_m = std::numeric_limits<double>::infinity();
  };
  /// Of the parts of a polygon along the detour.
  Sides sides_of(const Polygon& land) const {
    Sides out;
    for (const Ring& ring : rings_of({land}))
      for (std::size_t i = 0; i < ring.size(); ++i)
        look_at(frame_.to_local(ring[i]), frame_.to_local(ring[i + 1 < ring.size() ? i + 1 : 0]), out);
    return out;
  }
  /// Round the line that was left.
  Box line_box(double reach_m) const { return frame_.field_box(Box{0, from_m_, 0, to_m_}.grown(reach_m)); }

 private:
  void look_at(Point a, Point b, Sides& out) const {
    if (a.y > b.y) std::swap(a, b);
    if (b.y <= from_m_ || a.y >= to_m_) return;
    const auto at = [a, b](double y) { return a + ((y - a.y) / (b.y - a.y)) * (b - a); };
    const Point first = a.y < from_m_ ? at(from_m_) : a, last = b.y > to_m_ ? at(to_m_) : b;
    double& nearest_m = right_of_path(midpoint(first, last)) ? out.right_m : out.left_m;
    nearest_m = std::min(nearest_m, distance_to_edge({{0, from_m_}, {0, to_m_}, 0}, first, last));
  }
  /// The land right of the path, as far as p, is a ring.
  bool right_of_path(Point p) const {
    double far = p.x;
    for (const Point q : right_) far = std::max(far, q.x);
    Ring ring = right_;
    ring.push_back({far + 1, to_m_});
    ring.push_back({far + 1, from_m_});
    return contains(ring, p);
  }

  const PieceFrame& frame_;
  std::vector<Point> right_;
  double from_m_;
  double to_m_;
};

/// What is wrong with what a detour says of an obstacle, or "". Obstacles may be named that are not in
/// the way themselves: land given up may join them to one that is. An obstacle with a bay may lie on both
/// sides of a detour within the bay: passed is the part in the way.
std::string misnamed(bool named, double in_the_way_m, const Course::Sides& sides, const Detour& detour) {
  if (!named)
    return std::min(sides.left_m, sides.right_m) < in_the_way_m ? "is in its way and not named" : "";
  const bool goes_left = detour.side == Passing::kLeft;
  const double passed_m = goes_left ? sides.right_m : sides.left_m;
  const double other_m = goes_left ? sides.left_m : sides.right_m;
  if (!std::isfinite(std::min(passed_m, other_m))) return "is named, and does not lie beside it";
  const bool wrong = !std::isfinite(passed_m) || other_m < in_the_way_m;
  return wrong ? fmt::format("is not passed {}", name(detour.side)) : "";
}

/// One detour against the obstacles and the encounters.
class DetourCheck {
 public:
  DetourCheck(const Case& c, std::size_t index, std::size_t number)
      : c_(c),
        detour_(c.plan.pieces[index].detours[number]),
        name_(detour_name(index, number)),
        encounters_(encounters_at(c, c.plan.pieces[index], detour_)),
        frame_(c.plan.pieces[index]),
        course_(frame_, detour_),
        reach_m_(0.5 * c.plan.machine.width_m + c.plan.settings.clearance_m) {}

  void run(Violations& out) const {
    if (encounters_.empty())
      out.push_back(
          {rule::kEncounters, name_ + " is where the plan has no encounter", detour_.path.front().from, 1});
    const Box near = course_.line_box(reach_m_);
    const auto& obstacles = c_.plan.field.obstacles;
    for (std::size_t k = 0; k < obstacles.size(); ++k) {
      const bool named = includes(detour_.obstacles, static_cast<int>(k));
      const bool may_be_entered = obstacles[k].kind == ObstacleKind::kPassable;
      if (!named && (may_be_entered || !intersects(c_.obstacle_boxes[k], near))) continue;
      const std::string fault = fault_about(static_cast<int>(k), obstacles[k].shape, named);
      if (fault.empty()) continue;
      out.push_back({rule::kEncounters, fmt::format("{}: obstacle {} {}", name_, k + 1, fault),
                     obstacles[k].shape.outer.front(), static_cast<double>(k + 1)});
    }
  }

 private:
  std::string fault_about(int obstacle, const Polygon& shape, bool named) const {
    const Course::Sides sides = course_.sides_of(shape);
    const double in_the_way_m = reach_m_ - kLengthTolerance_m;
    const bool in_the_way = std::min(sides.left_m, sides.right_m) < in_the_way_m;
    std::string fault = misnamed(named, in_the_way_m, sides, detour_);
    // One missing encounter is told once.
    if (fault.empty() && in_the_way && !encounters_.empty() && !names(encounters_, obstacle))
      return "is in its way, and no encounter there names it";
    return fault;
  }

  const Case& c_;
  const Detour& detour_;
  std::string name_;
  std::vector<const Encounter*> encounters_;
  PieceFrame frame_;
  Course course_;
  double reach_m_;
};

}  // namespace

std::vector<const Encounter*> encounters_at(const Case& c, const TrackPiece& piece, const Detour& detour) {
  std::vector<const Encounter*> out;
  for (const Encounter& encounter : c.plan.encounters)
    if (encounter.subfield == piece.subfield && encounter.track == piece.track &&
        extends_over(c, piece, detour, encounter.at))
      out.push_back(&encounter);
  return out;
}

bool names(const std::vector<const Encounter*>& encounters, int obstacle) {
  return std::any_of(encounters.begin(), encounters.end(), [obstacle](const Encounter* encounter) {
    return std::find(encounter->obstacles.begin(), encounter->obstacles.end(), obstacle) !=
           encounter->obstacles.end();
  });
}

void check_encounters(const Case& c, Violations& out) {
  const Tracks tracks = tracks_of(c.plan);
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = contradiction(c, tracks, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back(
          {rule::kEncounters, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    for (std::size_t k = 0; k < c.plan.pieces[i].detours.size() && c.plan.pieces[i].curve.empty(); ++k)
      DetourCheck(c, i, k).run(out);
}

}  // namespace tramline::check
