#include "tramline/io/terminal/agopengps_folder.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "tramline/geodesy/field_projection.h"
#include "tramline/geometry/angle.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/io/agopengps/local_plane.h"
#include "tramline/io/geopackage/time_stamp.h"

namespace tramline::io {
namespace {

constexpr int kAbMode = 2, kCurveMode = 4;
constexpr const char* kEnd = "\r\n";  // AgOpenGPS runs on Windows

/// As AgOpenGPS keeps its rings: the outer one clockwise, inner ones against it.
enum class Winding { kClockwise, kAnticlockwise };

/// Local metres of the field's frame in the plane of AgOpenGPS.
class Placing {
 public:
  explicit Placing(const LocalFrame& frame)
      : projection_(frame), plane_({frame.origin_lon_deg, frame.origin_lat_deg}) {}
  Point operator()(Point local) const { return plane_.to_plane(projection_.to_lonlat(local)); }
  std::vector<Point> operator()(const std::vector<Point>& line) const {
    std::vector<Point> out;
    for (const Point p : line) out.push_back((*this)(p));
    return out;
  }

 private:
  FrameProjection projection_;
  LocalPlane plane_;
};

/// What would print as -0.000 is zero.
double shown(double metres) { return std::abs(metres) < 5e-4 ? 0 : metres; }

double heading_rad(Point from, Point to) {
  return from == to ? 0 : Heading::from_to(from, to).angle().radians();
}

void add_place(std::string& text, Point at) {
  fmt::format_to(std::back_inserter(text), "{:.3f},{:.3f}", shown(at.x), shown(at.y));
}

enum class LineEnds { kOpen, kClosed };

/// A count, then a line for each point with the heading from the point before it to the one after.
void add_points(std::string& text, const std::vector<Point>& points, LineEnds ends) {
  const std::size_t n = points.size();
  const bool closed = ends == LineEnds::kClosed;
  fmt::format_to(std::back_inserter(text), "{}{}", n, kEnd);
  for (std::size_t i = 0; i < n; ++i) {
    const Point before = i > 0 ? points[i - 1] : closed ? points[n - 1] : points[i];
    const Point after = i + 1 < n ? points[i + 1] : closed ? points[0] : points[i];
    add_place(text, points[i]);
    fmt::format_to(std::back_inserter(text), ",{:.5f}{}", heading_rad(before, after), kEnd);
  }
}

std::vector<Point> wound(Ring ring, Winding winding) {
  const bool clockwise = signed_area(ring) < 0;
  return clockwise == (winding == Winding::kClockwise) ? ring : reversed(std::move(ring));
}

std::string field_text(const TerminalField& field, const std::string& folder_name) {
  return fmt::format(
      "{:%Y-%m-%d "
      "%H:%M:%S}{e}$FieldDir{e}{}{e}$Offsets{e}0,0{e}Convergence{e}0{e}StartFix{e}{:.8f},{:.8f}{e}",
      fmt::gmtime(time_of_files()), folder_name, field.frame.origin_lat_deg, field.frame.origin_lon_deg,
      fmt::arg("e", kEnd));
}

std::string boundary_text(const TerminalField& field, const Placing& place) {
  std::string out = fmt::format("$Boundary{}", kEnd);
  const auto add = [&](const Ring& ring, Winding winding, const char* driven_through) {
    fmt::format_to(std::back_inserter(out), "{}{}", driven_through, kEnd);
    add_points(out, place(wound(ring, winding)), LineEnds::kClosed);
  };
  add(field.outer, Winding::kClockwise, "False");
  for (const Obstacle& obstacle : field.obstacles)
    add(obstacle.shape.outer, Winding::kAnticlockwise,
        obstacle.kind == ObstacleKind::kPassable ? "True" : "False");
  return out;
}

/// The hole of the body round an obstacle, where headland lies between the two; empty where none does.
Ring headland_line_round(const Obstacle& obstacle, const Region& body) {
  constexpr double kSame_m2 = 1;  // the obstacle itself, but for what thinning took
  for (const Polygon& part : body)
    for (const Ring& hole : part.holes)
      if (contains(hole, obstacle.shape.outer.front()) &&
          std::abs(signed_area(hole)) > std::abs(signed_area(obstacle.shape.outer)) + kSame_m2)
        return hole;
  return {};
}

/// For each boundary, in their order, the line at which its headland ends; none is a count of 0.
std::string headland_text(const TerminalField& field, const Placing& place) {
  std::string out = fmt::format("$Headland{}", kEnd);
  if (field.body.empty()) return out;
  const Polygon& largest =
      *std::max_element(field.body.begin(), field.body.end(), [](const Polygon& a, const Polygon& b) {
        return area(Polygon{a.outer, {}}) < area(Polygon{b.outer, {}});
      });
  add_points(out, place(wound(largest.outer, Winding::kClockwise)), LineEnds::kClosed);
  for (const Obstacle& obstacle : field.obstacles)
    add_points(out, place(wound(headland_line_round(obstacle, field.body), Winding::kAnticlockwise)),
               LineEnds::kClosed);
  return out;
}

/// The line with points between those that are too far apart, and so many of them that AgOpenGPS uses it.
std::vector<Point> stepped(const std::vector<Point>& line) {
  double length_m = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) length_m += distance(line[i], line[i + 1]);
  const double longest_m = std::min(kLongestStep_m, length_m / static_cast<double>(kLeastCurvePoints));
  std::vector<Point> out{line.front()};
  for (std::size_t i = 0; i + 1 < line.size(); ++i) {
    const auto steps = static_cast<int>(std::ceil(distance(line[i], line[i + 1]) / longest_m));
    for (int step = 1; step < steps; ++step)
      out.push_back(line[i] + (static_cast<double>(step) / steps) * (line[i + 1] - line[i]));
    out.push_back(line[i + 1]);
  }
  return out;
}

std::string tracks_text(const TerminalField& field, const Placing& place) {
  std::string out = fmt::format("$TrackLines{}", kEnd);
  for (const TerminalLine& line : field.lines) {
    const Point a = place(line.points.front()), b = place(line.points.back());
    const Point second = place(line.points[1]);
    fmt::format_to(std::back_inserter(out), "{}{}{:.5f}{}", line.name, kEnd, heading_rad(a, second), kEnd);
    for (const Point end : {a, b}) {
      add_place(out, end);
      out += kEnd;
    }
    fmt::format_to(std::back_inserter(out), "0{e}{}{e}True{e}", line.straight() ? kAbMode : kCurveMode,
                   fmt::arg("e", kEnd));
    add_points(out, line.straight() ? std::vector<Point>{} : place(stepped(line.points)), LineEnds::kOpen);
  }
  return out;
}

/// Patches of worked land: a count, a colour, and places on the left and the right of a strip in turn. A
/// strip of three corners has the last one twice.
std::string sections_text(const TerminalField& field, const Placing& place) {
  std::string out;
  for (const Polygon& part : field.worked)
    for (const Polygon& triangle : triangles_of(part)) {
      const Ring& corners = triangle.outer;
      fmt::format_to(std::back_inserter(out), "5{e}27,151,160{e}", fmt::arg("e", kEnd));
      for (const std::size_t i : {0U, 1U, 2U, 2U}) {
        add_place(out, place(corners[i]));
        fmt::format_to(std::back_inserter(out), ",0{}", kEnd);
      }
    }
  return out;
}

}  // namespace

std::vector<NamedFile> agopengps_files(const TerminalField& field, const std::string& folder_name) {
  const Placing place(field.frame);
  return {{"Field.txt", field_text(field, folder_name)},
          {"Boundary.txt", boundary_text(field, place)},
          {"Headland.txt", headland_text(field, place)},
          {"TrackLines.txt", tracks_text(field, place)},
          {"Sections.txt", sections_text(field, place)}};
}

}  // namespace tramline::io
