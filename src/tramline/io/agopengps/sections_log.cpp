#include "tramline/io/agopengps/sections_log.h"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "tramline/geometry/error.h"
#include "tramline/io/agopengps/field_rows.h"

namespace tramline::io {
namespace {

/// Less than this is no land, m²: numbers in the file have three decimals.
constexpr double kNoLand_m2 = 1e-3;

/// The land between two records, metres; two triangles where the section has turned on the spot, so that its
/// sides cross.
std::vector<Ring> land_between(Point left, Point right, Point next_left, Point next_right) {
  const Ring quad{left, right, next_right, next_left};
  const auto side = [](Point a, Point b, Point c) { return cross(b - a, c - a); };
  const bool simple = side(left, right, next_right) * side(right, next_right, next_left) >= 0 &&
                      side(next_right, next_left, left) * side(next_left, left, right) >= 0 &&
                      side(left, right, next_right) * side(next_right, next_left, left) >= 0;
  if (simple) return {quad};
  return {{left, right, next_left}, {right, next_right, next_left}};
}

class SectionsLog {
 public:
  explicit SectionsLog(const LocalPlane& plane) : plane_(plane) { log_.positions = Positions::kLonLat; }

  /// A patch: its colour, then the two ends of the section at each record.
  void add_patch(FieldRows& rows, int unit) {
    const std::size_t count = rows.count();
    if (count == 0) return;
    rows.numbers(3);  // colour
    if (count % 2 == 0) rows.refuse("a patch has a colour and then pairs of points");
    Point left{}, right{};
    for (std::size_t i = 1; i < count; i += 2) {
      const Point next_left = rows.place(), next_right = rows.place();
      if (i > 1)
        for (const Ring& land : land_between(left, right, next_left, next_right)) add_land(land, unit);
      left = next_left;
      right = next_right;
    }
  }

  WorkLog done() && { return std::move(log_); }

 private:
  void add_land(const Ring& metres, int unit) {
    if (std::abs(signed_area(metres)) < kNoLand_m2) return;
    Polygon shape;
    Point middle{};
    for (const Point p : metres) {
      shape.outer.push_back(plane_.to_lonlat(p));
      middle = middle + (1.0 / static_cast<double>(metres.size())) * p;
    }
    Fix fix;
    fix.position = plane_.to_lonlat(middle);
    fix.work = WorkState::kOn;
    fix.unit = unit;
    fix.shape = static_cast<int>(log_.shapes.size());
    fix.record = log_.fixes.size() + 1;
    log_.shapes.push_back(oriented(std::move(shape)));
    log_.fixes.push_back(fix);
  }

  const LocalPlane& plane_;
  WorkLog log_;
};

}  // namespace

WorkLog sections_log(const FieldFolder& folder) {
  const auto file = folder.file("Sections.txt");
  if (!file)
    throw bad_input(
        fmt::format("'{}' has no Sections.txt, in which AgOpenGPS records coverage", folder.path()));
  SectionsLog log(folder.plane());
  FieldRows rows(*file);
  for (int unit = 0; !rows.at_end(); ++unit) log.add_patch(rows, unit);
  WorkLog out = std::move(log).done();
  if (out.fixes.empty()) throw bad_input(fmt::format("'{}' holds no land that was worked", *file));
  out.notes.emplace_back(
      "AgOpenGPS records neither times nor headings: land is taken in the order of the file");
  return out;
}

}  // namespace tramline::io
