#include "tramline/planner/given/land_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "tramline/geodesy/shown_place.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/given/narrow_tails.h"
#include "tramline/planner/given/sliver_part.h"
#include "tramline/planner/search/merge_pairs.h"
#include "tramline/planner/tolerances.h"

namespace tramline {
namespace {

constexpr double kLeastBorder_m = 0.1;  ///< parts that share less do not count as neighbours

/// The line with its ends moved outwards along its first and last edge.
std::vector<Point> lengthened(std::vector<Point> line, double by_m) {
  const auto moved = [by_m](Point end, Point from) {
    return end + (by_m / distance(from, end)) * (end - from);
  };
  const Point first = moved(line.front(), line[1]), last = moved(line.back(), line[line.size() - 2]);
  line.front() = first;
  line.back() = last;
  return line;
}

double distance_to_line(Point p, const std::vector<Point>& line) {
  double nearest = distance(p, line.front());
  for (std::size_t i = 0; i + 1 < line.size(); ++i)
    nearest = std::min(nearest, distance_to_segment(p, line[i], line[i + 1]));
  return nearest;
}

/// Whether some edge of the part lies on the line.
bool runs_along(const Polygon& part, const std::vector<Point>& line) {
  constexpr double kOnLine_m = 1e-3;
  for (const Ring& ring : rings_of({part}))
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point a = ring[i], b = ring[(i + 1) % ring.size()];
      if (distance(a, b) > kLeastBorder_m && distance_to_line(midpoint(a, b), line) < kOnLine_m &&
          distance_to_line(a, line) < kOnLine_m && distance_to_line(b, line) < kOnLine_m)
        return true;
    }
  return false;
}

double outline_m(const Polygon& polygon) {
  double sum = 0;
  for (const Ring& ring : rings_of({polygon})) sum += perimeter(ring);
  return sum;
}

std::string name_of(const LandPart& part) {
  return part.given_by.empty() ? "the land left free" : part.given_by;
}

class Divider {
 public:
  Divider(const PlanningProblem& problem, Region plannable, PreparedLand& out)
      : problem_(problem), free_(std::move(plannable)), out_(out) {}

  void run() {
    for (const GivenSubfield& subfield : problem_.settings.given.subfields) take(subfield);
    cut_tails_off();
    cut_free_land();
    join_slivers();
  }

 private:
  void take(const GivenSubfield& given) {
    Region taken = intersection(free_, given.shape);
    drop_specks(taken);
    if (taken.empty()) {
      out_.remarks.push_back(given.origin + " holds no land to divide and changes nothing");
      return;
    }
    for (Polygon& shape : taken)
      out_.parts.push_back({std::move(shape), given.origin, given.direction, given.guide});
    free_ = difference(free_, given.shape);
    drop_specks(free_);
  }

  /// Tails of the free land beside polygons that were not drawn quite up to the edge or to one another become
  /// parts, which are then joined as slivers are.
  void cut_tails_off() {
    if (out_.parts.empty()) return;
    const double width_m = problem_.machine.width_m;
    Region drawn;
    for (const LandPart& part : out_.parts) drawn.push_back(part.shape);
    Region tails;
    for (const Polygon& part : free_)
      for (Polygon& tail : narrow_tails(part, 0.5 * width_m, 2 * width_m))
        if (distance_between({tail}, drawn) <= kSamePlace_m) tails.push_back(std::move(tail));
    if (tails.empty()) return;
    free_ = difference(free_, tails);
    drop_specks(free_);
    for (Polygon& tail : tails) out_.parts.push_back({std::move(tail)});
  }

  void cut_free_land() {
    const std::vector<GivenCut>& cuts = problem_.settings.given.cuts;
    std::vector<std::vector<Point>> lines;
    for (const GivenCut& cut : cuts) lines.push_back(lengthened(cut.line, problem_.machine.width_m));
    std::vector<bool> used(cuts.size(), false);
    for (const Polygon& whole : free_) {
      Region faces;
      if (!lines.empty()) faces = split_by_lines(whole, lines);
      drop_specks(faces);
      if (faces.size() < 2) {
        out_.parts.push_back({whole});
        continue;
      }
      for (Polygon& face : faces) {
        std::string by;
        for (std::size_t i = 0; i < lines.size(); ++i) {
          if (!runs_along(face, lines[i])) continue;
          used[i] = true;
          by += (by.empty() ? "" : ", ") + cuts[i].origin;
        }
        out_.parts.push_back({std::move(face), std::move(by)});
      }
    }
    for (std::size_t i = 0; i < cuts.size(); ++i)
      if (!used[i])
        out_.remarks.push_back(cuts[i].origin +
                               " divides nothing: draw the line across the land, from edge to edge");
  }

  /// The smallest first, so that two slivers side by side may make a part together.
  void join_slivers() {
    std::vector<bool> settled(out_.parts.size(), false);
    while (out_.parts.size() > 1) {
      std::size_t smallest = out_.parts.size();
      for (std::size_t i = 0; i < out_.parts.size(); ++i)
        if (!settled[i] && (smallest == out_.parts.size() || area_of(i) < area_of(smallest))) smallest = i;
      if (smallest == out_.parts.size()) return;
      const std::optional<std::size_t> into =
          is_sliver_part(problem_, out_.parts[smallest].shape) ? best_neighbour(smallest) : std::nullopt;
      if (!into) {
        settled[smallest] = true;
        continue;
      }
      join(smallest, *into);
      settled[*into] = false;
      settled.erase(settled.begin() + static_cast<std::ptrdiff_t>(smallest));
    }
  }

  double area_of(std::size_t part) const { return area(out_.parts[part].shape); }

  std::optional<std::size_t> best_neighbour(std::size_t sliver) const {
    std::optional<std::size_t> best;
    double longest_m = kLeastBorder_m;
    const Polygon& shape = out_.parts[sliver].shape;
    for (std::size_t i = 0; i < out_.parts.size(); ++i) {
      if (i == sliver) continue;
      const std::optional<Polygon> both = merged_shape(shape, out_.parts[i].shape);
      if (!both) continue;
      const double shared_m = 0.5 * (outline_m(shape) + outline_m(out_.parts[i].shape) - outline_m(*both));
      if (shared_m <= longest_m) continue;
      longest_m = shared_m;
      best = i;
    }
    return best;
  }

  void join(std::size_t sliver, std::size_t into) {
    const LandPart &small = out_.parts[sliver], &large = out_.parts[into];
    constexpr double kDiscTolerance_m = 0.1;
    const Point at = largest_disc(small.shape, kDiscTolerance_m).centre;
    constexpr double kWorthSaying_m2 = 1;
    if (const double m2 = area(small.shape); m2 >= kWorthSaying_m2 && small.given_by != large.given_by)
      out_.remarks.push_back(fmt::format(
          "a part of {} at {}, {:.1f} m², is smaller than {:g} m² or narrower than the working width and is "
          "joined to {}",
          name_of(small), shown_place(problem_.field.frame, at), m2, problem_.settings.small_cell_m2,
          name_of(large)));
    out_.parts[into].shape = *merged_shape(large.shape, small.shape);
    out_.parts.erase(out_.parts.begin() + static_cast<std::ptrdiff_t>(sliver));
  }

  const PlanningProblem& problem_;
  Region free_;
  PreparedLand& out_;
};

}  // namespace

void divide_as_given(const PlanningProblem& problem, const Region& plannable, PreparedLand& out) {
  Divider(problem, plannable, out).run();
}

}  // namespace tramline
