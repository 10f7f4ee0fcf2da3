// Fields of some 35 national registers: each is admitted or refused with a reason, and its area is the one
// that was computed for it by other software.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "tramline/admission/admit.h"
#include "tramline/geometry/error.h"
#include "tramline/geometry/polygon/boolean.h"
#include "tramline/io/vector/read_vector.h"

namespace tramline {
namespace {

std::filesystem::path data_folder() {
  const char* named = std::getenv("TRAMLINE_DATA");
  if (named != nullptr && *named != '\0') return named;
  return std::filesystem::path(TRAMLINE_SOURCE_DIR).parent_path() / "shared" / "data";
}

class RealFields : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(data_folder() / "fields"))
      GTEST_SKIP() << "there are no real fields in " << data_folder()
                   << "; set TRAMLINE_DATA to their folder";
  }
};

struct Outcome {
  std::vector<Field> fields;
  std::string refusal;
};

/// What became of each feature, in file order.
std::vector<Outcome> admit_file(const std::string& name) {
  io::VectorQuery query;
  query.file = (data_folder() / name).string();
  const RawDataset dataset = io::read_vector(query);
  const RawLayer& layer = dataset.layers.front();
  const Crs crs(layer.crs);
  std::vector<Outcome> out;
  for (const RawFeature& feature : layer.features) {
    Outcome outcome;
    try {
      outcome.fields = admit(feature, {name, layer.name, &crs, dataset.winding}).fields;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::kBadInput) << error.what();
      outcome.refusal = error.what();
      EXPECT_NE(outcome.refusal.find(name + ", feature '"), std::string::npos) << outcome.refusal;
    }
    out.push_back(std::move(outcome));
  }
  return out;
}

double workable_m2(const Outcome& outcome) {
  double sum = 0;
  for (const Field& field : outcome.fields) {
    sum += signed_area(field.outer);
    for (const Obstacle& obstacle : field.obstacles) sum -= area(obstacle.shape);
  }
  return sum;
}

void expect_sound(const Outcome& outcome) {
  for (const Field& field : outcome.fields) {
    EXPECT_GT(signed_area(field.outer), 0) << field.id;
    EXPECT_FALSE(find_invalidity({field.outer, {}})) << field.id;
    const Region inside = {{field.outer, {}}};
    for (std::size_t i = 0; i < field.obstacles.size(); ++i) {
      const Region shape = {field.obstacles[i].shape};
      EXPECT_FALSE(find_invalidity(shape[0])) << field.id;
      EXPECT_LE(area(difference(shape, inside)), 1e-3) << field.id << " " << field.obstacles[i].origin;
      for (std::size_t j = 0; j < i; ++j) {
        if (!intersects(bounds(shape), bounds(field.obstacles[j].shape))) continue;
        EXPECT_LE(area(intersection(shape, {field.obstacles[j].shape})), 1e-3) << field.id;
      }
    }
  }
}

void expect_as_published(const std::string& name, std::size_t features) {
  std::ifstream in(data_folder() / name);
  const auto collection = nlohmann::json::parse(in);
  const std::vector<Outcome> outcomes = admit_file(name);
  ASSERT_EQ(outcomes.size(), features);
  ASSERT_EQ(collection["features"].size(), features);
  std::size_t refused = 0, compared = 0;
  for (std::size_t i = 0; i < features; ++i) {
    const auto& properties = collection["features"][i]["properties"];
    const std::string id = properties["id"];
    if (outcomes[i].fields.empty()) {
      ++refused;
      EXPECT_FALSE(outcomes[i].refusal.empty()) << id;
      EXPECT_FALSE(properties["valid"].get<bool>()) << id << ": " << outcomes[i].refusal;
      continue;
    }
    expect_sound(outcomes[i]);
    EXPECT_EQ(outcomes[i].fields[0].id, id);
    if (!properties["valid"].get<bool>()) continue;
    const double published_m2 = properties["area_m2"];
    // The published area has one decimal.
    EXPECT_NEAR(workable_m2(outcomes[i]), published_m2, 1e-3 * published_m2 + 0.05) << id;
    ++compared;
  }
  std::printf("%s: %zu features, %zu compared, %zu refused\n", name.c_str(), features, compared, refused);
  // All but five are valid; the valid ones must not have gone to the refused.
  EXPECT_EQ(compared, features - 5);
}

TEST_F(RealFields, TheCuratedOnesAreAdmittedWithTheirPublishedAreas) {
  expect_as_published("fields/fields.geojson", 301);
}

TEST_F(RealFields, AllOfThemAreAdmittedWithTheirPublishedAreas) {
  expect_as_published("fields/fields-all.geojson", 1718);
}

struct Register {
  const char* file;
  double min_lon, max_lon, min_lat, max_lat;
};

class RealRegisters : public RealFields, public testing::WithParamInterface<Register> {};

TEST_P(RealRegisters, AreReadWhereTheyLie) {
  const Register& parameters = GetParam();
  const std::vector<Outcome> outcomes = admit_file(std::string("registers/") + parameters.file);
  EXPECT_EQ(outcomes.size(), 100u);
  for (const Outcome& outcome : outcomes) {
    EXPECT_EQ(outcome.refusal, "");
    expect_sound(outcome);
    for (const Field& field : outcome.fields) {
      EXPECT_GT(field.frame.origin_lon_deg, parameters.min_lon) << field.id;
      EXPECT_LT(field.frame.origin_lon_deg, parameters.max_lon) << field.id;
      EXPECT_GT(field.frame.origin_lat_deg, parameters.min_lat) << field.id;
      EXPECT_LT(field.frame.origin_lat_deg, parameters.max_lat) << field.id;
    }
  }
}

// The countries' bounding boxes.
INSTANTIATE_TEST_SUITE_P(Each, RealRegisters,
                         testing::Values(Register{"nl-brp-2023.gpkg", 3.3, 7.3, 50.7, 53.6},
                                         Register{"dk-marker.zip", 8.0, 15.3, 54.5, 57.9},
                                         Register{"de-sh-feldbloecke.zip", 7.8, 11.4, 53.3, 55.1}),
                         [](const auto& test) { return std::string(test.param.file).substr(0, 2); });

// The curated set holds fields of the same extract, published with the areas of the original coordinates.
TEST_F(RealFields, TheDutchRegisterAgreesWithItsCopyInDegrees) {
  std::map<long, double> copies;
  const std::vector<Outcome> in_degrees = admit_file("fields/fields-all.geojson");
  for (const Outcome& outcome : in_degrees)
    if (!outcome.fields.empty() && outcome.fields[0].id.rfind("nl-brp/", 0) == 0)
      copies[std::stol(outcome.fields[0].id.substr(7))] = workable_m2(outcome);
  ASSERT_GE(copies.size(), 50u);
  const std::vector<Outcome> original = admit_file("registers/nl-brp-2023.gpkg");
  for (const auto& [number, area_m2] : copies) {
    // The copy numbers features as the GeoPackage does.
    const auto found =
        std::find_if(original.begin(), original.end(), [number = number](const Outcome& outcome) {
          return !outcome.fields.empty() && outcome.fields[0].source.fid == number;
        });
    ASSERT_NE(found, original.end()) << number;
    // Coordinates of the copy are rounded to 1e-9 degrees, 0.1 mm.
    EXPECT_NEAR(workable_m2(*found), area_m2, 1e-4 * perimeter(found->fields[0].outer) + 1e-3) << number;
  }
}

}  // namespace
}  // namespace tramline
