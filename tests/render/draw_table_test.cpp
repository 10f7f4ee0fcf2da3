// Tables on pages of A4.

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>

#include "tramline/geometry/error.h"
#include "tramline/render/plan/draw_plan.h"

namespace tramline::render {
namespace {

std::string drawn(std::size_t rows) {
  Table table{"title", "subtitle", {"field", "machine", "ha"}, {}, {{"all", "drill", "9.00"}}};
  for (std::size_t i = 0; i < rows; ++i)
    table.rows.push_back({"field " + std::to_string(i), "drill", "1.00"});
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("tramline-table-" + std::to_string(::getpid()) + ".pdf");
  draw_table(table, path);
  std::ifstream file(path, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(file), {});
  std::filesystem::remove(path);
  return bytes;
}

int pages_of(const std::string& pdf) {
  std::smatch found;
  return std::regex_search(pdf, found, std::regex(R"(/Count (\d+))")) ? std::stoi(found[1]) : 0;
}

// A page of 1684 px less margins of 70 holds about 43 rows of 34 px below the headings.
TEST(DrawTable, TakesAsManyPagesAsItNeeds) {
  EXPECT_EQ(pages_of(drawn(1)), 1);
  EXPECT_EQ(pages_of(drawn(40)), 1);
  EXPECT_EQ(pages_of(drawn(60)), 2);
  EXPECT_EQ(pages_of(drawn(110)), 3);
}

TEST(DrawTable, TheSameTableGivesTheSameBytes) {
  EXPECT_EQ(drawn(60), drawn(60));
  EXPECT_NE(drawn(60), drawn(61));
}

TEST(DrawTable, RefusesOtherFilesAndTablesWithoutColumns) {
  EXPECT_THROW(draw_table({"t", "s", {"a"}, {}, {}}, "table.png"), Error);
  EXPECT_THROW(draw_table({"t", "s", {}, {}, {}}, "table.pdf"), Error);
}

}  // namespace
}  // namespace tramline::render
