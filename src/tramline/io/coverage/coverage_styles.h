#pragma once
// What the layers of a coverage file look like in QGIS: the colours of our own pictures.

#include <vector>

#include "tramline/io/geopackage/layer_styles.h"

namespace tramline::io {

/// A style for each layer with shapes. Field, multiplicity, gaps and track hide nothing in whatever order the
/// layers are added.
std::vector<LayerStyle> coverage_styles();

}  // namespace tramline::io
