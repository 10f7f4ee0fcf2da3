#pragma once
// Styles in QML, the XML that QGIS keeps them in. Sizes are millimetres on the screen or the paper.

#include <string>
#include <utility>
#include <vector>

#include "tramline/model/palette.h"

namespace tramline::io::qml {

enum class Shape { kPoint, kLine, kPolygon };

struct SymbolLayer;

/// Drawn from the first layer to the last.
struct Symbol {
  Shape shape = Shape::kPolygon;  ///< point: a marker, polygon: a fill
  std::vector<SymbolLayer> layers;
};

/// One of QGIS' symbol layers: its class and its properties by QGIS' names.
struct SymbolLayer {
  const char* kind;
  std::vector<std::pair<std::string, std::string>> properties;
  std::vector<Symbol> inner{};  ///< what it repeats: the lines of a pattern, the markers on a line; or none
};

/// What features that match an expression look like. Several rules may match one feature: all are drawn.
struct Rule {
  std::string filter;  ///< an expression of QGIS; empty: every feature
  std::string label;   ///< in the legend
  Symbol symbol;
};

/// Texts about the middle of features, with a rim.
struct Labels {
  std::string filter;  ///< which features; empty: all
  std::string column;  ///< what the text is
  Colour colour;
  Colour rim;
  double size_pt = 10;
};

/// The pictures' pixels, at 96 to the inch.
constexpr double mm(double px) { return px * 25.4 / 96; }

SymbolLayer simple_fill(Colour fill, Colour edge, double edge_mm);
/// An edge and nothing inside. `style`: solid, dash, dot.
SymbolLayer simple_edge(Colour edge, double edge_mm, const char* style = "solid");
SymbolLayer hatch(Colour colour, double spacing_mm, double line_mm, double angle_deg);
/// `style`: solid, dash, dot.
SymbolLayer simple_line(Colour colour, double line_mm, const char* style = "solid");
/// A marker on a line, turned with it. `place`: centralpoint, firstvertex, lastvertex.
SymbolLayer marker_on_line(const char* place, SymbolLayer marker);
/// What an expression of QGIS makes of the feature, drawn with this symbol. Coordinates are the layer's.
SymbolLayer generated(const std::string& expression, Symbol drawn);
/// `name`: circle, filled_arrowhead …
SymbolLayer simple_marker(const char* name, Colour fill, Colour edge, double size_mm);

/// A whole style. Equal rules give equal bytes. Precondition: rules is not empty.
std::string document(Shape shape, const std::vector<Rule>& rules);
std::string document(Shape shape, const std::vector<Rule>& rules, const Labels& labels);
/// The same for every feature.
std::string document(Symbol symbol);

}  // namespace tramline::io::qml
