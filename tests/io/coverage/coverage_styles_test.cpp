// The styles that QGIS finds in a coverage file.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "tramline/io/coverage/coverage_styles.h"

namespace tramline::io {
namespace {

std::map<std::string, pugi::xml_document> documents() {
  std::map<std::string, pugi::xml_document> out;
  for (const LayerStyle& style : coverage_styles())
    EXPECT_TRUE(out[style.layer].load_string(style.qml.c_str(), pugi::parse_full)) << style.layer;
  return out;
}

bool has(const pugi::xml_document& qml, const std::string& name, const std::string& value) {
  for (const pugi::xpath_node node : qml.select_nodes("//layer/Option/Option"))
    if (node.node().attribute("name").value() == name && node.node().attribute("value").value() == value)
      return true;
  return false;
}

TEST(CoverageStyles, EveryLayerWithShapesHasOneAndEveryRuleItsSymbol) {
  const auto qml = documents();
  std::set<std::string> layers;
  for (const auto& [layer, document] : qml) {
    layers.insert(layer);
    const pugi::xml_node renderer = document.child("qgis").child("renderer-v2");
    ASSERT_TRUE(renderer.child("symbols").child("symbol")) << layer;
    for (const pugi::xml_node rule : renderer.child("rules").children("rule"))
      EXPECT_TRUE(renderer.child("symbols").find_child_by_attribute("symbol", "name",
                                                                    rule.attribute("symbol").value()))
          << layer;
  }
  EXPECT_EQ(layers, (std::set<std::string>{"field", "covered", "repeated", "missed", "not_recorded",
                                           "multiplicity", "gaps", "track"}));
}

TEST(CoverageStyles, ShowTheColoursOfPictures) {
  const auto qml = documents();
  EXPECT_TRUE(has(qml.at("covered"), "color", "191,221,169,255"));
  EXPECT_TRUE(has(qml.at("repeated"), "color", "230,97,0,255"));
  EXPECT_TRUE(has(qml.at("missed"), "color", "10,79,214,255"));
  EXPECT_TRUE(has(qml.at("not_recorded"), "color", "242,197,0,255"));
  EXPECT_TRUE(has(qml.at("track"), "line_color", "38,64,42,191"));
  EXPECT_TRUE(has(qml.at("track"), "line_style", "dash"));
}

/// Layers that lie over others hide nothing: no fill but a clear one.
TEST(CoverageStyles, FieldGapsAndMultiplicityHideNothing) {
  const auto qml = documents();
  for (const char* layer : {"field", "gaps", "multiplicity"})
    for (const pugi::xpath_node node : qml.at(layer).select_nodes("//layer[@class='SimpleFill']/Option")) {
      const std::string colour =
          node.node().find_child_by_attribute("name", "color").attribute("value").value();
      EXPECT_EQ(colour.substr(colour.rfind(',')), ",0") << layer;
    }
}

TEST(CoverageStyles, TheLargestGapsAreNumbered) {
  const auto qml = documents();
  const pugi::xml_node root = qml.at("gaps").child("qgis");
  EXPECT_STREQ(root.attribute("labelsEnabled").value(), "1");
  EXPECT_STREQ(root.attribute("styleCategories").value(), "Symbology|Labeling");
  const pugi::xml_node rule = root.child("labeling").child("rules").child("rule");
  EXPECT_STREQ(rule.attribute("filter").value(), "\"number\" <= 12");
  EXPECT_STREQ(rule.child("settings").child("text-style").attribute("fieldName").value(), "number");
  EXPECT_FALSE(qml.at("covered").child("qgis").attribute("labelsEnabled"));
}

}  // namespace
}  // namespace tramline::io
