#pragma once
// Styles in QML, the XML format of QGIS styles. Sizes are millimetres on the screen or the paper.

#include <string>
#include <utility>
#include <vector>

#include "tramline/model/palette.h"

namespace tramline::io::qml {

enum class Shape { kPoint, kLine, kPolygon };

struct SymbolLayer;

/// A symbol; its layers are drawn from the first to the last.
struct Symbol {
  Shape shape = Shape::kPolygon;  ///< point: a marker, polygon: a fill
  std::vector<SymbolLayer> layers;
};

/// One of QGIS' symbol layers: its class and its properties by QGIS' names.
struct SymbolLayer {
  const char* kind;
  std::vector<std::pair<std::string, std::string>> properties;
  /// Symbols that it repeats: the lines of a pattern, the markers on a line; may be empty.
  std::vector<Symbol> inner{};
};

/// The symbol of features that match an expression. Where several rules match one feature, all are drawn.
struct Rule {
  std::string filter;  ///< an expression of QGIS; empty: every feature
  std::string label;   ///< in the legend
  Symbol symbol;
};

/// Texts about the middle of features, with a rim.
struct Labels {
  std::string filter;  ///< expression that selects features; empty: all
  std::string column;  ///< column with the text
  Colour colour;
  Colour rim;
  double size_pt = 10;
};

/// Converts pixels of the pictures, at 96 to the inch, to millimetres.
constexpr double mm(double px) { return px * 25.4 / 96; }

SymbolLayer simple_fill(Colour fill, Colour edge, double edge_mm);
/// An edge without a fill. `style`: solid, dash, dot.
SymbolLayer simple_edge(Colour edge, double edge_mm, const char* style = "solid");
SymbolLayer hatch(Colour colour, double spacing_mm, double line_mm, double angle_deg);
/// `style`: solid, dash, dot.
SymbolLayer simple_line(Colour colour, double line_mm, const char* style = "solid");
/// A marker on a line, turned with it. `place`: centralpoint, firstvertex, lastvertex.
SymbolLayer marker_on_line(const char* place, SymbolLayer marker);
/// The geometry that an expression of QGIS makes of the feature, drawn with this symbol. Coordinates are
/// those of the layer.
SymbolLayer generated(const std::string& expression, Symbol drawn);
/// `name`: circle, filled_arrowhead …
SymbolLayer simple_marker(const char* name, Colour fill, Colour edge, double size_mm);

/// A whole style. Equal rules give equal bytes. Precondition: rules is not empty.
std::string document(Shape shape, const std::vector<Rule>& rules);
std::string document(Shape shape, const std::vector<Rule>& rules, const Labels& labels);
/// The same for every feature.
std::string document(Symbol symbol);

}  // namespace tramline::io::qml
