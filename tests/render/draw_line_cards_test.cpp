// Line cards: a page a field, more where there is more to say.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include "support/small_plan.h"
#include "tramline/geometry/error.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

LineCard card(std::size_t rows) {
  LineCard out{testing_support::small_plan(), {{"AB 1", {0, 1.5}, {100, 1.5}, {"A", "B"}}}, {}};
  for (std::size_t i = 0; i < rows; ++i) out.rows.push_back("row " + std::to_string(i));
  return out;
}

std::string drawn(std::size_t cards, std::size_t rows) {
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("tramline-card-" + std::to_string(::getpid()) + ".pdf");
  draw_line_cards(
      cards, [&](std::size_t) { return card(rows); }, path);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  std::filesystem::remove(path);
  return bytes;
}

int pages_in(const std::string& pdf) {
  std::smatch found;
  return std::regex_search(pdf, found, std::regex(R"(/Count (\d+))")) ? std::stoi(found[1]) : 0;
}

// A page of 1684 px has room for some 40 rows of 30 px below a flat map.
TEST(DrawLineCards, APageAFieldAndMoreWhereItIsFull) {
  EXPECT_EQ(pages_in(drawn(1, 3)), 1);
  EXPECT_EQ(pages_in(drawn(4, 3)), 4);
  EXPECT_EQ(pages_in(drawn(2, 60)), 4);
}

TEST(DrawLineCards, LongRowsAreBrokenBetweenWords) {
  const auto pages = [](const std::string& text) {
    const std::filesystem::path path =
        std::filesystem::temp_directory_path() / ("tramline-card-" + std::to_string(::getpid()) + ".pdf");
    draw_line_cards(
        1,
        [&](std::size_t) {
          LineCard out = card(0);
          out.rows = {text};
          return out;
        },
        path);
    std::ifstream file(path, std::ios::binary);
    const std::string bytes(std::istreambuf_iterator<char>(file), {});
    std::filesystem::remove(path);
    return pages_in(bytes);
  };
  std::string many;
  for (int i = 0; i < 2000; ++i) many += "word ";
  EXPECT_GT(pages(many), 1);
  EXPECT_EQ(pages(std::string(20000, 'x')), 1) << "one word is cut";
}

TEST(DrawLineCards, TheSameCardsGiveTheSameBytes) {
  EXPECT_EQ(drawn(2, 3), drawn(2, 3));
  EXPECT_NE(drawn(2, 3), drawn(2, 4));
}

TEST(DrawLineCards, RefusesOtherFilesAndNoCards) {
  const auto one = [](std::size_t) { return card(1); };
  EXPECT_THROW(draw_line_cards(1, one, "card.png"), Error);
  EXPECT_THROW(draw_line_cards(0, one, "card.pdf"), Error);
}

}  // namespace
}  // namespace tramline::render
