// How much is applied where: values by hand, and nothing is lost.

#include "tramline/coverage/dose/dose.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>

#include "coverage/logs.h"
#include "support/refusals.h"
#include "tramline/coverage/dose/region_in_cells.h"
#include "tramline/coverage/dose/wind_drift.h"
#include "tramline/coverage/drive/step_maker.h"
#include "tramline/geometry/polygon/boolean.h"

namespace tramline::coverage {
namespace {

using namespace testing_logs;
using testing_support::mentions;
using testing_support::refusal_of;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();

DoseSettings settings_at(double rate_per_ha, double cell_m = 1) {
  DoseSettings out;
  out.rates.nominal_per_ha = rate_per_ha;
  out.cell_m = cell_m;
  return out;
}

/// A pass along y, one fix a second.
std::vector<Fix> pass(Point from, Point to, double start_s = 0, double speed_mps = 1) {
  std::vector<Fix> out;
  const double way_m = distance(from, to);
  const int steps = static_cast<int>(std::lround(way_m / speed_mps));
  for (int i = 0; i <= steps; ++i)
    out.push_back(
        fix(start_s + i, from + (1.0 * i / steps) * (to - from), Heading::from_to(from, to).degrees()));
  return out;
}

std::vector<Fix> both(std::vector<Fix> a, const std::vector<Fix>& b) {
  a.push_back(idle(b.front()));
  a.back().time_s = b.front().time_s - 100;
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

double sum(const std::vector<double>& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

double rate_at(const DoseMap& map, Point p) {
  const int column = static_cast<int>(std::floor((p.x - map.grid.low.x) / map.grid.cell_m));
  const int row = static_cast<int>(std::floor((p.y - map.grid.low.y) / map.grid.cell_m));
  if (column < 0 || row < 0 || column >= map.grid.columns || row >= map.grid.rows) return 0;
  return rate_per_ha(map, map.grid.index(column, row));
}

TEST(Dose, AStraightPassHasTheNominalRateInEveryCell) {
  // 10 m wide, 40 m long, its edges on lines of the grid: 400 m² at 250 l/ha are 10 l.
  const DoseMap map = dose(log(pass({5, 0}, {5, 40}), 10), {}, settings_at(250), {});
  ASSERT_EQ(map.grid.columns, 10);
  ASSERT_EQ(map.grid.rows, 40);
  for (std::size_t i = 0; i < map.grid.size(); ++i) EXPECT_NEAR(rate_per_ha(map, i), 250, 1e-6);
  EXPECT_NEAR(map.figures.total, 10, 1e-9);
  EXPECT_NEAR(map.nominal_amount, 10, 1e-9);
  EXPECT_NEAR(map.figures.cv, 0, 1e-9);
  EXPECT_NEAR(map.figures.share_within_10, 1, 1e-12);
  EXPECT_NEAR(map.covered_m2, 400, 1e-3);
}

TEST(Dose, ASlantingPassHasTheNominalRateOnItsGround) {
  // Along (3, 4)/5; cells wholly inside have the rate, the others the share of them that is covered.
  const DoseMap map = dose(log(pass({0, 0}, {30, 40}), 8), {}, settings_at(100), {});
  EXPECT_NEAR(rate_at(map, {15.5, 20.5}), 100, 1e-6);
  EXPECT_NEAR(map.figures.total, 8 * 50 / 100.0, 1e-9);
  EXPECT_NEAR(map.figures.mean_per_ha, 100, 1e-3);
  EXPECT_NEAR(map.figures.cv, 0, 1e-5);
  for (std::size_t i = 0; i < map.grid.size(); ++i)
    EXPECT_NEAR(rate_per_ha(map, i), 100 * static_cast<double>(map.ground[i]), 1e-3);
}

TEST(Dose, GroundWorkedTwiceGetsTwiceAsMuch) {
  // The second pass covers x from 6 to 16.
  const auto passes = both(pass({5, 0}, {5, 40}), pass({11, 0}, {11, 40}, 1000));
  const DoseMap map = dose(log(passes, 10), {}, settings_at(200), {});
  EXPECT_NEAR(rate_at(map, {3.5, 20.5}), 200, 1e-6);
  EXPECT_NEAR(rate_at(map, {8.5, 20.5}), 400, 1e-6);
  EXPECT_NEAR(rate_at(map, {13.5, 20.5}), 200, 1e-6);
  // 12 m once and 4 m twice: mean 200 · 20/16, variance from the two-valued distribution by hand.
  EXPECT_NEAR(map.figures.mean_per_ha, 250, 1e-3);
  EXPECT_NEAR(map.figures.cv, std::sqrt(0.75 * 50 * 50 + 0.25 * 150 * 150) / 250, 1e-6);
  EXPECT_NEAR(map.figures.share_within_10, 0.75, 1e-6);
}

TEST(Dose, ATrianglesOverlapIsEven) {
  // A triangle over 12 m is 2 in the middle; passes 6 m apart sum to 2 everywhere between them.
  DoseSettings settings = settings_at(100, 0.5);
  settings.pattern = {{-6, 0}, {0, 7}, {6, 0}};
  const auto passes = both(pass({0, 0}, {0, 40}), pass({6, 0}, {6, 40}, 1000));
  const DoseMap map = dose(log(passes, 12), {}, settings, {});
  for (double x = 0.25; x < 6; x += 0.5) EXPECT_NEAR(rate_at(map, {x, 20.25}), 200, 1e-6) << x;
  // A cell at the rim of the triangle: its mean is the triangle in its middle, 2 · 0.25/6 of the rate.
  EXPECT_NEAR(rate_at(map, {-5.75, 20.25}), 100 * 2 * 0.25 / 6, 1e-6);
  EXPECT_NEAR(map.figures.total, 2 * 12 * 40 / 100.0, 1e-9);
}

TEST(Dose, APatternWiderThanTheMachineLandsBeyondIt) {
  // Working width 6 m, a triangle over 12 m: its integral is 6, so 1 in the middle; the sum is the rate.
  DoseSettings settings = settings_at(100, 0.5);
  settings.pattern = {{6, 0}, {0, 1}, {-6, 0}};
  const auto passes = both(pass({0, 0}, {0, 40}), pass({6, 0}, {6, 40}, 1000));
  const DoseMap map = dose(log(passes, 6), {}, settings, {});
  for (double x = 0.25; x < 6; x += 0.5) EXPECT_NEAR(rate_at(map, {x, 20.25}), 100, 1e-6) << x;
  EXPECT_NEAR(map.figures.total, 2 * 6 * 40 / 100.0, 1e-9);
}

TEST(Dose, AClosedSectionLaysNothing) {
  WorkLog drive = log({}, 8);
  drive.booms = {boom(4, 8)};
  for (const Fix& f : pass({4, 0}, {4, 20})) drive.fixes.push_back(with_sections(f, "1101"));
  const DoseMap map = dose(drive, {}, settings_at(100), {});
  // Left is west on the way north: the third section from the left is x from 4 to 6.
  EXPECT_NEAR(rate_at(map, {3.5, 10.5}), 100, 1e-6);
  EXPECT_NEAR(rate_at(map, {4.5, 10.5}), 0, 1e-12);
  EXPECT_NEAR(rate_at(map, {6.5, 10.5}), 100, 1e-6);
  EXPECT_NEAR(map.figures.total, 6 * 20 / 100.0, 1e-9);
}

TEST(Dose, TheInsideOfABendGetsMore) {
  // A ring driven anticlockwise about the origin at 20 m: a nozzle at distance d from the hub covers d/20 of
  // the middle's way, and lays 20/d of the rate.
  std::vector<Fix> fixes;
  constexpr int kSteps = 720;
  for (int i = 0; i <= kSteps; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSteps;
    fixes.push_back(fix(i, {20 * std::cos(angle), 20 * std::sin(angle)}, -angle * 180 / std::numbers::pi));
  }
  const DoseMap map = dose(log(fixes, 10), {}, settings_at(100, 0.25), {});
  for (const double d : {16.0, 18.0, 20.0, 22.0, 24.0}) {
    double mean = 0;
    for (int i = 0; i < 360; ++i) {
      const double angle = i * std::numbers::pi / 180;
      mean += rate_at(map, {d * std::cos(angle), d * std::sin(angle)}) / 360;
    }
    EXPECT_NEAR(mean, 100 * 20 / d, 0.01 * 100 * 20 / d) << d;
  }
  // Chords: 720 times 2 · 20 · sin(π/720).
  EXPECT_NEAR(map.figures.total, 10 * 720 * 40 * std::sin(std::numbers::pi / 720) / 100, 1e-8);
}

TEST(Dose, WithoutRateControlSlownessIsMore) {
  // 250 l/ha at 3 m/s; at 2 m/s half as much again.
  DoseSettings settings = settings_at(250);
  settings.rates.nominal_speed_mps = 3;
  const DoseMap map = dose(log(pass({5, 0}, {5, 40}, 0, 2), 10), {}, settings, {});
  EXPECT_NEAR(rate_at(map, {5.5, 20.5}), 375, 1e-6);
  EXPECT_NEAR(map.figures.total, 250.0 / 1e4 * 3 * 20 * 10, 1e-9);  // 20 s
}

TEST(Dose, WhoStandsWithoutRateControlGoesOnSpraying) {
  // 40 s in place in the middle of the pass, 10 m wide, 1 m/s nominal: 40 s · 10 m²/s more, without a heading
  // too.
  for (const bool with_heading : {true, false}) {
    std::vector<Fix> fixes;
    for (int i = 0; i <= 80; ++i) {
      const double y = i <= 20 ? i : i <= 60 ? 20 : i - 40;
      fixes.push_back(with_heading ? fix(i, {5, y}, 0) : fix(i, {5, y}));
    }
    DoseSettings settings = settings_at(100);
    settings.rates.nominal_speed_mps = 1;
    EXPECT_NEAR(dose(log(fixes, 10), {}, settings, {}).figures.total, 80 * 10 / 100.0, 1e-9) << with_heading;
  }
}

TEST(Dose, LoggedRatesWinAndSwitchHalfWay) {
  // 100 up to y = 20, 300 from 21 on: the step between them has the mean.
  std::vector<Fix> fixes = pass({5, 0}, {5, 40});
  for (Fix& f : fixes) f.rate_per_ha = f.position.y <= 20 ? 100 : 300;
  const DoseMap map = dose(log(fixes, 10), {}, settings_at(1), {});
  EXPECT_NEAR(rate_at(map, {5.5, 10.5}), 100, 1e-6);
  EXPECT_NEAR(rate_at(map, {5.5, 20.5}), 200, 1e-6);
  EXPECT_NEAR(rate_at(map, {5.5, 30.5}), 300, 1e-6);
  EXPECT_NEAR(map.logged_amount, 10 * (20 * 100 + 200 + 19 * 300) / 1e4, 1e-9);
  EXPECT_EQ(map.nominal_amount, 0);

  DoseSettings nominal = settings_at(50);
  nominal.rates.use_logged = false;
  EXPECT_NEAR(dose(log(fixes, 10), {}, nominal, {}).figures.total, 2, 1e-9);
}

// Rates are logged over the first 9 m of 30: the ground is all that was covered, whatever got something, and
// so for the figures, the cells and the raster alike.
TEST(Dose, CoveredGroundThatGotNothingIsGroundToo) {
  std::vector<Fix> fixes = pass({0, 0}, {0, 30});
  for (std::size_t i = 0; i < fixes.size(); ++i) fixes[i].rate_per_ha = i < 10 ? 200 : kNan;
  const DoseMap map = dose(log(fixes, 6), {}, settings_at(kNan), {});
  EXPECT_NEAR(map.covered_m2, 180, 1e-6);
  EXPECT_NEAR(map.figures.ground_m2, map.covered_m2, 1e-6);
  EXPECT_NEAR(map.figures.counted_m2, map.covered_m2, 1e-6);
  double ground_m2 = 0, histogram_m2 = 0;
  for (const float share : map.ground) ground_m2 += static_cast<double>(share) * map.grid.cell_area_m2();
  for (const DoseBin& bin : map.figures.histogram) histogram_m2 += bin.area_m2;
  EXPECT_NEAR(ground_m2, map.covered_m2, 1e-3);
  EXPECT_NEAR(histogram_m2, map.covered_m2, 1e-6);
  EXPECT_NEAR(map.figures.mean_per_ha, map.figures.total / map.covered_m2 * 1e4, 1e-6);
  EXPECT_EQ(map.figures.least_per_ha, 0);
}

// Ground that was not recorded got nothing that is known of, and is no worked ground.
TEST(Dose, GroundNotRecordedGetsNothing) {
  std::vector<Fix> fixes = pass({3, 0}, {3, 20});
  for (Fix& late : pass({3, 40}, {3, 60}, 31)) fixes.push_back(late);
  const Region field{{{{0, 0}, {6, 0}, {6, 60}, {0, 60}}, {}}};
  const DoseMap map = dose(log(fixes, 6), field, settings_at(200), {});
  EXPECT_NEAR(map.covered_m2, 240, 1e-6);
  EXPECT_NEAR(map.figures.on_ground, map.figures.total, 1e-9);
  EXPECT_NEAR(map.figures.mean_per_ha, 200.0 * 240 / 360, 1e-6);
}

TEST(Dose, TheFieldCountsWhereNothingWasWorked) {
  // The field is twice as long as the pass: half of it has nothing, the mean is half the rate.
  const Region field{{{{0, 0}, {10, 0}, {10, 80}, {0, 80}}, {}}};
  const DoseMap map = dose(log(pass({5, 0}, {5, 40}), 10), field, settings_at(250), {});
  EXPECT_NEAR(map.figures.mean_per_ha, 125, 1e-3);
  EXPECT_NEAR(map.figures.cv, 1, 1e-6);
  EXPECT_NEAR(map.figures.share_within_10, 0.5, 1e-6);
  EXPECT_NEAR(map.figures.histogram.front().area_m2, 400, 1e-3);
  EXPECT_NEAR(map.figures.ground_m2, 800, 1e-6);
}

TEST(Dose, OfAnEdgeCellOnlyWhatIsOnTheFieldCounts) {
  // The field ends at x = 5.5 in the middle of cells that are all worked: it has its rate to the edge.
  const Region field{{{{0, 0}, {5.5, 0}, {5.5, 40}, {0, 40}}, {}}};
  const DoseMap map = dose(log(pass({5, 0}, {5, 40}), 10), field, settings_at(250), {});
  EXPECT_NEAR(map.figures.on_ground, 5.5 * 40 * 250 / 1e4, 1e-5);
  EXPECT_NEAR(map.figures.cv, 0, 1e-5);
}

TEST(Dose, TheWindMovesAShareDownwind) {
  DoseSettings settings = settings_at(100);
  settings.wind = WindSettings{};
  settings.wind->speed_mps = 3;
  settings.wind->from = Heading::clockwise_from_north(Angle::degrees(270));  // from the west
  settings.wind->share = 0.25;
  settings.wind->height_m = 1;
  settings.wind->fall_mps = 0.25;  // 12 m
  settings.wind->spread = 0.1;
  const DoseMap still = dose(log(pass({5, 0}, {5, 40}), 10), {}, settings_at(100), {});
  const DoseMap map = dose(log(pass({5, 0}, {5, 40}), 10), {}, settings, {});
  EXPECT_NEAR(map.figures.total, still.figures.total, 1e-9);
  EXPECT_NEAR(sum(map.amount), still.figures.total, 1e-9);
  EXPECT_NEAR(rate_at(map, {5.5, 20.5}), 75, 0.1);
  EXPECT_NEAR(rate_at(map, {17.5, 20.5}), 25, 0.1);  // 12 m further: x from 12 to 22
  EXPECT_NEAR(rate_at(map, {-2.5, 20.5}), 0, 1e-6);
  // The middle of all that was applied is a quarter of 12 m further east, and no further north.
  Point middle{};
  for (int row = 0; row < map.grid.rows; ++row)
    for (int column = 0; column < map.grid.columns; ++column)
      middle = middle + (map.amount[map.grid.index(column, row)] / map.figures.total) *
                            (map.grid.low + Point{column + 0.5, row + 0.5});
  EXPECT_NEAR(middle.x, 5 + 3, 1e-3);
  EXPECT_NEAR(middle.y, 20, 1e-3);
}

TEST(Dose, AShiftOfWholeCellsWithoutSpreadIsAMove) {
  const CellGrid grid{{0, 0}, 1, 10, 10};
  std::vector<double> laid(100, 0.0);
  laid[grid.index(2, 7)] = 8;
  DoseDrift drift{1, Heading::clockwise_from_north(Angle::degrees(0)), 0.5, 4, 0};  // to the south
  const std::vector<double> out = drifted(laid, grid, drift);
  EXPECT_NEAR(out[grid.index(2, 3)], 4, 1e-12);
  drift.shift_m = 4.25;
  EXPECT_NEAR(drifted(laid, grid, drift)[grid.index(2, 3)], 3, 1e-12);
  EXPECT_NEAR(drifted(laid, grid, drift)[grid.index(2, 2)], 1, 1e-12);
}

TEST(Dose, OfRegionsTheRateAsOftenAsWorked) {
  EvaluateSettings evaluation;
  const auto passes = both(pass({5, 0}, {5, 40}), pass({11, 0}, {11, 40}, 1000));
  const Coverage coverage = evaluate(log(passes, 10), {}, evaluation, {});
  const DoseMap map = dose(coverage, settings_at(200));
  EXPECT_NEAR(rate_at(map, {3.5, 20.5}), 200, 1e-3);
  EXPECT_NEAR(rate_at(map, {8.5, 20.5}), 400, 1e-3);
  EXPECT_NEAR(map.figures.total, 200 * coverage.areas.gross_m2 / 1e4, 1e-6 * map.figures.total);
}

TEST(Dose, RegionsFillTheCellsTheyTake) {
  // A triangle with a hole, by polygon clipping on a grid of 1e-6 m: of a cell's perimeter at most.
  constexpr double kOracle = 1e-6 * 4 * 0.7;
  const Region region{{{{0.3, 0.2}, {9.1, 1.7}, {3.3, 8.8}}, {{{3, 3}, {4, 5.2}, {5, 3}}}}};
  const CellGrid grid{{-1, -1}, 0.7, 16, 16};
  const std::vector<double> areas = area_in_cells(region, grid);
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      const Point low = grid.low + grid.cell_m * Point{1.0 * column, 1.0 * row};
      const double s = grid.cell_m;
      const Region cell{{{low, low + Point{s, 0}, low + Point{s, s}, low + Point{0, s}}, {}}};
      EXPECT_NEAR(areas[grid.index(column, row)], area(intersection(region, cell)), kOracle);
    }
}

/// What a machine of that pattern lays over a stretch of its width, by many small steps.
double by_steps(const std::function<double(double)>& pattern, double right_m, double left_m) {
  constexpr int kSteps = 2000;
  double sum = 0;
  for (int i = 0; i < kSteps; ++i)
    sum += pattern(right_m + (left_m - right_m) * (i + 0.5) / kSteps) * (left_m - right_m) / kSteps;
  return sum;
}

/// A drive with turns on the spot, standing, reversing and sections that switch.
WorkLog random_drive(std::mt19937_64& random) {
  std::uniform_real_distribution<double> unit(0, 1);
  WorkLog drive = log({}, 12);
  drive.booms = {boom(6, 12)};
  Point at{1000 * unit(random), -1000 * unit(random)};
  double heading = 360 * unit(random), time_s = 0;
  for (int i = 0; i < 150; ++i) {
    const double kind = unit(random);
    heading += kind < 0.05 ? 170 : kind < 0.1 ? 40 : 8 * (unit(random) - 0.5);
    const double way_m = kind > 0.9 ? 0 : kind > 0.8 ? -1 : 3 * unit(random);
    const Heading now = Heading::clockwise_from_north(Angle::degrees(heading));
    at = at + way_m * now.unit();
    time_s += 0.2 + unit(random);
    Fix f = fix(time_s, at, now.degrees());
    if (unit(random) < 0.5) f.rate_per_ha = 300 * unit(random);
    f.has_sections = true;
    for (std::size_t k = 0; k < 6; ++k) f.sections[k] = unit(random) < 0.7;
    drive.fixes.push_back(f);
  }
  return drive;
}

/// The amount by the definition, step by step, for the pattern of NothingIsLostOnAnyDrive.
double amount_by_definition(const WorkLog& drive, const DoseSettings& settings) {
  // Its own integral is 0.75·5 + 0.5 + 3 + 8 = 15.25 over 12 m.
  const auto pattern = [](double s) {
    const double relative = s < -1 ? 0.5 + 0.1 * (s + 6) : s < 0 ? -s : s < 2 ? 1.5 * s : 3 - 0.5 * (s - 2);
    return relative * 12 / 15.25;
  };
  double expected = 0;
  StepMaker steps([&] {
    DriveSettings d = settings.evaluate.drive;
    d.unknown_work = WorkState::kOff;
    return d;
  }());
  for (const Fix& f : drive.fixes) {
    const auto step = steps.add(f, drive.booms);
    if (!step) continue;
    for (const QuadOrigin& origin : step->origins) {
      const double before = step->rate_before_per_ha, after = step->rate_after_per_ha;
      const double share = origin.until - origin.from;
      double rate = origin.from > 0 ? after : origin.until < 1 ? before : 0.5 * (before + after);
      if (std::isnan(rate)) rate = std::isnan(before) ? after : before;
      const double way_m = std::isnan(rate) && !std::isnan(settings.rates.nominal_speed_mps)
                               ? settings.rates.nominal_speed_mps * step->seconds
                               : step->way_m;
      expected += (std::isnan(rate) ? 200 : rate) / 1e4 * way_m * share *
                  by_steps(pattern, origin.section.right_m, origin.section.left_m);
    }
  }
  return expected;
}

TEST(Dose, NothingIsLostOnAnyDrive) {
  for (unsigned seed = 1; seed <= 40; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    const WorkLog drive = random_drive(random);
    DoseSettings settings = settings_at(200, 0.3 + unit(random));
    settings.pattern = {{-6, 0.5}, {-1, 1}, {0, 0}, {2, 3}, {6, 1}};
    if (seed % 3 == 0) settings.rates.nominal_speed_mps = 1.5;
    const double expected = amount_by_definition(drive, settings);
    for (const bool windy : {false, true}) {
      if (windy)
        settings.wind =
            WindSettings{4, Heading::clockwise_from_north(Angle::degrees(360 * unit(random))), 0.3};
      const DoseMap map = dose(drive, {}, settings, {});
      EXPECT_NEAR(sum(map.amount), expected, 1e-6 * expected);
      EXPECT_NEAR(map.logged_amount + map.nominal_amount, sum(map.amount), 1e-9 * expected);
      for (const double amount : map.amount) ASSERT_GE(amount, 0);
    }
  }
}

TEST(Dose, TheSameOnAnyNumberOfThreads) {
  DoseSettings settings = settings_at(200, 0.5);
  settings.wind = WindSettings{5, Heading::clockwise_from_north(Angle::degrees(77)), 0.1};
  const WorkLog drive = log(both(pass({5, 0}, {40, 47}), pass({11, 0}, {11, 40}, 1000)), 10);
  settings.evaluate.threads = 1;
  const DoseMap one = dose(drive, {}, settings, {});
  settings.evaluate.threads = 4;
  const DoseMap four = dose(drive, {}, settings, {});
  EXPECT_EQ(one.amount, four.amount);
  EXPECT_EQ(one.figures.cv, four.figures.cv);
}

TEST(Dose, RefusesWhatItCannotKnow) {
  const WorkLog drive = log(pass({5, 0}, {5, 40}), 10);
  EXPECT_TRUE(mentions(refusal_of([&] { dose(drive, {}, settings_at(kNan), {}); }), "--nominal-rate"));
  const auto with_pattern = [&](SprayPattern pattern) {
    DoseSettings settings = settings_at(100);
    settings.pattern = std::move(pattern);
    settings.pattern_place = "pattern 'p.csv'";
    return refusal_of([&] { dose(drive, {}, settings, {}); });
  };
  EXPECT_TRUE(mentions(with_pattern({{0, 1}}), "two"));
  EXPECT_TRUE(mentions(with_pattern({{-1, 1}, {1, -1}}), "0 or more"));
  EXPECT_TRUE(mentions(with_pattern({{-1, 1}, {1, kNan}}), "p.csv"));
  EXPECT_TRUE(mentions(with_pattern({{-1, 1}, {1, 1}, {0, 1}}), "one side to the other"));
  EXPECT_TRUE(mentions(with_pattern({{-1, 0}, {1, 0}}), "nothing lands"));
  EXPECT_TRUE(mentions(with_pattern({{-1, 1e-320}, {1, 1e-320}}), "nothing lands"));
  EXPECT_TRUE(mentions(with_pattern({{0, 1}, {5e-324, 1}}), "nothing lands"));
  const std::string cells = refusal_of([&] { dose(drive, {}, settings_at(100, 0.001), {}); });
  EXPECT_TRUE(mentions(cells, "--cell")) << cells;
  WorkLog timeless = drive;
  timeless.clock = Clock::kNone;
  DoseSettings slow = settings_at(100);
  slow.rates.nominal_speed_mps = 2;
  EXPECT_TRUE(mentions(refusal_of([&] { dose(timeless, {}, slow, {}); }), "no times"));
}

}  // namespace
}  // namespace tramline::coverage
