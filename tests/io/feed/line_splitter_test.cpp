#include "tramline/io/feed/line_splitter.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "tramline/io/fixes/lines.h"

namespace tramline::io {
namespace {

// Cut anywhere, bytes give the same lines.
TEST(LineSplitter, WhereverTheBytesAreCut) {
  const std::string text = "a\r\n\nlong line\nb,c\nrest";
  for (std::size_t cut = 0; cut <= text.size(); ++cut) {
    LineSplitter splitter;
    std::vector<std::string> lines;
    splitter.add(text.substr(0, cut), lines);
    splitter.add(text.substr(cut), lines);
    EXPECT_EQ(lines, (std::vector<std::string>{"a\r", "", "long line", "b,c"})) << cut;
    EXPECT_EQ(splitter.take_rest(), "rest");
    EXPECT_FALSE(splitter.has_rest());
  }
}

TEST(LineSplitter, ALineWithoutEndIsLeftOut) {
  LineSplitter splitter;
  std::vector<std::string> lines;
  for (std::size_t i = 0; i < 3 * kLongestLine; i += 1000) splitter.add(std::string(1000, 'x'), lines);
  EXPECT_FALSE(splitter.has_rest()) << "memory does not grow";
  splitter.add("x\nnext\n", lines);
  EXPECT_EQ(lines, std::vector<std::string>{"next"});
}

}  // namespace
}  // namespace tramline::io
