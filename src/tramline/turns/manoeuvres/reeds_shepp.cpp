#include "tramline/turns/manoeuvres/reeds_shepp.h"

#include <array>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "tramline/turns/manoeuvres/driven_word.h"
#include "tramline/turns/manoeuvres/relative_pose.h"
#include "tramline/turns/tolerances.h"

namespace tramline {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

/// The target in units of the radius; turn in [−π, π).
struct UnitTarget {
  double x = 0, y = 0, turn = 0, sine = 0, cosine = 1;
};

/// How a family's first member is turned into the others (Reeds and Shepp 1990, §8): driven in the other
/// gear, mirrored, or from its end to its start.
enum class Flip { kNone, kGears, kSides, kBoth };

/// A member: letters as of the first one, parts with their sign (negative: in reverse, before the flip).
struct ReedsSheppNumbers {
  const char* letters = "";
  std::array<double, 5> parts{};
  int count = 0;
  Flip flip = Flip::kNone;
  enum class Order { kOnward, kBackward } order = Order::kOnward;

  double length() const {
    double sum = 0;
    for (const double part : parts) sum += std::abs(part);
    return sum;
  }
};
using Order = ReedsSheppNumbers::Order;

struct PolarPlace {
  double square, angle;
  double distance() const { return std::sqrt(square); }
};

bool nearly_positive(double value) { return value >= -kNoTurnAtRadius_rad; }

UnitTarget flipped(const UnitTarget& to, Flip flip) {
  const bool gears = flip == Flip::kGears || flip == Flip::kBoth;
  const bool sides = flip == Flip::kSides || flip == Flip::kBoth;
  const double sign = gears != sides ? -1 : 1;
  return {gears ? -to.x : to.x, sides ? -to.y : to.y, sign * to.turn, sign * to.sine, to.cosine};
}

UnitTarget seen_backward(const UnitTarget& to) {
  return {to.x * to.cosine + to.y * to.sine, to.x * to.sine - to.y * to.cosine, to.turn, to.sine, to.cosine};
}

/// The families for one flip of the target. Numbers of the paper's formulas at each. `visit` is given parts
/// with their signs; each family is left as soon as its length exceeds what `most` says.
template <class Visit>
class Families {
 public:
  Families(const UnitTarget& to, Flip flip, const double& most, Visit& visit)
      : to_(flipped(to, flip)), flip_(flip), most_(most), visit_(visit) {}

  void all() {
    const UnitTarget backward = seen_backward(to_);
    lsl();
    lsr();
    lrl(to_, Order::kOnward);
    lrl(backward, Order::kBackward);
    lr_lr();
    l_rl_r();
    for (const Order order : {Order::kOnward, Order::kBackward}) {
      const UnitTarget& target = order == Order::kOnward ? to_ : backward;
      lrsl(target, order);
      lrsr(target, order);
    }
    lrslr();
  }

 private:
  /// Vectors between the centres of the outer turns.
  static Point to_left(const UnitTarget& to) { return {to.x - to.sine, to.y - 1 + to.cosine}; }
  static Point to_right(const UnitTarget& to) { return {to.x + to.sine, to.y - 1 - to.cosine}; }

  void found(const char* letters, std::array<double, 5> parts, int count, Order order) {
    visit_(ReedsSheppNumbers{letters, parts, count, flip_, order});
  }

  void lsl() {  // 8.1
    const Point way = to_left(to_);
    const double u = std::sqrt(dot(way, way));
    if (u > most_) return;
    const double t = u <= kNoLine ? 0 : std::atan2(way.y, way.x), v = in_half_circles(to_.turn - t);
    if (nearly_positive(t) && nearly_positive(v)) found("LSL", {t, u, v}, 3, Order::kOnward);
  }

  void lsr() {  // 8.2
    const Point way = to_right(to_);
    const double square = dot(way, way) - 4;
    if (square < -4 * kTouches) return;
    const double u = std::sqrt(std::max(0.0, square));
    if (u > most_) return;
    const double t = in_half_circles(std::atan2(way.y, way.x) + std::atan2(2, u));
    const double v = in_half_circles(t - to_.turn);
    if (nearly_positive(t) && nearly_positive(v)) found("LSR", {t, u, v}, 3, Order::kOnward);
  }

  void lrl(const UnitTarget& to, Order order) {  // 8.3 and 8.4: L+ R− L±
    const Point way = to_left(to);
    const double square = dot(way, way);
    if (square > 16 * (1 + kTouches)) return;
    const double u = -2 * std::asin(std::min(1.0, 0.25 * std::sqrt(square)));
    const double angle = square <= kNoLine * kNoLine ? 0 : std::atan2(way.y, way.x);
    const double t = in_half_circles(angle + 0.5 * u + std::numbers::pi);
    const double v = in_half_circles(to.turn - t + u);
    if (nearly_positive(t)) found("LRL", {t, u, v}, 3, order);
  }

  /// First and last turn of the words of four, from the two in the middle.
  std::array<double, 2> outer_turns(double u, double v, Point way) const {
    const double between = in_half_circles(u - v);
    const double a = std::sin(u) - std::sin(between), b = std::cos(u) - std::cos(between) - 1;
    const double towards = std::atan2(way.y * a - way.x * b, way.x * a + way.y * b);
    const bool far_side = 2 * (std::cos(between) - std::cos(v) - std::cos(u)) + 3 < 0;
    const double t = in_half_circles(towards + (far_side ? std::numbers::pi : 0));
    return {t, in_half_circles(t - u + v - to_.turn)};
  }

  void lr_lr() {  // 8.7: L+ R+ L− R−
    const Point way = to_right(to_);
    const double share = 0.25 * (2 + std::sqrt(dot(way, way)));
    if (share > 1 + kTouches) return;
    const double u = std::acos(std::min(1.0, share));
    const auto [t, v] = outer_turns(u, -u, way);
    if (nearly_positive(t) && nearly_positive(-v)) found("LRLR", {t, u, -u, v}, 4, Order::kOnward);
  }

  void l_rl_r() {  // 8.8: L+ R− L− R+
    const Point way = to_right(to_);
    const double share = (20 - dot(way, way)) / 16;
    if (share < 0 || share > 1 + kTouches) return;
    const double u = -std::acos(std::min(1.0, share));
    const auto [t, v] = outer_turns(u, u, way);
    if (nearly_positive(t) && nearly_positive(v)) found("LRLR", {t, u, u, v}, 4, Order::kOnward);
  }

  void lrsl(const UnitTarget& to, Order order) {  // 8.9: L+ R− S− L−
    const Point way = to_left(to);
    const double square = dot(way, way);
    if (square < 4) return;
    const double r = std::sqrt(square - 4), u = 2 - r;
    if (u > kNoLine || kQuarter - u > most_) return;
    const double t = in_half_circles(std::atan2(way.y, way.x) + std::atan2(r, -2));
    const double v = in_half_circles(to.turn - kQuarter - t);
    if (nearly_positive(t) && nearly_positive(-v)) found("LRSL", {t, -kQuarter, u, v}, 4, order);
  }

  void lrsr(const UnitTarget& to, Order order) {  // 8.10: L+ R− S− R−
    const Point way = to_right(to);
    const double u = 2 - std::sqrt(dot(way, way));
    if (u > kNoLine || kQuarter - u > most_) return;
    const double t = std::atan2(way.x, -way.y), v = in_half_circles(t + kQuarter - to.turn);
    if (nearly_positive(t) && nearly_positive(-v)) found("LRSR", {t, -kQuarter, u, v}, 4, order);
  }

  void lrslr() {  // 8.11: L+ R− S− L− R+
    const Point way = to_right(to_);
    const double square = dot(way, way) - 4;
    if (square < 0) return;
    const double u = 4 - std::sqrt(square);
    if (u > kNoLine || 2 * kQuarter - u > most_) return;
    const double t = std::atan2((4 - u) * way.x - 2 * way.y, -2 * way.x + (u - 4) * way.y);
    const double v = in_half_circles(t - to_.turn);
    if (nearly_positive(t) && nearly_positive(v))
      found("LRSLR", {t, -kQuarter, u, -kQuarter, v}, 5, Order::kOnward);
  }

  UnitTarget to_;
  Flip flip_;
  const double& most_;
  Visit& visit_;
};

template <class Visit>
void for_each_reeds_shepp(const Pose& from, const Pose& to, double radius_m, const double& most,
                          Visit visit) {
  const RelativePose target = relative(from, to);
  const double turn = target.turn >= std::numbers::pi ? target.turn - kWholeCircle : target.turn;
  const UnitTarget unit{target.ahead / radius_m, target.left / radius_m, turn, target.sine, target.cosine};
  for (const Flip flip : {Flip::kNone, Flip::kGears, Flip::kSides, Flip::kBoth})
    Families<Visit>(unit, flip, most, visit).all();
}

Word word_of(const ReedsSheppNumbers& numbers, double radius_m) {
  const bool gears = numbers.flip == Flip::kGears || numbers.flip == Flip::kBoth;
  const bool sides = numbers.flip == Flip::kSides || numbers.flip == Flip::kBoth;
  Word word;
  for (int i = 0; i < numbers.count; ++i) {
    const auto at = static_cast<std::size_t>(numbers.order == Order::kOnward ? i : numbers.count - 1 - i);
    const char letter = numbers.letters[at];
    const double amount = numbers.parts[at];
    const bool reverse = (amount < 0) != gears;
    if (std::abs(amount) <= kNoTurnAtRadius_rad) continue;
    word.push_back({letter == 'S' || !sides ? letter : (letter == 'L' ? 'R' : 'L'),
                    std::abs(amount) * (letter == 'S' ? radius_m : 1),
                    reverse ? Gear::kReverse : Gear::kForward});
  }
  return word;
}

Manoeuvre manoeuvre_of(const Pose& from, const ReedsSheppNumbers& numbers, double radius_m) {
  return *driven(from, word_of(numbers, radius_m), arc_turns(radius_m), ManoeuvreKind::kReedsShepp);
}

}  // namespace

std::vector<Manoeuvre> reeds_shepp_words(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  std::vector<Manoeuvre> out;
  const double any = std::numeric_limits<double>::infinity();
  for_each_reeds_shepp(from, to, radius_m, any, [&](const ReedsSheppNumbers& numbers) {
    out.push_back(manoeuvre_of(from, numbers, radius_m));
  });
  sort_by_length(out);
  drop_repeated(out);
  return out;
}

double reeds_shepp_length(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  double least = std::numeric_limits<double>::infinity();
  for_each_reeds_shepp(from, to, radius_m, least,
                       [&](const ReedsSheppNumbers& numbers) { least = std::min(least, numbers.length()); });
  return radius_m * least;
}

double least_length(const Pose& from, const Pose& to, double radius_m) {
  const Point a = from.heading.unit(), b = to.heading.unit();
  const double turned = std::atan2(std::abs(cross(a, b)), dot(a, b));
  return std::max(distance(from.at, to.at), radius_m * turned);
}

Manoeuvre shortest_reeds_shepp(const Pose& from, const Pose& to, double radius_m) {
  assert(radius_m > 0);
  double least = std::numeric_limits<double>::infinity();
  ReedsSheppNumbers shortest;
  for_each_reeds_shepp(from, to, radius_m, least, [&](const ReedsSheppNumbers& numbers) {
    if (numbers.length() >= least - kEqualAmount / radius_m) return;
    least = numbers.length();
    shortest = numbers;
  });
  return manoeuvre_of(from, shortest, radius_m);
}

}  // namespace tramline
