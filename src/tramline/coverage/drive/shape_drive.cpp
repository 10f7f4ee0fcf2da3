#include "tramline/coverage/drive/shape_drive.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "tramline/coverage/drive/worked_drive.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

Quad quad_of(const Ring& ring) { return {ring[0], ring[1], ring[2], ring.size() > 3 ? ring[3] : ring[2]}; }

void append_quads(const Polygon& shape, std::vector<Quad>& out) {
  if (shape.holes.empty() && shape.outer.size() <= 4) {
    out.push_back(quad_of(shape.outer));
    return;
  }
  const Region whole = find_invalidity(shape) ? made_valid(shape) : Region{shape};
  for (const Polygon& part : whole)
    for (const Polygon& triangle : triangles_of(part)) out.push_back(quad_of(triangle.outer));
}

/// Extent of a shape along a unit vector.
double extent_m(const Polygon& shape, Point along) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Point p : shape.outer) {
    least = std::min(least, dot(p, along));
    most = std::max(most, dot(p, along));
  }
  return most - least;
}

double apart_m(const Box& a, const Box& b) {
  const double x = std::max({0.0, a.min_x - b.max_x, b.min_x - a.max_x});
  const double y = std::max({0.0, a.min_y - b.max_y, b.min_y - a.max_y});
  return std::hypot(x, y);
}

double median(std::vector<double> values) {
  const auto middle = values.begin() + std::ssize(values) / 2;
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

class ShapesInTurn {
 public:
  ShapesInTurn(const WorkLog& log, const DriveSettings& drive) : log_(log), drive_(drive) {}

  void add(const Fix& fix) {
    const WorkState work = fix.work == WorkState::kUnknown ? drive_.unknown_work : fix.work;
    if (work != WorkState::kOn) {
      units_.erase(fix.unit);
      return;
    }
    const Polygon& shape = log_.shapes[static_cast<std::size_t>(fix.shape)];
    Unit& unit = unit_for(fix, shape);
    const double step_m = unit.fresh ? 0 : distance(unit.at, fix.position);
    unit.travel_m += step_m;
    if (step_m > 0) across_.push_back(extent_m(shape, across((1 / step_m) * (fix.position - unit.at))));
    WorkedStep step;
    append_quads(shape, step.quads);
    step.run = unit.run;
    step.travel_m = unit.travel_m;
    const Box box = bounds(shape.outer);
    step.reach_m = step_m + std::hypot(box.width(), box.height());
    step.fix = steps_;
    out_.work.steps.push_back(std::move(step));
    out_.work.lines[static_cast<std::size_t>(unit.run)].push_back(fix.position);
    if (!unit.fresh && fix.time_s > unit.time_s) {
      worked_s_ += std::max(0.0, fix.time_s - std::max(unit.time_s, worked_until_s_));
      worked_until_s_ = std::fmax(worked_until_s_, fix.time_s);
    }
    unit = {box, fix.position, fix.time_s, unit.travel_m, unit.run, false};
    ++steps_;
  }

  ShapeDrive finish() {
    out_.width_m = widest_m(log_, drive_);
    if (!(out_.width_m > 0)) out_.width_m = usual_width_m();
    out_.worked_s = log_.clock == Clock::kNone ? std::numeric_limits<double>::quiet_NaN() : worked_s_;
    return std::move(out_);
  }

 private:
  struct Unit {
    Box box;
    Point at;
    double time_s = 0;
    double travel_m = 0;
    int run = 0;
    bool fresh = true;
  };

  static Point across(Point along) { return {-along.y, along.x}; }

  Unit& unit_for(const Fix& fix, const Polygon& shape) {
    const auto at = units_.find(fix.unit);
    if (at != units_.end() && !(fix.time_s - at->second.time_s > drive_.max_gap_s) &&
        apart_m(at->second.box, bounds(shape.outer)) <= drive_.max_step_m)
      return at->second;
    Unit fresh;
    fresh.run = static_cast<int>(out_.work.lines.size());
    out_.work.lines.emplace_back();
    return units_[fix.unit] = fresh;
  }

  double usual_width_m() const {
    const double usual = across_.empty() ? 0 : median(across_);
    constexpr double kWidthStep_m = 0.01;
    if (usual > kWidthStep_m) return std::round(usual / kWidthStep_m) * kWidthStep_m;
    double widest = 1e-3;
    for (const Polygon& shape : log_.shapes) {
      const Box box = bounds(shape.outer);
      widest = std::max(widest, std::min(box.width(), box.height()));
    }
    return widest;
  }

  const WorkLog& log_;
  const DriveSettings& drive_;
  ShapeDrive out_;
  std::map<int, Unit> units_;
  std::vector<double> across_;
  double worked_s_ = 0;
  double worked_until_s_ = -std::numeric_limits<double>::infinity();
  std::size_t steps_ = 0;
};

}  // namespace

ShapeDrive shape_drive(const WorkLog& log, const DriveSettings& drive) {
  ShapesInTurn shapes(log, drive);
  for (const Fix& fix : log.fixes) shapes.add(fix);
  return shapes.finish();
}

}  // namespace tramline::coverage
