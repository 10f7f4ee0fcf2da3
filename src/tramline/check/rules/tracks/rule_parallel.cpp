#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "tramline/check/measure/bands.h"
#include "tramline/check/rules/rules.h"
#include "tramline/check/tolerances.h"
#include "tramline/geometry/index/box_grid.h"

namespace tramline::check {
namespace {

/// A segment of the centre line of a piece.
struct Part {
  std::size_t piece;
  PathSegment segment;
};

/// A point where two pieces are too near to one another.
struct Nearest {
  double apart_m;
  Point at;
};

/// The pieces of one subfield that follow a curve.
class Family {
 public:
  Family(const Case& c, std::size_t subfield) : width_m_(c.plan.machine.width_m) {
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < c.plan.pieces.size(); ++i) {
      if (c.plan.pieces[i].subfield != subfield) continue;
      // Ends may touch what lies beside them, and detours may run where they like.
      for (const Path& part : parts_on_track(c.plan.pieces[i])) {
        const Path path = shortened(part, kLengthTolerance_m);
        if (path.empty()) continue;
        for (const PathSegment& segment : path) {
          stretches_.push_back({i, segment});
          index_short_parts(stretches_.back(), boxes);
        }
      }
    }
    grid_ = BoxGrid(boxes);
  }

  void check(Violations& out) {
    for (const Part& stretch : stretches_) look_beside(stretch);
    for (const auto& [pieces, nearest] : too_near_)
      out.push_back(
          {Rule::kParallel,
           fmt::format("{} and {} run {:.4f} m apart, less than the working width of {:.3f} m",
                       piece_name(pieces.first), piece_name(pieces.second), nearest.apart_m, width_m_),
           nearest.at, width_m_ - nearest.apart_m});
  }

 private:
  /// Boxes of long oblique segments would match nearly every query, so segments are divided.
  void index_short_parts(const Part& stretch, std::vector<Box>& boxes) {
    const double length_m = length(stretch.segment), longest_m = 4 * width_m_;
    const int count = std::max(1, static_cast<int>(std::ceil(length_m / longest_m)));
    Point from = stretch.segment.from;
    for (int k = 1; k <= count; ++k) {
      const Point to = k < count ? point_on(stretch.segment, length_m * k / count) : stretch.segment.to;
      short_parts_.push_back({stretch.piece, {from, to, stretch.segment.curvature}});
      boxes.push_back(reach_of({short_parts_.back().segment}, 0));
      from = to;
    }
  }

  /// Looks across the track at so many positions that no swath fits between them.
  void look_beside(const Part& stretch) {
    const double length_m = length(stretch.segment), step_m = std::min(1.0, 0.5 * width_m_);
    const int looks = static_cast<int>(std::ceil(length_m / step_m));
    for (int i = 0; i <= looks; ++i) {
      const double along_m = length_m * i / std::max(1, looks);
      const Point at = point_on(stretch.segment, along_m);
      const Point heading = heading_on(stretch.segment, along_m);
      const Point across = (width_m_ - kLengthTolerance_m) * Point{-heading.y, heading.x};
      look_along(stretch.piece, at, at + across);
      look_along(stretch.piece, at, at - across);
    }
  }

  void look_along(std::size_t piece, Point from, Point to) {
    grid_.each_meeting(bounds(from, to), [&](std::size_t i) {
      const Part& other = short_parts_[i];
      if (other.piece == piece || distance_to_edge(other.segment, from, to) > 0) return;
      const double apart_m = distance_to_edge(other.segment, from, from);
      const auto pieces = std::minmax(piece, other.piece);
      const auto known = too_near_.try_emplace(pieces, Nearest{apart_m, from}).first;
      if (apart_m < known->second.apart_m) known->second = {apart_m, from};
    });
  }

  double width_m_;
  std::vector<Part> stretches_;
  std::vector<Part> short_parts_;  ///< those in the grid
  BoxGrid grid_;
  std::map<std::pair<std::size_t, std::size_t>, Nearest> too_near_;
};

}  // namespace

void check_parallel(const Case& c, Violations& out) {
  for (std::size_t i = 0; i < c.plan.subfields.size(); ++i)
    if (follows_curve(c.plan, i) || is_of_lines(c.plan)) Family(c, i).check(out);
}

}  // namespace tramline::check
