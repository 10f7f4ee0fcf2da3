#include "report/report_parts.h"

#include <gtest/gtest.h>

namespace tramline::app {
namespace {

TEST(JsonText, HasNoNegativeZero) {
  const nlohmann::ordered_json json{
      {"x", -0.0}, {"list", {-0.0, 1.5, {{"y", -0.0}}}}, {"small", -1e-300}, {"text", "-0"}, {"whole", 0}};
  EXPECT_EQ(json_line(json), R"({"x":0.0,"list":[0.0,1.5,{"y":0.0}],"small":-1e-300,"text":"-0","whole":0})");
}

TEST(Versioned, PutsTheVersionBeforeAllOtherKeys) {
  EXPECT_EQ(json_line(versioned({{"b", 1}, {"a", 2}})), R"({"format_version":1,"b":1,"a":2})");
}

TEST(JsonText, IsIndentedWhereAsked) { EXPECT_EQ(json_text({{"a", 1}}, 2), "{\n  \"a\": 1\n}"); }

}  // namespace
}  // namespace tramline::app
