// Which values of JSON are too large to be kept whole.

#include "tramline/io/vector/json_size.h"

#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tramline::io {
namespace {

/// With at most 100 bytes for a value.
bool large(const std::string& json) {
  std::istringstream text(json);
  const auto read = [&text, &json] {
    const auto at = text.tellg();
    return at < 0 ? json.size() : static_cast<std::size_t>(at);
  };
  return has_large_json_value(text, read, json.size(), 100);
}

const std::string kLong = "[" + std::string(200, ' ') + "1]";

TEST(JsonSize, OnlyCollectionsMayBeLarge) {
  EXPECT_FALSE(large(R"({"type":"FeatureCollection","features":)" + kLong + "}"));
  EXPECT_FALSE(large(R"({"features":)" + kLong + R"(,"type":"FeatureCollection"})"));
  EXPECT_TRUE(large(R"({"type":"Polygon","coordinates":)" + kLong + "}"));
  EXPECT_TRUE(large(R"({"arcs":)" + kLong + "}"));
  EXPECT_TRUE(large(kLong));
  EXPECT_FALSE(large(R"({"type":"Polygon","coordinates":[]})"));
}

TEST(JsonSize, TheTypeIsThatOfTheValueItself) {
  EXPECT_TRUE(large(R"({"type":"Feature","properties":{"type":"FeatureCollection"},"a":)" + kLong + "}"));
  EXPECT_TRUE(large(R"({"x":"FeatureCollection","type":"Polygon","a":)" + kLong + "}"));
  EXPECT_TRUE(large(R"({"type":["FeatureCollection"],"a":)" + kLong + "}"));
  // GDAL goes by the last of two.
  EXPECT_TRUE(large(R"({"type":"FeatureCollection","features":[],"type":"Polygon","a":)" + kLong + "}"));
}

TEST(JsonSize, EachValueOfASequenceCountsForItself) {
  const std::string small = R"({"type":"Feature","properties":{},"geometry":null})";
  std::string lines;
  for (int i = 0; i < 20; ++i) lines += small + "\n";
  EXPECT_FALSE(large(lines));
  EXPECT_FALSE(large("\x1e" + small + "\n\x1e" + small));
  EXPECT_TRUE(large(lines + R"({"type":"Feature","properties":)" + kLong + "}"));
}

TEST(JsonSize, WhatFollowsOnAFaultCountsToTheValue) {
  EXPECT_TRUE(large(R"({"type":"Polygon","coordinates":[NaN, )" + kLong));
  EXPECT_FALSE(large(R"({"type":"FeatureCollection","features":[NaN, )" + kLong));
  EXPECT_FALSE(large("{]"));
}

}  // namespace
}  // namespace tramline::io
