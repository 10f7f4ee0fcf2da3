#pragma once
// How QGIS is to draw a field.

#include <string>
#include <vector>

#include "tramline/io/geopackage/layer_styles.h"

namespace tramline::io {

LayerStyle obstacles_style();
/// Of a file that holds a field alone.
std::vector<LayerStyle> styles_of_field();

}  // namespace tramline::io
