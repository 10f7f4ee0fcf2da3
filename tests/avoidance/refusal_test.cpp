// Reasons in words, as docs/obstacles.md lists them for those who read plan files.

#include "tramline/avoidance/refusal.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <set>
#include <string>

namespace tramline {
namespace {

constexpr Refusal kReasons[] = {Refusal::kNoRoomBetween,
                                Refusal::kNotBlocked,
                                Refusal::kNoWayBack,
                                Refusal::kNoSide,
                                Refusal::kEndsBefore,
                                Refusal::kLeavesField,
                                Refusal::kPassesHardBoundary,
                                Refusal::kEntersPassable,
                                Refusal::kFarTooExpensive,
                                Refusal::kBesideOthers,
                                Refusal::kNotWorthTheWay,
                                Refusal::kVersleijenEndsBefore,
                                Refusal::kTooTight,
                                Refusal::kNoRoomBeside,
                                Refusal::kMeetsObstacle,
                                Refusal::kSeveralObstacles,
                                Refusal::kTooWide,
                                Refusal::kVersleijenOtherSide};

TEST(Refusal, EachHasItsOwnSentence) {
  std::set<std::string> sentences;
  for (const Refusal refusal : kReasons) sentences.insert(sentence(refusal));
  EXPECT_EQ(sentences.size(), std::size(kReasons));
  EXPECT_EQ(sentences.count(""), 0u);
  EXPECT_STREQ(sentence(Refusal::kNone), "");
}

/// The section of the page that explains the reasons.
std::string explained_reasons() {
  std::ifstream file(std::string(TRAMLINE_SOURCE_DIR) + "/docs/obstacles.md");
  const std::string page{std::istreambuf_iterator<char>(file), {}};
  const std::size_t from = page.find("## Why a track is cut");
  if (from == std::string::npos) return "";
  return page.substr(from, page.find("\n## ", from + 1) - from);
}

TEST(Refusal, SentencesAreThoseThatThePageExplains) {
  const std::string reasons = explained_reasons();
  ASSERT_FALSE(reasons.empty());
  for (const Refusal refusal : kReasons)
    EXPECT_NE(reasons.find(sentence(refusal)), std::string::npos) << sentence(refusal);
}

}  // namespace
}  // namespace tramline
