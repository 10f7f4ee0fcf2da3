#pragma once
// The QGIS styles of a field.

#include <string>
#include <vector>

#include "tramline/io/geopackage/layer_styles.h"

namespace tramline::io {

LayerStyle obstacles_style();
/// The styles of a file that holds a single field.
std::vector<LayerStyle> styles_of_field();

}  // namespace tramline::io
