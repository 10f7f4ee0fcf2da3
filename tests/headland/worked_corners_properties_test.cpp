// What holds for corners of random fields that are worked out.

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <string>
#include <vector>

#include "headland/headland_faults.h"
#include "properties/random_field.h"
#include "properties/random_scene.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/headland/corners/worked_corners.h"
#include "tramline/headland/pass_ground.h"
#include "tramline/headland/path_stretch.h"

namespace tramline::testing {
namespace {

double spent(const Headland& headland, const CornerPrices& prices) {
  return prices.missed_per_m2 * headland.uncovered_m2 + prices.doubled_per_m2 * headland.overlap_m2;
}

std::vector<int> passes_by_edge(std::mt19937_64& random, std::size_t edges) {
  std::vector<int> out(edges);
  for (int& passes : out) passes = std::uniform_int_distribution<int>(0, 2)(random);
  return out;
}

/// The land that passes work, by polygons.
Region worked_by(const Headland& headland, double width_m) {
  Region out;
  for (const HeadlandPass& pass : headland.passes)
    for (const Polygon& part : pass_ground_parts(pass.path, width_m, kLayerSagitta)) out.push_back(part);
  return unite(out);
}

/// Closed passes as they lie, the other way round, or from where a route might enter them, either way.
std::vector<Round> random_rounds(std::mt19937_64& random, const Headland& headland) {
  std::vector<Round> out;
  for (const HeadlandPass& pass : headland.passes) {
    const int kind = std::uniform_int_distribution<int>(0, 3)(random);
    const double length_m = length(pass.path);
    const double begin_m = std::uniform_real_distribution<double>(0, length_m)(random);
    out.emplace_back();
    if (!is_closed(pass) || kind == 0) continue;
    out.back().entered = kind > 1;
    out.back().path = kind > 1 ? stretch_of(pass.path, begin_m, begin_m + length_m) : pass.path;
    if (kind < 3) out.back().path = reversed(out.back().path);
  }
  return out;
}

TEST(WorkedCornersProperties, SaveWhatTheySay) {
  int worked_out = 0;
  for (int i = 0; i < case_count(30); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    SCOPED_TRACE("TRAMLINE_SEED=" + std::to_string(seed));
    std::mt19937_64 random(seed);
    const auto real = [&](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    const Field field = random_field(random, 4);
    const double width_m = real(2, 12);
    HeadlandTerms terms = terms_of(field, width_m, real(1, 12), 1 + i % 3);
    if (i % 4 == 3) terms.edge_passes = passes_by_edge(random, field.outer.size());
    const CornerPrices prices{10, real(0.5, 2), real(0, 1), real(0, 200)};
    const HeadlandAndBody before = headland_of(field, terms);
    const WorkedCorners after =
        with_worked_corners(field, terms, before, prices, random_rounds(random, before));
    for (const std::string& fault : faults_of(field, terms, {after.headland, before.body}))
      ADD_FAILURE() << fault;
    EXPECT_GE(after.saved, 0);
    // What short open passes save that are left out; a corner that is dropped for another may have been
    // counted on there.
    double slack = 1e-6 + 0.02 * spent(before, prices);
    for (const HeadlandPass& pass : before.passes)
      if (!is_closed(pass)) slack += prices.per_stop + prices.in_and_out_per_m * length(pass.path);
    EXPECT_LE(spent(after.headland, prices), spent(before, prices) - after.saved + slack);
    if (after.saved == 0) continue;
    ++worked_out;
    const Region lost = difference(intersection(worked_by(before, width_m), before.ground),
                                   worked_by(after.headland, width_m));
    EXPECT_LT(area(lost), 0.01 * area(before.ground)) << "arcs that are not worth it";
  }
  EXPECT_GT(3 * worked_out, case_count(30)) << "or else nothing is tested";
}

}  // namespace
}  // namespace tramline::testing
