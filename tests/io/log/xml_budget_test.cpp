// What a tree of XML takes, told from its text.

#include "tramline/io/fixes/xml_budget.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <pugixml.hpp>
#include <string>

#include "support/refusals.h"

namespace tramline::io {
namespace {

TEST(XmlBudget, CountsElementsTextsAndAttributes) {
  constexpr std::size_t kNode = 64, kAttribute = 40;
  const auto tree = [](const std::string& xml) { return xml_tree_bytes(xml) - xml.size(); };
  EXPECT_EQ(tree(""), 0U);
  EXPECT_EQ(tree("<a/>"), kNode);
  EXPECT_EQ(tree("<a></a>"), kNode);
  EXPECT_EQ(tree("<a> \n </a>"), kNode);
  EXPECT_EQ(tree("<a> x </a>"), 2 * kNode);
  EXPECT_EQ(tree("<a>x <b/> y</a>"), 4 * kNode);
  EXPECT_EQ(tree("<a b='1' c=\"2\"/>"), kNode + 2 * kAttribute);
}

std::size_t bytes_taken = 0;  // by the parser

/// Never less than the parser asks for, but for a page.
TEST(XmlBudget, IsWhatTheParserTakesOrMore) {
  const auto before_take = pugi::get_memory_allocation_function();
  const auto before_free = pugi::get_memory_deallocation_function();
  std::string many, points, mixed;
  for (int i = 0; i < 20'000; ++i) {
    many += "<a/>";
    points += "<trkpt lat='54' lon='9'><ele>1</ele><time>2020-01-01T00:00:00Z</time></trkpt>\n";
    mixed += "x<b/>";
  }
  pugi::set_memory_management_functions(
      [](size_t size) {
        bytes_taken += size;
        return std::malloc(size);
      },
      std::free);
  for (const std::string& inner : {many, points, mixed}) {
    const std::string xml = "<gpx>" + inner + "</gpx>";
    bytes_taken = 0;
    {
      pugi::xml_document document;
      ASSERT_TRUE(document.load_buffer(xml.data(), xml.size()));
    }
    constexpr std::size_t kPage = 33'000;
    EXPECT_LE(bytes_taken, xml_tree_bytes(xml) + kPage);
    EXPECT_GE(bytes_taken, xml_tree_bytes(xml) * 9 / 10);
  }
  pugi::set_memory_management_functions(before_take, before_free);
}

TEST(XmlBudget, BeyondItThereIsASentence) {
  const std::string xml = "<a><b/></a>";  // two elements
  EXPECT_NO_THROW(require_bounded_xml(xml, "'f.gpx'", 128 + xml.size()));
  EXPECT_EQ(testing_support::refusal_of([&] { require_bounded_xml(xml, "'f.gpx'", 127 + xml.size()); }),
            "'f.gpx' has so many elements that reading it takes more than 0 MiB of memory; split it");
}

}  // namespace
}  // namespace tramline::io
