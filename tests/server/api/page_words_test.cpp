#include "server/http/page_words.h"

#include <gtest/gtest.h>

#include <regex>

namespace tramline::server {
namespace {

TEST(PageWords, OptionsBecomeWords) {
  EXPECT_EQ(in_page_words("--strategy takes best or sweep, not 'x'"),
            "the strategy takes best or sweep, not 'x'");
  EXPECT_EQ(in_page_words("use a smaller --clearance or --min-length"),
            "use a smaller the clearance or the shortest piece");
  EXPECT_EQ(in_page_words("it names --obstacle-headlands"), "it names the number of passes round obstacles");
}

TEST(PageWords, AnOptionWithinALongerOneIsLeftAlone) {
  EXPECT_EQ(in_page_words("--widths"), "--widths");
  EXPECT_EQ(in_page_words("--avoid-it"), "--avoid-it");
  EXPECT_EQ(in_page_words("nothing -- here"), "nothing -- here");
}

}  // namespace
}  // namespace tramline::server
