#pragma once
// What the layers of a plan file look like in QGIS: the colours of our own pictures.

#include <vector>

#include "tramline/io/geopackage/layer_styles.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// A style for each layer with shapes. Field, body and swaths hide nothing in whatever order the layers are
/// added: only land that the picture fills is filled. Depends on the subfields and their directions alone.
std::vector<LayerStyle> styles_of(const Plan& plan);

}  // namespace tramline::io
