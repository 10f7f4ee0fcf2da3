#include "batch/digest.h"

#include <gtest/gtest.h>

#include <fstream>

#include "support/temporary_folder.h"

namespace tramline::app {
namespace {

// The published values of FNV-1a.
TEST(DigestOf, IsThatOfFnv) {
  EXPECT_EQ(digest_of(""), "cbf29ce484222325");
  EXPECT_EQ(digest_of("a"), "af63dc4c8601ec8c");
  EXPECT_EQ(digest_of("foobar"), "85944171f73967e8");
}

TEST(Digest, TakesTextsAndFilesPieceByPiece) {
  const testing_support::TemporaryFolder folder;
  std::ofstream(folder / "bar") << "bar";
  Digest pieces;
  pieces.add("fo");
  pieces.add("o");
  pieces.add_file((folder / "bar").string());
  EXPECT_EQ(pieces.text(), "85944171f73967e8");
  // More than is read at once.
  const std::string large(200'000, 'x');
  std::ofstream(folder / "large") << large;
  Digest whole;
  whole.add_file((folder / "large").string());
  EXPECT_EQ(whole.text(), digest_of(large));
}

}  // namespace
}  // namespace tramline::app
