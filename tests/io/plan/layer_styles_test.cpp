// The styles that QGIS finds in a plan file: the table as QGIS reads it, and XML it can take.

#include <cpl_string.h>
#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <memory>
#include <pugixml.hpp>
#include <set>
#include <string>

#include "support/temporary_folder.h"
#include "tramline/io/plan/plan_styles.h"
#include "tramline/io/plan/read_plan.h"
#include "tramline/io/plan/write_plan.h"

namespace tramline::io {
namespace {

using testing_support::TemporaryFolder;

namespace fs = std::filesystem;

Plan two_subfields() {
  Plan plan;
  plan.field.id = "plain";
  plan.field.outer = {{0, 0}, {100, 0}, {100, 30}, {0, 30}};
  plan.body = {{plan.field.outer, {}}};
  plan.machine = {"sprayer", 6, 6, 2};
  plan.subfields = {{plan.body[0], Direction::clockwise_from_north(Angle::degrees(90))},
                    {plan.body[0], Direction::clockwise_from_north(Angle::degrees(12.34))}};
  plan.pieces = {{{0, 3}, {100, 3}, 0, 0}};
  return plan;
}

class LayerStyles : public testing::Test {
 protected:
  void SetUp() override {
    setenv("SOURCE_DATE_EPOCH", "1700000000", 1);
    write_plan(two_subfields(), file());
    RegisterOGRGeoPackage();
    data_.reset(GDALDataset::Open(file().c_str(), GDAL_OF_VECTOR));
    ASSERT_NE(data_, nullptr);
    styles_ = data_->GetLayerByName("layer_styles");
    ASSERT_NE(styles_, nullptr);
  }
  void TearDown() override {
    unsetenv("SOURCE_DATE_EPOCH");
    data_.reset();
  }
  fs::path file() const { return folder_ / "plan.gpkg"; }
  TemporaryFolder folder_;
  GDALDatasetUniquePtr data_;
  OGRLayer* styles_ = nullptr;
};

TEST_F(LayerStyles, TheTableIsTheOneQgisMakes) {
  EXPECT_EQ(styles_->GetGeomType(), wkbNone);
  EXPECT_STREQ(styles_->GetFIDColumn(), "id");
  for (const char* column :
       {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName", "styleQML",
        "styleSLD", "useAsDefault", "description", "owner", "ui", "update_time"})
    EXPECT_GE(styles_->GetLayerDefn()->GetFieldIndex(column), 0) << column;
  OGRLayer* contents = data_->ExecuteSQL(
      "SELECT data_type FROM gpkg_contents WHERE table_name = 'layer_styles'", nullptr, "SQLITE");
  ASSERT_NE(contents, nullptr);
  const OGRFeatureUniquePtr row(contents->GetNextFeature());
  ASSERT_NE(row, nullptr);
  EXPECT_STREQ(row->GetFieldAsString(0), "attributes");
  data_->ReleaseResultSet(contents);
}

TEST_F(LayerStyles, EveryLayerWithShapesHasOneDefault) {
  std::multiset<std::string> with_shapes, with_style;
  for (OGRLayer* layer : data_->GetLayers())
    if (layer->GetGeomType() != wkbNone) with_shapes.insert(layer->GetName());
  for (const auto& style : *styles_) {
    with_style.insert(style->GetFieldAsString("f_table_name"));
    EXPECT_STREQ(style->GetFieldAsString("f_geometry_column"), "geom");
    EXPECT_EQ(style->GetFieldAsInteger("useAsDefault"), 1);
    // QGIS asks for f_table_schema = '', which NULL is not.
    EXPECT_TRUE(style->IsFieldSetAndNotNull(style->GetFieldIndex("f_table_schema")));
    EXPECT_STREQ(style->GetFieldAsString("f_table_schema"), "");
    EXPECT_STREQ(style->GetFieldAsString("update_time"), "2023/11/14 22:13:20+00");
  }
  EXPECT_EQ(with_style, with_shapes);
}

TEST_F(LayerStyles, TheFileIsReadAsBefore) { EXPECT_EQ(read_plan(file()).pieces.size(), 1u); }

/// Every property of every symbol layer, inner ones included.
std::multimap<std::string, std::string> properties(const pugi::xml_document& qml) {
  std::multimap<std::string, std::string> out;
  for (const pugi::xpath_node node : qml.select_nodes("//layer/Option/Option"))
    out.emplace(node.node().attribute("name").value(), node.node().attribute("value").value());
  return out;
}

TEST(PlanStyles, AreWellFormedAndEveryRuleHasItsSymbol) {
  const auto styles = styles_of(two_subfields());
  ASSERT_EQ(styles.size(), 14u);
  for (const LayerStyle& style : styles) {
    SCOPED_TRACE(style.layer);
    pugi::xml_document qml;
    ASSERT_TRUE(qml.load_string(style.qml.c_str(), pugi::parse_full));
    EXPECT_EQ(style.qml.substr(0, 14), "<!DOCTYPE qgis");
    const pugi::xml_node renderer = qml.child("qgis").child("renderer-v2");
    ASSERT_TRUE(renderer);
    const pugi::xml_node symbols = renderer.child("symbols");
    ASSERT_TRUE(symbols.child("symbol"));
    for (const pugi::xml_node rule : renderer.child("rules").children("rule"))
      EXPECT_TRUE(symbols.find_child_by_attribute("symbol", "name", rule.attribute("symbol").value()));
    // Versions before 3.18 read the other half.
    EXPECT_EQ(qml.select_nodes("//layer/Option/Option").size(), qml.select_nodes("//layer/prop").size());
  }
}

TEST(PlanStyles, ShowTheColoursOfPictures) {
  std::map<std::string, std::multimap<std::string, std::string>> found;
  for (const LayerStyle& style : styles_of(two_subfields())) {
    pugi::xml_document qml;
    ASSERT_TRUE(qml.load_string(style.qml.c_str()));
    found[style.layer] = properties(qml);
  }
  const auto has = [&](const char* layer, const char* name, const char* value) {
    const auto [first, last] = found[layer].equal_range(name);
    return std::any_of(first, last, [&](const auto& property) { return property.second == value; });
  };
  EXPECT_TRUE(has("overlap", "color", "230,97,0,255"));
  EXPECT_TRUE(has("uncovered", "color", "10,79,214,255"));
  EXPECT_TRUE(has("obstacles", "color", "76,74,72,255"));
  EXPECT_TRUE(has("tracks", "line_color", "58,70,59,217"));
  EXPECT_TRUE(has("tracks", "name", "filled_arrowhead"));
  EXPECT_TRUE(has("tracks", "line_color", "154,15,114,255"));
  EXPECT_TRUE(has("headland", "color", "222,218,207,255"));
  EXPECT_TRUE(has("headland_passes", "line_color", "122,78,29,230"));
  EXPECT_TRUE(has("headland_passes", "name", "filled_arrowhead"));
  EXPECT_TRUE(has("headland_unworked", "color", "10,79,214,255"));
  EXPECT_TRUE(has("subfields", "color", "226,237,213,255"));
  EXPECT_TRUE(has("subfields", "color", "244,234,203,255"));
}

TEST(PlanStyles, SubfieldsAreNamedByTheirDirection) {
  for (const LayerStyle& style : styles_of(two_subfields()))
    if (std::string(style.layer) == "subfields") {
      EXPECT_NE(style.qml.find("label=\"2: 12.3° from north\""), std::string::npos) << style.qml;
    }
}

}  // namespace
}  // namespace tramline::io
