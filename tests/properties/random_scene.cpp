#include "properties/random_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "properties/random_field.h"
#include "tramline/admission/read_obstacles.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/geometry/tolerances.h"

namespace tramline::testing {
namespace {

constexpr double kPi = std::numbers::pi;

/// The generator with the draws that scenes are made of.
class Dice {
 public:
  explicit Dice(std::mt19937_64& random) : random_(random) {}
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  /// As likely between 1 and 2 as between 10 and 20.
  double sized(double from, double to) { return std::exp(uniform(std::log(from), std::log(to))); }
  int whole(int from, int to) { return std::uniform_int_distribution<int>(from, to)(random_); }
  bool once_in(int n) { return whole(1, n) == 1; }
  std::mt19937_64& engine() { return random_; }

 private:
  std::mt19937_64& random_;
};

Ring placed(Ring ring, double angle, Point at) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (Point& p : ring) p = {on_grid(at.x + c * p.x - s * p.y), on_grid(at.y + s * p.x + c * p.y)};
  return ring;
}

Ring box(double width, double height) {
  return {{-0.5 * width, -0.5 * height},
          {0.5 * width, -0.5 * height},
          {0.5 * width, 0.5 * height},
          {-0.5 * width, 0.5 * height}};
}

/// An L whose arms are `arm` wide.
Ring corner_shape(double width, double height, double arm) {
  return {{0, 0}, {width, 0}, {width, arm}, {arm, arm}, {arm, height}, {0, height}};
}

Ring u_shape(double width, double height, double arm) {
  return {{0, 0},     {width, 0},    {width, height}, {width - arm, height}, {width - arm, arm},
          {arm, arm}, {arm, height}, {0, height}};
}

Ring regular(int corners, double radius) {
  Ring ring;
  for (int i = 0; i < corners; ++i)
    ring.push_back({radius * std::cos(2 * kPi * i / corners), radius * std::sin(2 * kPi * i / corners)});
  return ring;
}

Ring outer_ring(Dice& dice, double angle) {
  const double side = std::sqrt(dice.sized(5e3, 1e5)), slim = dice.sized(1, 3);
  const double width = side * std::sqrt(slim), height = side / std::sqrt(slim);
  switch (dice.whole(0, 2)) {
    case 0:
      return random_star(dice.engine(), {0, 0}, 0.4 * side, 0.75 * side, dice.whole(4, 8));
    case 1: {
      Ring ring = box(width, height);
      if (dice.once_in(2))
        for (Point& p : ring) p = p + 0.15 * side * Point{dice.uniform(-1, 1), dice.uniform(-1, 1)};
      return placed(ring, angle, {});
    }
    default:
      return placed(corner_shape(width, height, dice.uniform(0.3, 0.7) * std::min(width, height)), angle,
                    {-0.5 * width, -0.5 * height});
  }
}

/// What the obstacles of one scene have in common. Every direction of an edge is one more to plan for, so
/// there are only few.
struct Style {
  std::array<double, 2> angles;
  int disc_corners;
  std::array<Ring, 2> stars;
};

Style random_style(Dice& dice) {
  Style out{{dice.uniform(0, kPi), dice.uniform(0, kPi)}, 8 * dice.whole(1, 4), {}};
  for (Ring& star : out.stars) {
    const double size = dice.sized(1, 25);
    star = random_star(dice.engine(), {0, 0}, 0.2 * size, size, dice.whole(3, 6));
  }
  return out;
}

Ring obstacle_ring(Dice& dice, const Style& style, Point at) {
  const double angle = style.angles[static_cast<std::size_t>(dice.whole(0, 1))];
  const double across = dice.sized(1, 25), along = dice.sized(1, 25);
  const double arm = dice.uniform(0.1, 0.4) * std::min(across, along);
  switch (dice.whole(0, 7)) {
    case 0:
    case 1: {
      const double side = std::sqrt(dice.uniform(0.3, 4));
      return placed(box(side, side), angle, at);
    }
    case 2:
      return placed(regular(style.disc_corners, dice.sized(0.3, 12)), style.angles[0], at);
    case 3:
      return placed(box(0.05, 20), angle, at);
    case 4:
      return placed(box(across, along), angle, at);
    case 5:
      return placed(style.stars[static_cast<std::size_t>(dice.whole(0, 1))], 0, at);
    case 6:
      return placed(corner_shape(across, along, arm), angle, at);
    default:
      return placed(u_shape(across, along, arm), angle, at);
  }
}

Point any_place(Dice& dice, const Field& field, const std::vector<LooseObstacle>& others) {
  if (dice.once_in(6)) {  // at the edge, sometimes on a corner
    const std::size_t i = static_cast<std::size_t>(dice.whole(0, static_cast<int>(field.outer.size()) - 1));
    const double share = dice.once_in(4) ? 0 : dice.uniform(0, 1);
    const Point a = field.outer[i], b = field.outer[(i + 1) % field.outer.size()];
    return a + share * (b - a);
  }
  if (!others.empty() && dice.once_in(6)) {  // by or over another
    const std::size_t i = static_cast<std::size_t>(dice.whole(0, static_cast<int>(others.size()) - 1));
    const double off = dice.once_in(3) ? 0 : dice.sized(0.5, 30), angle = dice.uniform(0, 2 * kPi);
    return others[i].bounds.centre() + off * Point{std::cos(angle), std::sin(angle)};
  }
  const Box reach = bounds(field.outer);
  return {dice.uniform(reach.min_x, reach.max_x), dice.uniform(reach.min_y, reach.max_y)};
}

Field random_ground(Dice& dice) {
  Field field;
  field.id = "scene";
  const Style style = random_style(dice);
  field.outer = outer_ring(dice, style.angles[0]);
  std::vector<LooseObstacle> loose;
  const int count = static_cast<int>(dice.sized(1, 31));
  const bool passable_too = dice.once_in(4);
  for (int i = 0; i < count; ++i) {
    const Ring ring = obstacle_ring(dice, style, any_place(dice, field, loose));
    const bool passable = passable_too && dice.once_in(4);
    loose.push_back({"obstacle " + std::to_string(i),
                     passable ? ObstacleKind::kPassable : ObstacleKind::kObstacle,
                     {{{{ring, true}}}},
                     {},
                     {},
                     bounds(ring)});
  }
  if (passable_too && dice.once_in(2)) {
    const Ring ditch =
        placed(box(1000, dice.uniform(0.5, 6)), style.angles[1], any_place(dice, field, loose));
    loose.push_back({"ditch", ObstacleKind::kPassable, {{{{ditch, true}}}}, {}, {}, bounds(ditch)});
  }
  std::vector<char> met(loose.size());
  place_obstacles(field, loose, 1, met);
  return field;
}

Objective random_prices(Dice& dice) {
  Objective out;
  for (double* price : {&out.overlap, &out.uncovered, &out.turn, &out.stop})
    if (dice.once_in(3))
      *price =
          std::array{0.0, 1.0, 99999.0, dice.sized(0.01, 100)}[static_cast<std::size_t>(dice.whole(0, 3))];
  return out;
}

PlanSettings random_settings(Dice& dice, double width_m) {
  PlanSettings out;
  out.end_rule = static_cast<EndRule>(dice.whole(0, 3));
  out.boundary = dice.once_in(3) ? EdgeKind::kHard : EdgeKind::kSoft;
  out.cell_direction = static_cast<CellDirection>(dice.whole(0, 1));
  out.merge_threshold = Angle::degrees(15 * dice.whole(0, 2));
  out.decomposition_threshold = Angle::degrees(180 + 25 * dice.whole(0, 2));
  out.clearance_m = dice.once_in(2) ? 0 : dice.uniform(0, 2);
  if (dice.once_in(2)) out.avoid_threshold_m = dice.uniform(0, 3 * width_m);
  return out;
}

}  // namespace

Scene random_scene(std::mt19937_64& random) {
  Dice dice(random);
  Scene out;
  out.field = random_ground(dice);
  // Hardly ever more than 60 tracks: the same happens on fewer.
  const Box reach = bounds(out.field.outer);
  const double narrow = dice.once_in(40) ? 1 : std::max(1.0, std::hypot(reach.width(), reach.height()) / 60);
  out.machine.width_m = dice.sized(narrow, 30);
  if (dice.once_in(2)) out.machine.width_m = std::ceil(out.machine.width_m);
  out.machine.radius_m = dice.once_in(4) ? 0 : dice.uniform(0, 15);
  if (dice.once_in(4)) out.machine.min_length_m = dice.uniform(0, 4 * out.machine.width_m);
  out.objective = random_prices(dice);
  out.settings = random_settings(dice, out.machine.width_m);
  return out;
}

}  // namespace tramline::testing
