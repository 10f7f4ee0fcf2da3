#include "request/output_names.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

TEST(OutputNames, KeepPlainIds) {
  for (const char* id : {"mill-field", "7", "A_1.b", "_x", "north.40"}) EXPECT_EQ(as_file_name(id), id);
}

TEST(OutputNames, AreNeitherHiddenNorOptionsNorOnlyDashes) {
  EXPECT_EQ(as_file_name(".hidden"), "hidden");
  EXPECT_EQ(as_file_name("-rf"), "rf");
  EXPECT_EQ(as_file_name("../../etc/passwd"), "etc-passwd");
  EXPECT_EQ(as_file_name("Mill field (new)"), "Mill-field--new");
  EXPECT_EQ(as_file_name("Österfeld"), "sterfeld");
  for (const char* id : {"", ".", "..", "---", "/", "///", "поле", "\n"})
    EXPECT_EQ(as_file_name(id), "field") << id;
}

TEST(OutputNames, AreCutWhereTheyStaySane) {
  EXPECT_EQ(as_file_name(std::string(300, 'x')), std::string(80, 'x'));
  EXPECT_EQ(as_file_name(std::string(79, 'x') + "/y"), std::string(79, 'x'));
  EXPECT_EQ(as_file_name(std::string(300, '-') + "end"), "end");
}

TEST(OutputNames, AreHandedOutOnce) {
  OutputNames names("folder/plan.gpkg", Naming::kWithId);
  EXPECT_EQ(names.next("north"), "folder/plan-north.gpkg");
  EXPECT_EQ(names.next("поле"), "folder/plan-field.gpkg");
  EXPECT_EQ(names.next("---"), "folder/plan-field-2.gpkg");
  EXPECT_EQ(OutputNames("folder/plan.gpkg", Naming::kAsGiven).next("---"), "folder/plan.gpkg");
}

}  // namespace
}  // namespace tramline::app
