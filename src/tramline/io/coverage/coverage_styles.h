#pragma once
// The QGIS styles of the layers of a coverage file, in the colours of tramline's own pictures.

#include <vector>

#include "tramline/io/geopackage/layer_styles.h"

namespace tramline::io {

/// A style for each layer with shapes. Field, multiplicity, gaps and track hide nothing in whatever order the
/// layers are added.
std::vector<LayerStyle> coverage_styles();

}  // namespace tramline::io
