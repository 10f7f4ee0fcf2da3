#include "server/http/page_words.h"

#include <gtest/gtest.h>

#include <regex>

namespace tramline::server {
namespace {

TEST(PageWords, OptionsBecomeWords) {
  EXPECT_EQ(in_page_words("--strategy takes best or sweep, not 'x'"),
            "the strategy takes best or sweep, not 'x'");
  EXPECT_EQ(in_page_words("no ground to work; use a smaller --clearance"),
            "no ground to work; use a smaller clearance");
  EXPECT_EQ(in_page_words(
                "a narrower machine, a smaller --min-length, a smaller --clearance or another --end-rule"),
            "a narrower machine, shorter pieces, a smaller clearance or another end rule");
  EXPECT_EQ(in_page_words("a smaller --min-length or --boundary soft, by which swaths may run past the edge"),
            "shorter pieces or a field that the machine can leave");
  EXPECT_EQ(in_page_words("none; give --obstacle-headlands"),
            "none; give the number of passes round obstacles");
  EXPECT_EQ(in_page_words("it names --obstacle-headlands"), "it names the number of passes round obstacles");
  EXPECT_EQ(
      in_page_words("--avoid-room belongs to --avoid paper: give that too, or leave it out"),
      "the room for detours belongs to the rule of Versleijen at obstacles: choose that, or leave it out");
}

TEST(PageWords, SaysWhatToDoOnThePage) {
  EXPECT_EQ(in_page_words("the plan has tracks and no route; plan it again with --route"),
            "the plan has tracks and no route; plan the whole job");
  EXPECT_EQ(in_page_words("a DJI mission needs the altitude of the drone; name a machine file with "
                          "flight_altitude_m with --machine"),
            "a DJI mission needs the altitude of the drone; say how high it flies");
}

TEST(PageWords, WarningsOfASummaryAreTakenAlong) {
  const nlohmann::ordered_json said = summary_in_page_words(nlohmann::ordered_json{
      {"turns", 3},
      {"warnings", {"3 fixes do not say how wide the machine is: nothing is worked there without --width"}}});
  EXPECT_EQ(said["turns"], 3);
  EXPECT_EQ(said["warnings"][0],
            "3 fixes do not say how wide the machine is: nothing is worked there unless you give the working "
            "width");
  EXPECT_EQ(summary_in_page_words(nlohmann::ordered_json{{"turns", 3}})["turns"], 3);
}

TEST(PageWords, AnOptionWithinALongerOneIsLeftAlone) {
  EXPECT_EQ(in_page_words("--widths"), "--widths");
  EXPECT_EQ(in_page_words("--avoid-it"), "--avoid-it");
  EXPECT_EQ(in_page_words("nothing -- here"), "nothing -- here");
}

}  // namespace
}  // namespace tramline::server
