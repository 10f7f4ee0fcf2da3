#include "tramline/io/log/section_text.h"

#include <gtest/gtest.h>

#include <string>

namespace tramline::io {
namespace {

TEST(SectionText, Signs) {
  const auto left = section_signs("110-", SectionOrder::kFromLeft);
  ASSERT_TRUE(left);
  EXPECT_EQ(left->count, 4U);
  EXPECT_TRUE(left->known);
  EXPECT_EQ(left->states, SectionStates("0011"));
  EXPECT_EQ(section_signs("110-", SectionOrder::kFromRight)->states, SectionStates("1100"));
  EXPECT_FALSE(section_signs("----", SectionOrder::kFromLeft)->known);
  EXPECT_FALSE(section_signs("12", SectionOrder::kFromLeft));
  EXPECT_FALSE(section_signs("", SectionOrder::kFromLeft));
  EXPECT_TRUE(section_signs(std::string(256, '1'), SectionOrder::kFromLeft));
  EXPECT_FALSE(section_signs(std::string(257, '1'), SectionOrder::kFromLeft));
}

// DDI 161: bits 1 and 0 are section 1, bits 3 and 2 section 2 …
TEST(SectionText, CondensedNumbers) {
  // Sections 1 and 3 on, 2 off, 4 in error, 5 to 16 not installed: 0b11…11'10'01'00'01.
  const std::uint32_t bits = 0xFFFFFF91;
  for (const std::string& text :
       {std::string("0xFFFFFF91"), std::string("ffffff91"), std::to_string(bits),
        std::to_string(static_cast<std::int32_t>(bits)), std::string("1012333333333333")}) {
    const auto sections = condensed_sections(text);
    ASSERT_TRUE(sections) << text;
    EXPECT_EQ(sections->count, 4U) << text;
    EXPECT_EQ(sections->states, SectionStates("0101")) << text;
  }
}

TEST(SectionText, WhatIsNotInstalledMayBeWrittenAsOff) {
  const auto sections = condensed_sections("1111100000000000");
  ASSERT_TRUE(sections);
  EXPECT_EQ(sections->count, 0U);
  EXPECT_EQ(sections->states, SectionStates("11111"));
  EXPECT_EQ(condensed_sections("341")->states, SectionStates("11111"));  // 1 + 4 + 16 + 64 + 256
}

TEST(SectionText, NoNumbers) {
  for (const char* wrong : {"", "0x", "xyz", "4294967296", "-", "-9999999999", "1 2"})
    EXPECT_FALSE(condensed_sections(wrong)) << wrong;
}

}  // namespace
}  // namespace tramline::io
