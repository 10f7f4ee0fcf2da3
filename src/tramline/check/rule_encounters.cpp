#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tramline/check/rules.h"
#include "tramline/check/tolerances.h"

namespace tramline::check {
namespace {

constexpr const char* kRule = "encounters";

/// The pieces of each track, by subfield and track.
using Tracks = std::map<std::pair<int, int>, std::vector<std::size_t>>;

Tracks tracks_of(const Plan& plan) {
  Tracks out;
  for (std::size_t i = 0; i < plan.pieces.size(); ++i)
    out[{plan.pieces[i].subfield, plan.pieces[i].track}].push_back(i);
  return out;
}

bool extends_over(const TrackPiece& piece, const Detour& detour, Point at) {
  const PieceFrame frame(piece);
  const Point p = frame.to_local(at);
  return std::abs(p.x) <= kLengthTolerance_m &&
         p.y >= frame.to_local(detour.path.front().from).y - kLengthTolerance_m &&
         p.y <= frame.to_local(detour.path.back().to).y + kLengthTolerance_m;
}

/// The detour that passes the place of an encounter; nullptr where none does.
const Detour* detour_over(const Plan& plan, const Tracks& tracks, const Encounter& encounter) {
  const auto pieces = tracks.find({encounter.subfield, encounter.track});
  if (pieces == tracks.end()) return nullptr;
  for (const std::size_t i : pieces->second)
    for (const Detour& detour : plan.pieces[i].detours)
      if (extends_over(plan.pieces[i], detour, encounter.at)) return &detour;
  return nullptr;
}

bool includes(const std::vector<int>& all, int index) {
  return std::find(all.begin(), all.end(), index) != all.end();
}

bool includes_all(const std::vector<int>& all, const std::vector<int>& some) {
  return std::all_of(some.begin(), some.end(), [&all](int index) { return includes(all, index); });
}

/// In which way an encounter is not what the tracks do, or "".
std::string contradiction(const Plan& plan, const Tracks& tracks, const Encounter& encounter) {
  const auto subfields = static_cast<int>(plan.subfields.size());
  if (encounter.subfield < 0 || encounter.subfield >= subfields) return "is in a subfield that there is not";
  // Written so that NaN lies nowhere.
  if (!(std::abs(encounter.at.x) <= kFarthest_m && std::abs(encounter.at.y) <= kFarthest_m))
    return "lies off the map";
  if (!exist(plan, encounter.obstacles)) return "names an obstacle that there is not";
  const Detour* detour = detour_over(plan, tracks, encounter);
  if (encounter.chosen == Passing::kCut)
    return detour == nullptr ? "" : "was to be cut, and a detour passes there";
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

  struct Sides {
    bool left = false;
    bool right = false;
    double from_line_m = std::numeric_limits<double>::infinity();
  };
  /// On which sides a polygon lies along the detour, and how near to the line that was left.
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
    const bool is_right = right_of_path(midpoint(first, last));
    (is_right ? out.right : out.left) = true;
    out.from_line_m = std::min(out.from_line_m, distance_to_edge({{0, from_m_}, {0, to_m_}, 0}, first, last));
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
/// the way themselves: land given up may join them to one that is.
std::string misnamed(bool named, bool in_the_way, const Course::Sides& sides, const Detour& detour) {
  if (!named) return in_the_way ? "is in its way and not named" : "";
  if (!sides.left && !sides.right) return "is named, and does not lie beside it";
  const bool wrong = detour.side == Passing::kLeft ? sides.left : sides.right;
  return wrong ? fmt::format("is not passed {}", name(detour.side)) : "";
}

void check_detour(const Case& c, std::size_t index, std::size_t number, Violations& out) {
  const TrackPiece& piece = c.plan.pieces[index];
  const Detour& detour = piece.detours[number];
  const PieceFrame frame(piece);
  const Course course(frame, detour);
  const double reach_m = 0.5 * c.plan.machine.width_m + c.plan.settings.clearance_m;
  const Box near = course.line_box(reach_m);
  const auto& obstacles = c.plan.field.obstacles;
  for (std::size_t k = 0; k < obstacles.size(); ++k) {
    const bool named = includes(detour.obstacles, static_cast<int>(k));
    const bool may_be_entered = obstacles[k].kind == ObstacleKind::kPassable;
    if (!named && (may_be_entered || !intersects(c.obstacle_boxes[k], near))) continue;
    const Course::Sides sides = course.sides_of(obstacles[k].shape);
    const bool in_the_way = sides.from_line_m < reach_m - kLengthTolerance_m;
    const std::string fault = misnamed(named, in_the_way, sides, detour);
    if (fault.empty()) continue;
    out.push_back({kRule, fmt::format("{}: obstacle {} {}", detour_name(index, number), k + 1, fault),
                   obstacles[k].shape.outer.front(), static_cast<double>(k + 1)});
  }
}

}  // namespace

void check_encounters(const Case& c, Violations& out) {
  const Tracks tracks = tracks_of(c.plan);
  for (std::size_t i = 0; i < c.plan.encounters.size(); ++i) {
    const std::string fault = contradiction(c.plan, tracks, c.plan.encounters[i]);
    if (!fault.empty())
      out.push_back({kRule, fmt::format("encounter {} {}", i + 1, fault), c.plan.encounters[i].at, 1});
  }
  for (std::size_t i = 0; i < c.plan.pieces.size(); ++i)
    for (std::size_t k = 0; k < c.plan.pieces[i].detours.size(); ++k) check_detour(c, i, k, out);
}

}  // namespace tramline::check
