// Bars over the values of many fields.

#include "tramline/render/histogram/draw_histogram.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "tramline/geometry/error.h"

namespace tramline::render {
namespace {

std::string drawn(std::vector<double> values) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("tramline-histogram-" + std::to_string(::getpid()) + ".svg");
  draw_histogram({"title", "subtitle", "euros per hectare", std::move(values)}, path);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  std::filesystem::remove(path);
  return bytes;
}

struct Bar {
  double left_px = 0, height_px = 0;
};

/// The filled boxes of an SVG that stand on the axis, from left to right. Empty bars are not drawn.
std::vector<Bar> bars_of(const std::string& svg) {
  static const std::regex box(
      R"re(d="M ([\d.]+) ([\d.]+) L ([\d.]+) ([\d.]+) L ([\d.]+) ([\d.]+) L ([\d.]+) ([\d.]+) Z)re");
  std::vector<Bar> out;
  for (std::sregex_iterator at(svg.begin(), svg.end(), box), end; at != end; ++at) {
    const double y[] = {std::stod((*at)[2]), std::stod((*at)[4]), std::stod((*at)[6]), std::stod((*at)[8])};
    const auto [least, most] = std::minmax_element(std::begin(y), std::end(y));
    if (std::abs(*most - 620) < 0.5) out.push_back({std::stod((*at)[1]), *most - *least});
  }
  return out;
}

// The 99th percentile of the five is 2, a thirtieth of it 0.07: bars of 0.1, of which the 21st, from 2 on,
// holds 50 too. 0, 1 and 2 begin the 1st, the 11th and the 21st.
TEST(Histogram, CountsValuesInBarsOfARoundStep) {
  const std::string svg = drawn({0, 1, 1, 2, 50});
  const std::vector<Bar> bars = bars_of(svg);
  ASSERT_EQ(bars.size(), 3U);
  const double one = bars[0].height_px, ten = bars[1].left_px - bars[0].left_px;
  EXPECT_GT(one, 100);
  EXPECT_NEAR(bars[1].height_px, 2 * one, 0.1);
  EXPECT_NEAR(bars[2].height_px, 2 * one, 0.1);
  EXPECT_NEAR(bars[2].left_px - bars[1].left_px, ten, 0.1);
  EXPECT_NEAR(ten, 10.0 / 21 * (1150 - 90), 0.1);
}

TEST(Histogram, WithoutValuesHasNoBar) { EXPECT_TRUE(bars_of(drawn({})).empty()); }

TEST(Histogram, OtherFilesAreRefused) {
  EXPECT_THROW(draw_histogram({"title", "", "m", {1}}, "histogram.txt"), Error);
}

}  // namespace
}  // namespace tramline::render
