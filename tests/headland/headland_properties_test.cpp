// What holds for headlands of random fields. TRAMLINE_CASES and TRAMLINE_SEED as for the other properties.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "headland/headland_faults.h"
#include "properties/random_field.h"
#include "properties/random_scene.h"
#include "tramline/geometry/error.h"

namespace tramline::testing {
namespace {

HeadlandTerms random_terms(std::mt19937_64& random, const Field& field, double width_m) {
  const auto whole = [&](int from, int to) { return std::uniform_int_distribution<int>(from, to)(random); };
  HeadlandTerms terms{width_m,
                      whole(0, 3) == 0 ? 0.0 : std::uniform_real_distribution<double>(0, 15)(random),
                      whole(0, 3),
                      {}};
  if (whole(0, 1) == 0) return terms_of(field, width_m, terms.radius_m, whole(1, 3));
  for (std::size_t i = 0; i < field.obstacles.size(); ++i) terms.obstacle_passes.push_back(whole(0, 3));
  return terms;
}

void expect_no_faults(const Field& field, const HeadlandTerms& terms, unsigned long long seed) {
  try {
    for (const std::string& fault : faults_of(field, terms, headland_of(field, terms)))
      ADD_FAILURE() << fault << ", TRAMLINE_SEED=" << seed;
  } catch (const Error& error) {
    ADD_FAILURE() << error.what() << ", TRAMLINE_SEED=" << seed;
  }
}

TEST(HeadlandProperties, HoldForRandomFields) {
  for (int i = 0; i < case_count(100); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    const Field field = random_field(random, 8);
    const double width = std::uniform_real_distribution<double>(1, 12)(random);
    expect_no_faults(field, random_terms(random, field, width), seed);
  }
}

TEST(HeadlandProperties, HoldForScenesFullOfObstacles) {
  for (int i = 0; i < case_count(100); ++i) {
    const unsigned long long seed = base_seed() + static_cast<unsigned long long>(i);
    std::mt19937_64 random(seed);
    Scene scene;
    try {
      scene = random_scene(random);
    } catch (const Error&) {
      continue;  // obstacles all over the field
    }
    expect_no_faults(scene.field, random_terms(random, scene.field, scene.machine.width_m), seed);
  }
}

}  // namespace
}  // namespace tramline::testing
