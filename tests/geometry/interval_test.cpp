#include "tramline/geometry/interval.h"

#include <gtest/gtest.h>

namespace tramline {
namespace {

TEST(Intervals, WithoutCutsTheInside) {
  EXPECT_EQ(without({{0, 10}}, {{2, 3}, {5, 6}}), (Intervals{{0, 2}, {3, 5}, {6, 10}}));
  EXPECT_EQ(without({{0, 10}}, {{-1, 3}}), (Intervals{{3, 10}}));
  EXPECT_EQ(without({{0, 10}}, {{-1, 11}}), Intervals{});
  EXPECT_EQ(without({{0, 4}, {6, 9}}, {{3, 7}}), (Intervals{{0, 3}, {7, 9}}));
  EXPECT_EQ(without({{0, 4}, {6, 9}}, {}), (Intervals{{0, 4}, {6, 9}}));
}

TEST(Intervals, CommonIsTheIntersection) {
  EXPECT_EQ(common({{0, 4}, {6, 9}}, {{3, 7}}), (Intervals{{3, 4}, {6, 7}}));
  EXPECT_EQ(common({{0, 4}}, {{4, 7}}), Intervals{});
}

TEST(Intervals, ComplementIsTheRest) {
  EXPECT_EQ(complement({{1, 2}, {4, 5}}, {0, 6}), (Intervals{{0, 1}, {2, 4}, {5, 6}}));
}

TEST(Intervals, JoinWhereTheyMeet) {
  Intervals set;
  append_joining(set, {0, 1});
  append_joining(set, {1, 2});
  append_joining(set, {3, 4});
  EXPECT_EQ(set, (Intervals{{0, 2}, {3, 4}}));
}

}  // namespace
}  // namespace tramline
