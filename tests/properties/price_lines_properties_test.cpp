// Figures of given lines on random fields, against polygon booleans on bands that are made here.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "properties/draws.h"
#include "properties/random_field.h"
#include "properties/seeds.h"
#include "support/refusals.h"
#include "tramline/check/verify.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/planner/plan_field.h"
#include "tramline/planner/price/price_lines.h"

namespace tramline {
namespace {

using testing::for_each_seed;
using testing::random_field;
using Polyline = std::vector<Point>;

struct Given {
  Field field;
  Machine machine;
  std::vector<Polyline> lines;
};

/// Those of a plan, straight ones between the ends of its pieces.
std::vector<Polyline> lines_of(const Plan& plan) {
  std::vector<Polyline> out;
  for (const TrackPiece& piece : plan.pieces) out.push_back({piece.start, piece.end});
  return out;
}

Point somewhere(std::mt19937_64& random, const Box& box) {
  return {uniform(random, box.min_x - 20, box.max_x + 20), uniform(random, box.min_y - 20, box.max_y + 20)};
}

/// Moved, turned, doubled, cut in two, driven backwards, bent: what people do to lines, and worse.
void change(std::mt19937_64& random, const Box& box, double width_m, std::vector<Polyline>& lines) {
  const auto pick = [&] {
    return static_cast<std::size_t>(any_of(random, 0, static_cast<int>(lines.size()) - 1));
  };
  Polyline& line = lines[pick()];
  switch (any_of(random, 0, 7)) {
    case 0: {
      const Point by{uniform(random, -width_m, width_m), uniform(random, -width_m, width_m)};
      for (Point& p : line) p = p + by;
      break;
    }
    case 1: {
      const double angle = uniform(random, -0.3, 0.3), c = std::cos(angle), s = std::sin(angle);
      const Point about = line.front();
      for (Point& p : line) {
        const Point d = p - about;
        p = about + Point{d.x * c - d.y * s, d.x * s + d.y * c};
      }
      break;
    }
    case 2: {
      const Polyline copy = line;
      lines.push_back(copy);
      break;
    }
    case 3: {
      const Point at = midpoint(line.front(), line[1]);
      Polyline rest = line;
      rest.front() = at;
      line = {line.front(), at};
      lines.push_back(rest);
      break;
    }
    case 4:
      std::reverse(line.begin(), line.end());
      break;
    case 5: {  // a few vertices off the line, a hand's shake
      Polyline bent{line.front()};
      for (int k = 1; k < 6; ++k) {
        const Point on = line.front() + (k / 6.0) * (line[1] - line.front());
        bent.push_back(on + Point{uniform(random, -2, 2), uniform(random, -2, 2)});
      }
      bent.insert(bent.end(), line.begin() + 1, line.end());
      line = bent;
      break;
    }
    case 6: {  // anywhere: sharp kinks, crossings of itself
      Polyline wild;
      const int count = any_of(random, 2, 7);
      for (int k = 0; k < count; ++k) wild.push_back(somewhere(random, box));
      lines.push_back(wild);
      break;
    }
    default: {  // there and back again, vertices twice, ends that meet
      Polyline back = line;
      back.push_back(line.back());
      for (auto p = line.rbegin() + 1; p != line.rend(); ++p) back.push_back(*p);
      lines.push_back(back);
      break;
    }
  }
}

std::optional<Given> random_given(std::mt19937_64& random) {
  Given out;
  out.field = random_field(random, 4);
  out.machine.width_m = uniform(random, 3, 15);
  out.machine.radius_m = 6;
  PlanSettings settings;
  settings.strategy = Strategy::kSweep;
  settings.avoid = Avoidance::kCut;
  const std::optional<Plan> plan = testing_support::unless_refused(
      [&] { return plan_field(out.field, out.machine, Objective{}, settings, 1); });
  if (!plan || plan->pieces.empty()) return std::nullopt;
  out.lines = lines_of(*plan);
  const int changes = any_of(random, 0, 12);
  for (int i = 0; i < changes; ++i) change(random, bounds(out.field.outer), out.machine.width_m, out.lines);
  return out;
}

/// The bands of the segments of a line, by the definition: flat where a kink is sharper than 120° or a
/// bisector meets its neighbour's within the band, else cut to the bisectors.
Region bands_of(Polyline given, double width_m) {
  Polyline line;
  for (const Point p : given)
    if (line.empty() || distance(line.back(), p) > 1e-6) line.push_back(p);
  Region out;
  if (line.size() < 2) return out;
  if (line.size() > 2 && distance(line.front(), line.back()) <= 1e-6) {  // a ring is opened by 0.1 mm
    const Point d = line[line.size() - 2] - line.back();
    line.back() = line.back() + (std::min(1e-4, 0.5 * length(d)) / length(d)) * d;
  }
  const std::size_t n = line.size() - 1;
  const auto unit = [&](std::size_t i) {
    return (1 / distance(line[i], line[i + 1])) * (line[i + 1] - line[i]);
  };
  // By how much the left corner lies ahead of joint i, along the segment; the right one as much behind.
  std::vector<double> ahead(n + 1, 0.0);
  for (std::size_t i = 1; i < n; ++i) {
    const double turn = std::atan2(cross(unit(i - 1), unit(i)), dot(unit(i - 1), unit(i)));
    if (std::abs(turn) <= 2 * std::acos(-1.0) / 3) ahead[i] = -0.5 * width_m * std::tan(0.5 * turn);
  }
  for (bool changed = true; changed;) {
    changed = false;
    for (std::size_t i = 0; i < n; ++i)
      if (std::abs(ahead[i] + ahead[i + 1]) > distance(line[i], line[i + 1])) {
        ahead[i] = ahead[i + 1] = 0;
        changed = true;
      }
  }
  for (std::size_t i = 0; i < n; ++i) {
    const Point u = unit(i), left = 0.5 * width_m * Point{-u.y, u.x};
    out.push_back({{line[i] - left + ahead[i] * u, line[i + 1] - left - ahead[i + 1] * u,
                    line[i + 1] + left + ahead[i + 1] * u, line[i] + left - ahead[i] * u},
                   {}});
  }
  return out;
}

/// By halves where one overlay of all is too much for GEOS.
Region united(const Region& parts) {
  try {
    return unite(parts);
  } catch (const Error&) {
    if (parts.size() < 3) throw;
  }
  const auto middle = parts.begin() + static_cast<std::ptrdiff_t>(parts.size() / 2);
  return unite(united({parts.begin(), middle}), united({middle, parts.end()}));
}

/// The area of the land that the bands cover. Some cases of a hundred are too much for GEOS on
/// one grid, and one of a thousand on five: nullopt.
std::optional<double> common_m2(Region bands, Region land) {
  for (int tries = 1;; ++tries) {
    try {
      return area(intersection(united(bands), land));
    } catch (const Error&) {
      if (tries == 5) return std::nullopt;
    }
    for (Region* region : {&bands, &land})
      for (Polygon& polygon : *region) {
        for (Point& p : polygon.outer) p = p + Point{0.31e-6, 0.17e-6};
        for (Ring& hole : polygon.holes)
          for (Point& p : hole) p = p + Point{0.31e-6, 0.17e-6};
      }
  }
}

double length_of(const Polyline& line) {
  double sum_m = 0;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) sum_m += distance(line[i], line[i + 1]);
  return sum_m;
}

GivenLines as_lines(const std::vector<Polyline>& lines) {
  GivenLines out;
  for (const Polyline& points : lines) {
    GivenLine line;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) line.path.push_back({points[i], points[i + 1], 0});
    out.tracks.push_back(line);
  }
  return out;
}

template <class Property>
void for_random_lines(int standard, Property property) {
  int priced = 0;
  for_each_seed(standard, [&](std::mt19937_64& random, int) {
    const std::optional<Given> given = random_given(random);
    if (!given) return;
    ++priced;
    try {
      property(*given,
               price_lines(given->field, given->machine, Objective{}, as_lines(given->lines), 0).plan);
    } catch (const Error& error) {
      ADD_FAILURE() << error.what();
    }
  });
  EXPECT_TRUE(::testing::Test::HasFailure() || 4 * priced >= 3 * testing::case_count(standard))
      << "too few of the fields could be planned";
}

// The union of all bands on a grid of 1e-6 m, whose edges move by less than that: 1e-6 m times their length,
// and the land's. Each crossing of edges is rounded once more.
TEST(PriceLinesProperties, FiguresAreThoseOfPolygonBooleans) {
  for_random_lines(80, [](const Given& given, const Plan& plan) {
    Region bands, land{{given.field.outer, {}}};
    double worked_m2 = 0, edges_m = perimeter(given.field.outer);
    for (const Polyline& line : given.lines) {
      for (Polygon& band : bands_of(line, given.machine.width_m)) {
        edges_m += perimeter(band.outer);
        bands.push_back(std::move(band));
      }
      worked_m2 += given.machine.width_m * length_of(line);
    }
    for (const Obstacle& obstacle : given.field.obstacles) land = difference(land, {obstacle.shape});
    const std::optional<double> common = common_m2(bands, land);
    if (!common) return;
    const double covered_m2 = *common;
    const double opened_m2 = 1e-4 * given.machine.width_m * static_cast<double>(given.lines.size());
    const double tolerance_m2 = 2e-6 * edges_m + opened_m2;
    EXPECT_NEAR(plan.tally.worked_m2, worked_m2, opened_m2 + 1e-5 * given.machine.width_m);
    EXPECT_NEAR(plan.tally.overlap_m2, worked_m2 - covered_m2, tolerance_m2);
    EXPECT_NEAR(plan.tally.uncovered_m2, area(land) - covered_m2, tolerance_m2);
    EXPECT_NEAR(identity_error_m2(plan), 0, 1e-6);
  });
}

TEST(PriceLinesProperties, TheVerifierFindsTheSameFigures) {
  for_random_lines(60, [](const Given&, const Plan& plan) {
    const check::Verdict verdict = check::verify(plan);
    EXPECT_TRUE(verdict.complete);
    for (const check::Violation& violation : verdict.violations)
      ADD_FAILURE() << name(violation.rule) << ": " << violation.what;
    double by_line_m2 = 0;
    for (const TrackPiece& piece : plan.pieces) by_line_m2 += piece.overlap_m2.value_or(0);
    EXPECT_NEAR(by_line_m2, plan.tally.overlap_m2, 1e-4);
  });
}

// The order of the lines changes nothing but who is the first to work land. (The way they are driven may:
// which of several short stretches between kinks are flat is decided from the beginning of a line.)
TEST(PriceLinesProperties, OrderDoesNotMatterForAreas) {
  for_random_lines(40, [](const Given& given, const Plan& plan) {
    std::vector<Polyline> turned = given.lines;
    std::reverse(turned.begin(), turned.end());
    const Plan other = price_lines(given.field, given.machine, Objective{}, as_lines(turned), 0).plan;
    EXPECT_NEAR(other.tally.overlap_m2, plan.tally.overlap_m2, 1e-6);
    EXPECT_NEAR(other.tally.uncovered_m2, plan.tally.uncovered_m2, 1e-6);
    EXPECT_EQ(other.tally.turns, plan.tally.turns);
    EXPECT_EQ(other.tally.stops, plan.tally.stops);
  });
}

}  // namespace
}  // namespace tramline
