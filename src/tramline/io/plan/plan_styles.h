#pragma once
// The QGIS styles of the layers of a plan file, in the colours of tramline's own pictures.

#include <vector>

#include "tramline/io/geopackage/layer_styles.h"
#include "tramline/model/plan.h"

namespace tramline::io {

/// A style for each layer with shapes. Field, body and swaths hide nothing in whatever order the layers are
/// added: only land that the picture fills is filled. Depends on the subfields, their
/// directions and whether there is a route alone.
std::vector<LayerStyle> styles_of(const Plan& plan);

/// Whether any plan of a file has a route, and so the file the layer of its legs.
enum class Routes { kNone, kSome };

/// The same for the layers of many plans, of which none has more subfields than that. Tracks with detours are
/// marked as a whole: their paths are in the planes of their fields, in which QGIS does not draw them.
std::vector<LayerStyle> styles_of_many(std::size_t most_subfields, Routes routes);

}  // namespace tramline::io
