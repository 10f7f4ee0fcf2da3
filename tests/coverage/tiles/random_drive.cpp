#include "coverage/tiles/random_drive.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::testing {
namespace {

using coverage::Quad;
using coverage::WorkedStep;

bool one_in(std::mt19937_64& random, int n) { return any_of(random, 1, n) == 1; }

struct Stretch {
  double left;
  double right;
};

struct Machine {
  Point at;
  double heading = 0;  ///< radians, anticlockwise from east
  std::vector<Stretch> boom;

  Point place(double offset) const { return at + offset * Point{-std::sin(heading), std::cos(heading)}; }
  double width() const { return boom.empty() ? 0 : boom.front().left - boom.back().right; }
};

std::vector<Stretch> random_boom(std::mt19937_64& random, double width) {
  std::vector<Stretch> out;
  const int sections = any_of(random, 1, 3);
  double left = uniform(random, 0.2, 0.8) * width;
  for (int i = 0; i < sections; ++i) {
    const double right = left - width / sections;
    if (sections == 1 || !one_in(random, 4))
      out.push_back({left, right + (one_in(random, 2) ? 0 : 0.1 * width / sections)});
    left = right;
  }
  return out;
}

class Wanderer {
 public:
  Wanderer(std::mt19937_64& random, Point start) : random_(random) {
    step_m_ = std::exp(uniform(random, std::log(0.02), std::log(10)));
    width_m_ = uniform(random, 0.5, 6);
    machine_ = {start, uniform(random, 0, 2 * std::numbers::pi), random_boom(random, width_m_)};
  }

  std::vector<WorkedStep> drive(int length) {
    while (static_cast<int>(steps_.size()) < length) manoeuvre();
    return std::move(steps_);
  }

 private:
  void manoeuvre() {
    switch (any_of(random_, 0, 9)) {
      case 0:
        return turn_on_the_spot();
      case 1:
        return stand();
      case 2:
        machine_.boom = random_boom(random_, width_m_);
        return;
      case 3:
        return new_run(machine_.at + Point{uniform(random_, -10, 10), uniform(random_, -10, 10)});
      case 4:
        return again();
      case 5:
        return neighbour();
      case 6:
        return way(-step_m_, uniform(random_, -0.05, 0.05));
      default:
        return way(step_m_, one_in(random_, 3) ? 0 : uniform(random_, -0.4, 0.4));
    }
  }

  void new_run(Point at) {
    ++run_;
    travel_m_ = 0;
    machine_.at = at;
  }

  void go_to(const Machine& next) {
    WorkedStep step;
    const double moved_m = distance(machine_.at, next.at);
    travel_m_ += moved_m;
    for (const Stretch& s : machine_.boom)
      step.quads.push_back(
          {machine_.place(s.left), machine_.place(s.right), next.place(s.right), next.place(s.left)});
    step.run = run_;
    step.travel_m = travel_m_;
    step.reach_m = machine_.width();
    step.fix = steps_.size();
    machine_ = next;
    if (!step.quads.empty()) steps_.push_back(step);
  }

  void way(double step_m, double bend) {
    for (int i = any_of(random_, 2, 8); i > 0; --i) {
      Machine next = machine_;
      next.heading += bend + (noisy_ ? uniform(random_, -0.02, 0.02) : 0);
      next.at = next.at + step_m * Point{std::cos(next.heading), std::sin(next.heading)};
      go_to(next);
    }
    noisy_ = one_in(random_, 2);
  }

  void turn_on_the_spot() {
    const double by = uniform(random_, -1, 1);
    for (int i = any_of(random_, 1, 5); i > 0; --i) {
      Machine next = machine_;
      next.heading += by;
      go_to(next);
    }
  }

  void stand() {
    for (int i = any_of(random_, 1, 4); i > 0; --i) {
      Machine next = machine_;
      if (one_in(random_, 2))
        next.at = next.at + Point{uniform(random_, -0.02, 0.02), uniform(random_, -0.02, 0.02)};
      go_to(next);
    }
  }

  /// Some of the last steps once more, as another run.
  void again() {
    const int count = std::min(any_of(random_, 1, 6), static_cast<int>(steps_.size()));
    const std::vector<WorkedStep> last(steps_.end() - count, steps_.end());
    if (last.empty()) return;
    new_run(machine_.at);
    for (WorkedStep step : last) {
      step.run = run_;
      step.fix = steps_.size();
      steps_.push_back(step);
    }
    new_run(machine_.at);
  }

  /// Straight on, and back beside it: the two touch along their whole length.
  void neighbour() {
    const std::vector<Stretch> boom = machine_.boom;
    machine_.boom = {{0.5 * width_m_, -0.5 * width_m_}};
    const int count = any_of(random_, 2, 5);
    const auto straight = [&] {
      for (int i = 0; i < count; ++i) {
        Machine next = machine_;
        next.at = next.at + step_m_ * Point{std::cos(next.heading), std::sin(next.heading)};
        go_to(next);
      }
    };
    straight();
    new_run(machine_.place(width_m_));
    machine_.heading += std::numbers::pi;
    straight();
    machine_.boom = boom;
  }

  std::mt19937_64& random_;
  double step_m_ = 1;
  double width_m_ = 1;
  Machine machine_;
  std::vector<WorkedStep> steps_;
  int run_ = 0;
  double travel_m_ = 0;
  bool noisy_ = false;
};

Region random_region(std::mt19937_64& random, Point centre) {
  if (one_in(random, 6)) return {};
  const double size = uniform(random, 5, 60);
  Polygon out{random_star(random, centre, 0.4 * size, size, any_of(random, 4, 25)), {}};
  const Ring hole = random_star(random, centre, 0.05 * size, 0.35 * size, any_of(random, 3, 12));
  const bool fits = area(difference({{hole, {}}}, {out})) == 0;
  if (fits && one_in(random, 2)) out.holes.push_back(reversed(hole));
  return {out};
}

}  // namespace

Drive random_drive(std::mt19937_64& random, int length, double far_m) {
  const Point centre{uniform(random, -far_m, far_m), uniform(random, -far_m, far_m)};
  Drive out;
  out.field = random_region(random, centre);
  out.steps =
      Wanderer(random, centre + Point{uniform(random, -20, 20), uniform(random, -20, 20)}).drive(length);
  return out;
}

Drive moved(Drive drive, Point by) {
  for (Polygon& polygon : drive.field) {
    for (Point& p : polygon.outer) p = p + by;
    for (Ring& hole : polygon.holes)
      for (Point& p : hole) p = p + by;
  }
  for (WorkedStep& step : drive.steps)
    for (Quad& quad : step.quads)
      for (Point& p : quad) p = p + by;
  return drive;
}

}  // namespace tramline::testing
