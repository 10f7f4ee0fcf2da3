#include "tramline/io/field/field_styles.h"

#include "tramline/io/field/field_file.h"
#include "tramline/io/geopackage/qml.h"
#include "tramline/model/palette.h"

namespace tramline::io {

using qml::mm;
using qml::Shape;
using qml::Symbol;

LayerStyle obstacles_style() {
  const Symbol obstacle{Shape::kPolygon,
                        {qml::simple_fill(kObstacleColour, kObstacleColour, mm(1.8)),
                         qml::hatch(kObstacleHatch, mm(6), mm(1.4), 45)}};
  const Symbol passable{Shape::kPolygon,
                        {qml::simple_fill(kPassableColour, kPassableHatch, mm(1.4)),
                         qml::hatch(kPassableHatch, mm(7), mm(1.3), 135)}};
  return {
      field_layers::kObstacles, "obstacles and passable strips",
      qml::document(Shape::kPolygon, {{"\"kind\" = 'obstacle'", "obstacle", obstacle},
                                      {"\"kind\" = 'passable'", "passable obstacle, not worked", passable}})};
}

std::vector<LayerStyle> styles_of_field() {
  const Symbol land{Shape::kPolygon, {qml::simple_fill(kFieldColour, kFieldEdge, mm(2.2))}};
  return {{field_layers::kField, "the field", qml::document(land)}, obstacles_style()};
}

}  // namespace tramline::io
