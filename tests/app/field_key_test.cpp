#include "request/field_key.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

Field field(const std::string& id, long long fid, int part) {
  Field out;
  out.id = id;
  out.source.layer = "parcels";
  out.source.fid = fid;
  out.source.part = part;
  return out;
}

TEST(FieldKey, NamesLayerFeatureAndPart) {
  EXPECT_EQ(field_key(field("mill", 17, 0)), "parcels:17");
  EXPECT_EQ(field_key(field("mill#2", 17, 1)), "parcels:17#2");
}

TEST(FieldKey, AFieldIsMeantByItsIdOrItsKeyAndNothingElse) {
  const Field second = field("mill#2", 17, 1);
  EXPECT_TRUE(is_named(second, "mill#2"));
  EXPECT_TRUE(is_named(second, "parcels:17#2"));
  EXPECT_FALSE(is_named(second, "mill"));
  EXPECT_FALSE(is_named(second, "parcels:17"));
}

TEST(FieldKey, AFeatureIsLookedIntoWhereAPartOfItMayBeMeant) {
  for (const char* id : {"mill", "mill#2", "mill#13", "parcels:17", "parcels:17#2"})
    EXPECT_TRUE(may_be_named("mill", "parcels", 17, id)) << id;
  for (const char* id : {"mil", "mill2", "mill#", "mill#a", "parcels:1", "parcels:171", ""})
    EXPECT_FALSE(may_be_named("mill", "parcels", 17, id)) << id;
}

}  // namespace
}  // namespace tramline::app
