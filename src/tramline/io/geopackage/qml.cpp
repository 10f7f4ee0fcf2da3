#include "tramline/io/geopackage/qml.h"

#include <fmt/format.h>

#include <cassert>
#include <cmath>
#include <pugixml.hpp>
#include <sstream>

namespace tramline::io::qml {
namespace {

const char* type_of(Shape shape) {
  switch (shape) {
    case Shape::kPoint:
      return "marker";
    case Shape::kLine:
      return "line";
    case Shape::kPolygon:
      return "fill";
  }
  return "";
}

/// "r,g,b,opacity", each from 0 to 255.
std::string text_of(Colour colour) {
  const auto byte = [](double share) { return std::lround(255 * share); };
  return fmt::format("{},{},{},{}", byte(colour.red), byte(colour.green), byte(colour.blue),
                     byte(colour.opacity));
}

std::string text_of(double number) { return fmt::format("{:g}", number); }

/// Twice: newer versions of QGIS read Option, those up to 3.18 prop.
void add_properties(pugi::xml_node layer, const SymbolLayer& from) {
  pugi::xml_node map = layer.append_child("Option");
  map.append_attribute("type") = "Map";
  for (const auto& [name, value] : from.properties) {
    pugi::xml_node option = map.append_child("Option");
    option.append_attribute("type") = "QString";
    option.append_attribute("name") = name.c_str();
    option.append_attribute("value") = value.c_str();
  }
  for (const auto& [name, value] : from.properties) {
    pugi::xml_node prop = layer.append_child("prop");
    prop.append_attribute("k") = name.c_str();
    prop.append_attribute("v") = value.c_str();
  }
}

/// Symbols inside symbols go by the names QGIS gives them: "@0@1" in layer 1 of symbol "0".
void add_symbol(pugi::xml_node parent, const Symbol& symbol, const std::string& name) {
  pugi::xml_node node = parent.append_child("symbol");
  node.append_attribute("type") = type_of(symbol.shape);
  node.append_attribute("name") = name.c_str();
  node.append_attribute("alpha") = "1";
  node.append_attribute("clip_to_extent") = "1";
  node.append_attribute("force_rhr") = "0";
  for (std::size_t i = 0; i < symbol.layers.size(); ++i) {
    const SymbolLayer& from = symbol.layers[i];
    pugi::xml_node layer = node.append_child("layer");
    layer.append_attribute("class") = from.kind;
    layer.append_attribute("enabled") = "1";
    layer.append_attribute("pass") = "0";
    layer.append_attribute("locked") = "0";
    add_properties(layer, from);
    for (const Symbol& inner : from.inner) add_symbol(layer, inner, fmt::format("@{}@{}", name, i));
  }
}

void add_rules(pugi::xml_node renderer, const std::vector<Rule>& rules) {
  pugi::xml_node list = renderer.append_child("rules");
  list.append_attribute("key") = "{rules}";
  for (std::size_t i = 0; i < rules.size(); ++i) {
    pugi::xml_node rule = list.append_child("rule");
    rule.append_attribute("key") = fmt::format("{{rule{}}}", i).c_str();
    rule.append_attribute("symbol") = std::to_string(i).c_str();
    if (!rules[i].filter.empty()) rule.append_attribute("filter") = rules[i].filter.c_str();
    if (!rules[i].label.empty()) rule.append_attribute("label") = rules[i].label.c_str();
  }
}

void add_labels(pugi::xml_node root, const Labels& labels) {
  pugi::xml_node labeling = root.append_child("labeling");
  labeling.append_attribute("type") = "rule-based";
  pugi::xml_node rules = labeling.append_child("rules");
  rules.append_attribute("key") = "{labels}";
  pugi::xml_node rule = rules.append_child("rule");
  rule.append_attribute("key") = "{label0}";
  if (!labels.filter.empty()) rule.append_attribute("filter") = labels.filter.c_str();
  pugi::xml_node settings = rule.append_child("settings");
  pugi::xml_node style = settings.append_child("text-style");
  style.append_attribute("fieldName") = labels.column.c_str();
  style.append_attribute("isExpression") = "0";
  style.append_attribute("fontSize") = labels.size_pt;
  style.append_attribute("fontSizeUnit") = "Point";
  style.append_attribute("fontWeight") = "75";
  style.append_attribute("textColor") = text_of(labels.colour).c_str();
  style.append_attribute("textOpacity") = "1";
  pugi::xml_node buffer = style.append_child("text-buffer");
  buffer.append_attribute("bufferDraw") = "1";
  buffer.append_attribute("bufferSize") = "1";
  buffer.append_attribute("bufferSizeUnits") = "MM";
  buffer.append_attribute("bufferColor") = text_of(labels.rim).c_str();
  buffer.append_attribute("bufferOpacity") = "1";
  pugi::xml_node placement = settings.append_child("placement");
  placement.append_attribute("placement") = "0";
  placement.append_attribute("dist") = "3";
  placement.append_attribute("distUnits") = "MM";
}

/// `labels` may be nullptr.
std::string text_of(Shape shape, const std::vector<Rule>& rules, const Labels* labels) {
  pugi::xml_document out;
  out.append_child(pugi::node_doctype).set_value("qgis PUBLIC 'http://mrcc.com/qgis.dtd' 'SYSTEM'");
  pugi::xml_node root = out.append_child("qgis");
  root.append_attribute("version") = "3.22.0";
  root.append_attribute("styleCategories") = labels == nullptr ? "Symbology" : "Symbology|Labeling";
  if (labels != nullptr) root.append_attribute("labelsEnabled") = "1";
  pugi::xml_node renderer = root.append_child("renderer-v2");
  const bool single = rules.size() == 1 && rules[0].filter.empty();
  renderer.append_attribute("type") = single ? "singleSymbol" : "RuleRenderer";
  renderer.append_attribute("symbollevels") = "0";
  renderer.append_attribute("forceraster") = "0";
  renderer.append_attribute("enableorderby") = "0";
  if (!single) add_rules(renderer, rules);
  pugi::xml_node symbols = renderer.append_child("symbols");
  for (std::size_t i = 0; i < rules.size(); ++i) add_symbol(symbols, rules[i].symbol, std::to_string(i));
  if (labels != nullptr) add_labels(root, *labels);
  root.append_child("layerGeometryType").text() = static_cast<int>(shape);
  std::ostringstream text;
  out.save(text, " ", pugi::format_indent | pugi::format_no_declaration);
  return text.str();
}

}  // namespace

SymbolLayer simple_fill(Colour fill, Colour edge, double edge_mm) {
  return {"SimpleFill",
          {{"color", text_of(fill)},
           {"style", "solid"},
           {"outline_color", text_of(edge)},
           {"outline_style", edge_mm > 0 ? "solid" : "no"},
           {"outline_width", text_of(edge_mm)},
           {"outline_width_unit", "MM"},
           {"joinstyle", "round"}}};
}

SymbolLayer simple_edge(Colour edge, double edge_mm, const char* style) {
  return {"SimpleFill",
          {{"color", "0,0,0,0"},
           {"style", "no"},
           {"outline_color", text_of(edge)},
           {"outline_style", style},
           {"outline_width", text_of(edge_mm)},
           {"outline_width_unit", "MM"},
           {"joinstyle", "round"}}};
}

SymbolLayer hatch(Colour colour, double spacing_mm, double line_mm, double angle_deg) {
  return {"LinePatternFill",
          {{"angle", text_of(angle_deg)},
           {"color", text_of(colour)},
           {"distance", text_of(spacing_mm)},
           {"distance_unit", "MM"},
           {"line_width", text_of(line_mm)},
           {"line_width_unit", "MM"}},
          {{Shape::kLine, {simple_line(colour, line_mm)}}}};
}

SymbolLayer simple_line(Colour colour, double line_mm, const char* style) {
  return {"SimpleLine",
          {{"line_color", text_of(colour)},
           {"line_width", text_of(line_mm)},
           {"line_width_unit", "MM"},
           {"line_style", style},
           {"capstyle", "flat"},
           {"joinstyle", "round"}}};
}

SymbolLayer marker_on_line(const char* place, SymbolLayer marker) {
  return {"MarkerLine", {{"placement", place}, {"rotate", "1"}}, {{Shape::kPoint, {std::move(marker)}}}};
}

SymbolLayer generated(const std::string& expression, Symbol drawn) {
  const char* type = drawn.shape == Shape::kPolygon ? "Fill"
                     : drawn.shape == Shape::kLine  ? "Line"
                                                    : "Marker";
  return {"GeometryGenerator",
          {{"SymbolType", type}, {"geometryModifier", expression}, {"units", "MapUnit"}},
          {std::move(drawn)}};
}

SymbolLayer simple_marker(const char* name, Colour fill, Colour edge, double size_mm) {
  return {"SimpleMarker",
          {{"name", name},
           {"color", text_of(fill)},
           {"outline_color", text_of(edge)},
           {"outline_style", "solid"},
           {"outline_width", "0.2"},
           {"outline_width_unit", "MM"},
           {"size", text_of(size_mm)},
           {"size_unit", "MM"},
           {"angle", "0"}}};
}

std::string document(Shape shape, const std::vector<Rule>& rules) {
  assert(!rules.empty());
  return text_of(shape, rules, nullptr);
}

std::string document(Shape shape, const std::vector<Rule>& rules, const Labels& labels) {
  return text_of(shape, rules, &labels);
}

std::string document(Symbol symbol) {
  const Shape shape = symbol.shape;
  return document(shape, {{"", "", std::move(symbol)}});
}

}  // namespace tramline::io::qml
